/* Verdicts and eigenvalues at random equilibria of random tops, many of them close to poles, against data/verdicts.csv: exact
 * matrices, ranks and 400 digits by other software. */
#include "unit/check.h"

#include "analysis/linearization.h"
#include "ext/number.h"
#include "kernel/descriptor.h"
#include "spectrum/exact_point.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 5, PARAMS = 6, COMMAND_EVERY = 40 };

typedef struct {
    char line[4096];
    char *set, *at, *verdict;
    double re[N], im[N];
} reference;

static bool read_reference(reference *r, FILE *file)
{
    char *field;

    do
        if (fgets(r->line, sizeof r->line, file) == NULL) return false;
    while (r->line[0] == '#' || strncmp(r->line, "family;", 7) == 0);
    assert_non_null(strtok(r->line, ";"));
    r->set = strtok(NULL, ";");
    r->at = strtok(NULL, ";");
    r->verdict = strtok(NULL, ";");
    for (int i = 0; i < 2 * N; i++) {
        field = strtok(NULL, ";\n");
        assert_non_null(field);
        *(i % 2 == 0 ? &r->re[i / 2] : &r->im[i / 2]) = strtod(field, NULL);
    }
    return true;
}

/* NAME=FRACTION,... cut up in place. */
static void read_values(jlt_ball_value *values, double *rounded, char *text, const jlt_quantity *quantities, size_t count)
{
    for (size_t i = 0; i < count; i++) values[i] = (jlt_ball_value){ rounded[i], NULL };
    for (char *next, *name = text; name != NULL; name = next) {
        char *value = strchr(name, '=');
        assert_non_null(value);
        *value++ = '\0';
        next = strchr(value, ',');
        if (next != NULL) *next++ = '\0';
        for (size_t i = 0; i < count; i++)
            if (strcmp(quantities[i].name, name) == 0) {
                assert_ok(jlt_number_parse(&rounded[i], value, strlen(value)));
                values[i] = (jlt_ball_value){ rounded[i], value };
            }
    }
}

/* Each value within its own error of one of the reference's, a different one each; the reference is rounded to doubles. */
static void compare_values(const reference *r, const jlt_eigenvalue *values)
{
    bool taken[N] = { false };

    for (int i = 0; i < N; i++) {
        int nearest = -1;
        double distance = INFINITY;
        for (int k = 0; k < N; k++) {
            const double off = hypot(values[i].re - r->re[k], values[i].im - r->im[k]);
            if (!taken[k] && off < distance) nearest = k, distance = off;
        }
        taken[nearest] = true;
        if (distance > values[i].error + ldexp(fabs(r->re[nearest]) + fabs(r->im[nearest]), -52))
            fail_msg("%s %s: eigenvalue %.17g %+.17gi is off by %g, error said to be below %g", r->set, r->at, values[i].re,
                     values[i].im, distance, values[i].error);
    }
}

/* In doubles the verdict is the exact one or open, and so it is in balls without exact numbers; with them it is the exact one, and
 * errors are roundings of the result. */
static void exact_values_give_exact_verdicts(void **unused)
{
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    FILE *file = fopen(JLT_SOURCE_DIR "/tests/reference/data/verdicts.csv", "r");
    const unsigned char given[N] = { 1, 1, 1, 1, 1 };
    jlt_oracle *oracle;
    reference r;
    int compared = 0, proved = 0;

    (void)unused;
    assert_non_null(file);
    assert_ok(jlt_oracle_create(&oracle, d, NULL));
    while (read_reference(&r, file)) {
        jlt_exact_matrix *matrix;
        double params[PARAMS] = { 0 }, x[N] = { 0 };
        jlt_ball_value exact_params[PARAMS], exact_x[N];
        jlt_linearization result;
        read_values(exact_params, params, r.set, d->params, PARAMS);
        read_values(exact_x, x, r.at, d->states, N);
        assert_ok(jlt_linearization_compute(&result, d, params, x, NULL, NULL, NULL));
        if (result.verdict != JLT_UNDECIDED) assert_string_equal(jlt_linearization_verdict(result.verdict), r.verdict);
        const jlt_status alone = jlt_linearization_enclose(&result, d, exact_params, exact_x, NULL, 0);
        assert_true(alone == JLT_OK || alone == JLT_ERR_NO_CONVERGENCE);
        if (alone == JLT_OK && result.proved) proved++;
        if (alone == JLT_OK && result.proved) assert_string_equal(jlt_linearization_verdict(result.verdict), r.verdict);
        assert_ok(jlt_exact_point_linearize(&matrix, oracle, exact_params, exact_x, NULL, given));
        assert_non_null(matrix);
        assert_ok(jlt_linearization_enclose(&result, d, exact_params, exact_x, matrix, 0));
        jlt_exact_matrix_destroy(matrix);
        assert_true(result.proved && result.sure);
        assert_string_equal(jlt_linearization_verdict(result.verdict), r.verdict);
        compare_values(&r, result.eigen.values);
        for (int i = 0; i < N; i++) {
            const jlt_eigenvalue *value = &result.eigen.values[i];
            assert_below(value->error, ldexp(fabs(value->re) + fabs(value->im), -53) * (1 + 1e-9));
        }
        compared++;
    }
    fclose(file);
    jlt_oracle_destroy(oracle);
    print_message("%d of %d verdicts proved without exact numbers\n", proved, compared);
    assert_true(compared >= 400 && proved >= 300);
}

static void the_command_takes_values_exactly(void **unused)
{
    FILE *file = fopen(JLT_SOURCE_DIR "/tests/reference/data/verdicts.csv", "r");
    reference r;

    (void)unused;
    assert_non_null(file);
    for (int row = 0; read_reference(&r, file); row++) {
        char command[4096];
        json_error_t error;
        if (row % COMMAND_EVERY != 0) continue;
        snprintf(command, sizeof command, "jellett eigen --json --set %s --at %s", r.set, r.at);
        FILE *const pipe = popen(command, "r");
        assert_non_null(pipe);
        json_t *const report = json_loadf(pipe, 0, &error);
        if (pclose(pipe) != 0 || report == NULL) fail_msg("%s: no report (%s)", command, error.text);
        assert_string_equal(json_string_value(json_object_get(report, "verdict")), r.verdict);
        json_decref(report);
    }
    fclose(file);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_values_give_exact_verdicts),
        cmocka_unit_test(the_command_takes_values_exactly),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
