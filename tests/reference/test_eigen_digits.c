/* `jellett eigen` at near-degenerate equilibria against data/eigen_digits.csv, 60 digits by other software: every decimal of
 * --digits is the reference's, every double the nearest one to it, and every verdict is proved. */
#include "unit/check.h"

#include "ext/number.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum { N_MAX = 6 };

typedef struct {
    char line[8192];
    char *title, *options, *verdict, *re[N_MAX], *im[N_MAX];
    size_t n;
} reference;

static bool read_reference(reference *r, FILE *file)
{
    char *field;

    do
        if (fgets(r->line, sizeof r->line, file) == NULL) return false;
    while (r->line[0] == '#');
    r->title = strtok(r->line, ";");
    r->options = strtok(NULL, ";");
    r->verdict = strtok(NULL, ";");
    assert_non_null(r->verdict);
    for (r->n = 0; (field = strtok(NULL, ";\n")) != NULL; r->n++) {
        assert_true(r->n < N_MAX);
        r->re[r->n] = field;
        r->im[r->n] = strtok(NULL, ";\n");
        assert_non_null(r->im[r->n]);
    }
    return true;
}

static json_t *report_of(const reference *r, const char *more)
{
    char command[1024];
    json_error_t error;
    json_t *report;
    FILE *pipe;

    snprintf(command, sizeof command, "jellett eigen %s --json %s", r->options, more);
    pipe = popen(command, "r");
    assert_non_null(pipe);
    report = json_loadf(pipe, 0, &error);
    if (pclose(pipe) != 0 || report == NULL) fail_msg("%s: no report (%s)", command, error.text);
    assert_string_equal(json_string_value(json_object_get(report, "verdict")), r->verdict);
    assert_true(json_is_true(json_object_get(report, "verdict_proved")));
    return report;
}

/* The same number, digit by digit: decimals are exact fractions. */
static bool same_decimal(const char *a, const char *b)
{
    char *left, *right;
    bool same;

    assert_ok(jlt_number_fraction(&left, a, strlen(a)));
    assert_ok(jlt_number_fraction(&right, b, strlen(b)));
    same = strcmp(left, right) == 0;
    free(left);
    free(right);
    return same;
}

static bool same_double(double a, const char *b)
{
    return !(a < strtod(b, NULL)) && !(a > strtod(b, NULL));
}

static void compare_decimals(const reference *r)
{
    json_t *report = report_of(r, "--digits 60"), *decimals = json_object_get(report, "decimals");
    bool taken[N_MAX] = { false };

    assert_true(json_is_true(json_object_get(decimals, "sure")));
    assert_int_equal(json_array_size(json_object_get(decimals, "re")), r->n);
    for (size_t i = 0; i < r->n; i++) {
        const char *re = json_string_value(json_array_get(json_object_get(decimals, "re"), i));
        const char *im = json_string_value(json_array_get(json_object_get(decimals, "im"), i));
        size_t k = 0;
        while (k < r->n && (taken[k] || !same_decimal(re, r->re[k]) || !same_decimal(im, r->im[k]))) k++;
        if (k == r->n) fail_msg("%s: %s %si is not in the reference", r->title, re, im);
        taken[k] = true;
    }
    json_decref(report);
}

static void compare_doubles(const reference *r)
{
    json_t *report = report_of(r, ""), *values = json_object_get(report, "eigenvalues");
    bool taken[N_MAX] = { false };

    assert_int_equal(json_array_size(values), r->n);
    for (size_t i = 0; i < r->n; i++) {
        const double re = json_number_value(json_object_get(json_array_get(values, i), "re"));
        const double im = json_number_value(json_object_get(json_array_get(values, i), "im"));
        size_t k = 0;
        while (k < r->n && (taken[k] || !same_double(re, r->re[k]) || !same_double(im, r->im[k]))) k++;
        if (k == r->n) fail_msg("%s: %.17g %+.17gi is not in the reference", r->title, re, im);
        taken[k] = true;
    }
    json_decref(report);
}

static void every_digit_is_the_reference_s(void **unused)
{
    FILE *file = fopen(JLT_SOURCE_DIR "/tests/reference/data/eigen_digits.csv", "r");
    reference r;
    int compared = 0;

    (void)unused;
    assert_non_null(file);
    while (read_reference(&r, file)) {
        compare_decimals(&r);
        compare_doubles(&r);
        compared++;
    }
    fclose(file);
    assert_true(compared >= 24);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(every_digit_is_the_reference_s) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
