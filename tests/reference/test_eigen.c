/* Reports of `jellett eigen` against eigenvalues computed with 160 digits by other software (data/eigen.csv). */
#include "unit/check.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 5, FIELDS = 4 + 2 * N };

typedef struct {
    char *field[FIELDS];
    double trace, re[N], im[N];
} reference;

static bool read_reference(reference *r, char *line)
{
    for (int i = 0; i < FIELDS; i++) {
        r->field[i] = line;
        if (line == NULL) return false;
        line = strchr(line, ';');
        if (line != NULL) *line++ = '\0';
    }
    r->trace = strtod(r->field[3], NULL);
    for (int i = 0; i < N; i++) {
        r->re[i] = strtod(r->field[4 + 2 * i], NULL);
        r->im[i] = strtod(r->field[5 + 2 * i], NULL);
    }
    return true;
}

static json_t *report_of(const reference *r)
{
    char command[1024];
    json_error_t error;
    json_t *report;
    FILE *pipe;

    snprintf(command, sizeof command, "jellett eigen --json --set %s --at %s", r->field[1], r->field[2]);
    pipe = popen(command, "r");
    assert_non_null(pipe);
    report = json_loadf(pipe, 0, &error);
    if (pclose(pipe) != 0 || report == NULL) fail_msg("%s: no report (%s)", command, error.text);
    return report;
}

static double number(const json_t *object, const char *key)
{
    return json_number_value(json_object_get(object, key));
}

/* The reference's digits are rounded to doubles here: half an ulp of slack. */
static double slack(double value)
{
    return ldexp(fabs(value), -53);
}

static void compare(const reference *r)
{
    json_t *report = report_of(r), *values = json_object_get(report, "eigenvalues");
    bool taken[N] = { false };

    assert_int_equal(json_array_size(values), N);
    if (fabs(number(report, "trace") - r->trace) > number(report, "trace_error") + slack(r->trace))
        fail_msg("%s: trace %.17g, reference %.17g, error said to be below %g", r->field[0], number(report, "trace"),
                 r->trace, number(report, "trace_error"));
    for (size_t i = 0; i < N; i++) {
        const json_t *value = json_array_get(values, i);
        const double re = number(value, "re"), im = number(value, "im"), error = number(value, "error");
        size_t nearest = N;
        for (size_t k = 0; k < N; k++)
            if (!taken[k] && (nearest == N || hypot(re - r->re[k], im - r->im[k]) <
                                                  hypot(re - r->re[nearest], im - r->im[nearest])))
                nearest = k;
        taken[nearest] = true;
        const double distance = hypot(re - r->re[nearest], im - r->im[nearest]);
        if (distance > error + slack(r->re[nearest]) + slack(r->im[nearest]))
            fail_msg("%s: eigenvalue %.17g %+.17gi, reference %.17g %+.17gi: off by %g, error said to be below %g",
                     r->field[0], re, im, r->re[nearest], r->im[nearest], distance, error);
        if (json_is_string(json_object_get(value, "integral")) && (re != 0.0 || im != 0.0 || error != 0.0))
            fail_msg("%s: a zero eigenvalue of the integrals is not exactly zero", r->field[0]);
    }
    json_decref(report);
}

/* Oracle: data/eigen.csv, 50 digits, whose generator typed (3.2) in by itself. Tolerance: the error that each eigenvalue is
 * reported with. */
static void eigenvalues_equal_the_reference_within_the_reported_error(void **unused)
{
    FILE *file = fopen(JLT_SOURCE_DIR "/tests/reference/data/eigen.csv", "r");
    char line[8192];
    int compared = 0;

    (void)unused;
    assert_non_null(file);
    while (fgets(line, sizeof line, file) != NULL) {
        reference r = { .field = { NULL } };
        if (line[0] == '#' || strncmp(line, "title;", 6) == 0) continue;
        assert_true(read_reference(&r, line));
        compare(&r);
        compared++;
    }
    fclose(file);
    assert_true(compared >= 20);
}

/* A bound that is always huge would pass the test above. At well-conditioned points with exact values it must be a few
 * rounding units, and stay relative to the eigenvalue where a general solver's is relative to the matrix. */
static void reported_errors_are_small_where_they_can_be(void **unused)
{
    static const struct {
        const char *set, *at;
        double relative; /* error of each nonzero eigenvalue, relative to itself */
    } cases[] = {
        { "a3=0,I1=1/2,I3=1/4", "gamma3=1/4,v_nu=1,omega3=2", 1e-15 },
        { "a3=0,I1=1/2,I3=1/4", "gamma3=1/4,v_nu=1,omega3=0", 1e-15 },
        { "a3=0,I1=1/2,I3=1/4", "gamma3=1/4,v_nu=1,omega3=1e-8", 4e-15 },
        { "a3=0,I1=1/2,I3=1/4", "gamma3=1/4,v_nu=1,omega3=1e-60", 4e-15 },
    };
    reference r = { .field = { "", NULL, NULL } };

    (void)unused;
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        char set[128], at[128];
        snprintf(set, sizeof set, "%s", cases[c].set);
        snprintf(at, sizeof at, "%s", cases[c].at);
        r.field[1] = set;
        r.field[2] = at;
        json_t *report = report_of(&r), *values = json_object_get(report, "eigenvalues");
        for (size_t i = 0; i < N; i++) {
            const json_t *value = json_array_get(values, i);
            const double size = hypot(number(value, "re"), number(value, "im"));
            if (number(value, "error") > cases[c].relative * size)
                fail_msg("%s: error %g of an eigenvalue of size %g", at, number(value, "error"), size);
        }
        json_decref(report);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eigenvalues_equal_the_reference_within_the_reported_error),
        cmocka_unit_test(reported_errors_are_small_where_they_can_be),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
