/* Numbers have points whatever locale the program that calls the library has set, and that locale stays. */
#include "unit/check.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "cli/job.h"
#include "core/digits.h"
#include "core/random.h"
#include "ext/number.h"
#include "report/csv.h"
#include "report/decimal.h"
#include "report/json.h"

static void a_row_has_points_and_as_many_digits_as_it_needs(void **unused)
{
    const double values[] = { 0.1, -2.5e-7, 1.0 / 3, 8.41, 1e22, NAN, 5e-324, INFINITY };
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);

    (void)unused;
    jlt_csv_row(stream, values, sizeof values / sizeof *values);
    fclose(stream);
    assert_string_equal(text, "0.1,-2.5e-07,0.3333333333333333,8.41,1e+22,,5e-324,\n");
    free(text);
}

static void a_header_has_points(void **unused)
{
    const jlt_quantity names[] = { { .name = "a" }, { .name = "b" } };
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);

    (void)unused;
    jlt_decimal_write_named(stream, names, (const double[]){ 0.51, 1.0 / 3 }, 2);
    fclose(stream);
    assert_string_equal(text, " a=0.51 b=0.3333333333333333");
    free(text);
}

/* A text of an error is a bound too: it is never below the error, and about a tenth above at most. */
static void an_error_is_rounded_up(void **unused)
{
    (void)unused;
    for (int i = 0; i < 2000; i++) {
        const double error = i == 0 ? 5e-324 : pow(10, -320 + i / 4.0);
        char *text = NULL;
        size_t size = 0;
        double said = 0;
        FILE *stream = open_memstream(&text, &size);
        jlt_decimal_write_error(stream, error);
        fclose(stream);
        assert_true(strncmp(text, "error < ", 8) == 0);
        assert_ok(jlt_number_parse(&said, text + 8, strlen(text + 8)));
        assert_true(said > error && said < 1.11 * fmax(error, DBL_MIN));
        free(text);
    }
}

static void json_has_points_and_the_fewest_digits(void **unused)
{
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);

    (void)unused;
    const double values[] = { 0.5, 9.81, -1.0 / 3, 2, 1e-12, 1.5e22, 5e-324 };
    assert_ok(jlt_json_write(stream, json_pack("{s:s, s:o}", "typed \\\" 9.8100000000000005", "\" g=9.8100000000000005 \\",
                                               "numbers", jlt_json_numbers(values, 7))));
    fclose(stream);
    assert_string_equal(text, "{\n  \"typed \\\\\\\" 9.8100000000000005\": \"\\\" g=9.8100000000000005 \\\\\",\n"
                              "  \"numbers\": [\n"
                              "    0.5,\n    9.81,\n    -0.3333333333333333,\n    2.0,\n"
                              "    1e-12,\n    1.5e+22,\n    5e-324\n  ]\n}\n");
    free(text);
}

static void numbers_with_points_are_read(void **unused)
{
    double value = 0;

    (void)unused;
    assert_ok(jlt_number_parse(&value, "-0.51", 5));
    assert_near(value, -0.51, 0);
    assert_int_equal(jlt_number_parse(&value, "0,51", 4), JLT_ERR_ARG);
}

static void scenes_are_read(void **unused)
{
    static const char text[] = "model = \"spherical_top\"; parameters = { a3 = 0.51; };\n"
                               "compute = ( { what = \"simulate\"; start = { gamma3 = 0.1; }; times = ( 0, 2.5 ); } );\n";
    char path[] = "/tmp/jellett_locale_XXXXXX", message[JLT_SCENE_MESSAGE_MAX] = "";
    const int descriptor = mkstemp(path);
    jlt_scene *scene = NULL;

    (void)unused;
    assert_true(descriptor >= 0);
    assert_int_equal(write(descriptor, text, strlen(text)), (ssize_t)strlen(text));
    close(descriptor);
    const jlt_status st = jlt_scene_read(&scene, message, path, &jlt_job_program);
    unlink(path);
    assert_string_equal(message, "");
    assert_ok(st);
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "set"), "a3=0.51");
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "times"), "0,2.5");
    jlt_scene_destroy(scene);
}

/* Oracle: one digit more until they read back, in "C", as what was told must; in the form that at least fifteen have. */
static int fewest_by_trial(char *text, const char *told, double value)
{
    const locale_t before = uselocale(newlocale(LC_ALL_MASK, "C", (locale_t)0));
    int digits = 1;

    for (; digits <= 17; digits++) {
        snprintf(text, JLT_DIGITS_SIZE, "%.*g", digits, value);
        if (strtod(text, NULL) == value) break;
    }
    snprintf(text, JLT_DIGITS_SIZE, "%.*g", digits > 15 || fabs(value) < 1e-290 ? digits : 15, value);
    assert_true(strtod(told, NULL) == value);
    freelocale(uselocale(before));
    return digits;
}

static int count_digits(const char *text)
{
    int count = 0, zeros = 0;

    for (; *text != '\0' && *text != 'e'; text++) {
        if (*text < '0' || *text > '9' || (count == 0 && *text == '0')) continue;
        count++;
        zeros = *text == '0' ? zeros + 1 : 0;
    }
    return count - zeros;
}

/* Of every magnitude, subnormals as well; what people type, k/10^n; and its neighbours, which look like it. Above a power of two
 * doubles are twice as far apart as below, and the nearest decimal need not read back where another one does, with a digit less. */
static void digits_are_as_few_as_read_back(void **unused)
{
    jlt_random random;
    char text[JLT_DIGITS_SIZE], expected[JLT_DIGITS_SIZE];
    double back = NAN;
    int exponent;

    (void)unused;
    jlt_random_seed(&random, 1);
    for (int i = 0; i < 30000; i++) {
        const double typed = floor(jlt_random_between(&random, -1e6, 1e6)) / pow(10, i % 7);
        const double any = ldexp(jlt_random_between(&random, -1, 1), i % 2090 - 1074);
        const double whole = floor(jlt_random_magnitude(&random, 0, 19)), power = ldexp(1, i % 2090 - 1074);
        const double values[] = { typed, any, nextafter(typed, 9e9), whole, power };
        for (size_t k = 0; k < sizeof values / sizeof *values; k++) {
            jlt_digits_shortest(text, values[k]);
            const int digits = fewest_by_trial(expected, text, values[k]);
            if (values[k] != 0) assert_true(count_digits(text) <= digits);
            assert_true(jlt_digits_read(&back, text, text + strlen(text)) && back == values[k]);
            if (fabs(frexp(values[k], &exponent)) != 0.5) assert_string_equal(text, expected);
        }
    }
}

static void what_is_no_number_leaves_the_value(void **unused)
{
    static const char *const texts[] = { "", "-", "+1", " 1", "1 ", "1e", "1,5", "0x1p3", "1e400", "1e-400" };
    double value = 7;

    (void)unused;
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++)
        assert_false(jlt_digits_read(&value, texts[k], texts[k] + strlen(texts[k])) || value != 7);
}

/* A machine that has no locale with commas gets one for this run, by the program that comes with the C library. */
static bool set_commas(char *folder)
{
    char command[200];

    if (setlocale(LC_ALL, "de_DE.UTF-8") != NULL) return true;
    if (mkdtemp(folder) == NULL) return false;
    snprintf(command, sizeof command, "localedef -i de_DE -f UTF-8 %s/de_DE.UTF-8 > %s/said 2>&1", folder, folder);
    return system(command) == 0 && setenv("LOCPATH", folder, 1) == 0 && setlocale(LC_ALL, "de_DE.UTF-8") != NULL;
}

static void remove_folder(const char *folder)
{
    char command[100];

    snprintf(command, sizeof command, "rm -rf %s", folder);
    if (system(command) != 0) fprintf(stderr, "%s is left behind\n", folder);
}

int main(void)
{
    char folder[] = "/tmp/jellett_locales_XXXXXX";
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_row_has_points_and_as_many_digits_as_it_needs),
        cmocka_unit_test(a_header_has_points),
        cmocka_unit_test(an_error_is_rounded_up),
        cmocka_unit_test(json_has_points_and_the_fewest_digits),
        cmocka_unit_test(numbers_with_points_are_read),
        cmocka_unit_test(scenes_are_read),
        cmocka_unit_test(digits_are_as_few_as_read_back),
        cmocka_unit_test(what_is_no_number_leaves_the_value),
    };
    int failed = cmocka_run_group_tests_name("C", tests, NULL, NULL);

    const bool commas = set_commas(folder);
    if (strstr(folder, "XXXXXX") == NULL) remove_folder(folder);
    if (!commas) {
        fprintf(stderr,
                "the locale de_DE.UTF-8 is missing, and localedef does not make it: numbers were tested in the locale C alone\n");
        return failed != 0 ? failed : 77;
    }
    failed += cmocka_run_group_tests_name("de_DE.UTF-8", tests, NULL, NULL);
    if (strcmp(localeconv()->decimal_point, ",") != 0 || strcmp(setlocale(LC_ALL, NULL), "de_DE.UTF-8") != 0) {
        fprintf(stderr, "the caller's locale has changed\n");
        failed++;
    }
    return failed;
}
