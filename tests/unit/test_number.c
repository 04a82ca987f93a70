/* Exact numbers: what is typed is rounded once, correctly, and what is no number is refused. */
#include "unit/check.h"

#include "core/random.h"
#include "ext/number.h"

#include <stdio.h>
#include <stdlib.h>

static jlt_status parse(double *value, const char *text)
{
    return jlt_number_parse(value, text, strlen(text));
}

/* Oracle: the C library's strtod, which glibc rounds correctly. */
static void decimals_are_rounded_like_strtod(void **unused)
{
    jlt_random random;

    (void)unused;
    jlt_random_seed(&random, 5);
    for (int i = 0; i < 20000; i++) {
        char text[80];
        double value = 0.0;
        const int digits = 1 + (int)jlt_random_below(&random, 30), exponent = (int)jlt_random_below(&random, 600) - 300;
        size_t at = 0;
        if (jlt_random_below(&random, 2) == 0) text[at++] = '-';
        for (int k = 0; k < digits; k++) {
            text[at++] = (char)('0' + jlt_random_below(&random, 10));
            if (k == digits / 2) text[at++] = '.';
        }
        text[at++] = 'e';
        snprintf(text + at, sizeof text - at, "%d", exponent);
        const double expected = strtod(text, NULL);
        const jlt_status st = parse(&value, text);
        if (expected != 0.0 && !isnormal(expected)) assert_int_equal(st, JLT_ERR_NONFINITE);
        else if (st != JLT_OK || value != expected) fail_msg("%s: %a, not %a (status %d)", text, value, expected, st);
    }
}

/* Oracle: IEEE division, which is correctly rounded when both sides are exact. */
static void fractions_are_rounded_like_one_division(void **unused)
{
    jlt_random random;

    (void)unused;
    jlt_random_seed(&random, 6);
    for (int i = 0; i < 20000; i++) {
        char text[64];
        double value = 0.0;
        const uint64_t p = jlt_random_bits(&random) >> (11 + jlt_random_below(&random, 40));
        const uint64_t q = 1 + (jlt_random_bits(&random) >> (11 + jlt_random_below(&random, 40)));
        snprintf(text, sizeof text, "%llu/%llu", (unsigned long long)p, (unsigned long long)q);
        assert_int_equal(parse(&value, text), JLT_OK);
        assert_true(value == (double)p / (double)q);
    }
}

/* Ties, by hand: 2^53 + 1 lies halfway between its neighbours and goes to the even one. */
static void ties_go_to_even(void **unused)
{
    double value = 0.0;

    (void)unused;
    assert_int_equal(parse(&value, "9007199254740993"), JLT_OK);
    assert_true(value == 9007199254740992.0);
    assert_int_equal(parse(&value, "9007199254740995"), JLT_OK);
    assert_true(value == 9007199254740996.0);
    assert_int_equal(parse(&value, "9007199254740993.000000000000000000000000000000000001"), JLT_OK);
    assert_true(value == 9007199254740994.0);
    assert_int_equal(parse(&value, "18014398509481986/2"), JLT_OK);
    assert_true(value == 9007199254740992.0);
    assert_int_equal(parse(&value, "-0.51"), JLT_OK);
    assert_true(value == -0.51);
}

static void what_is_no_finite_normal_number_is_refused(void **unused)
{
    static const char *const wrong[] = { "",     "-",     "+",     ".",     "e5",   "1e",    "1e+",  "nan",   "inf",     "-inf",
                                         "1/0",  "1/",    "/2",    "1//2",  "1/2/3", "1 ",   " 1",   "0x1p3", "1,5",     "--1",
                                         "1/-2", "1e99999", "1.2.3", "1f",  "٣",    "2pi",   "pi2",  "pip",   "*pi",     "/pi",
                                         "pi/",  "pi/0",  "++pi",  "2*-pi", "p",    "1e309*pip", "1e309*pi/0",
                                         "pi/2/2", "2*pi/3/5", "pi/-2", "pi/+2" };
    static const char *const outside[] = { "1e309", "-1e309", "1e-308", "1e-400", "1e308/1e-308", "1e4000", "1e-4000",
                                           "1e308*pi", "1e309*pi", "1e-308*pi/1e9", "pi/1e309", "1e-309*pi" };
    double value = 42.0;
    char longest[JLT_NUMBER_LENGTH_MAX + 2];

    (void)unused;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        if (parse(&value, wrong[i]) != JLT_ERR_ARG) fail_msg("'%s' was taken for a number", wrong[i]);
    for (size_t i = 0; i < sizeof outside / sizeof *outside; i++)
        if (parse(&value, outside[i]) != JLT_ERR_NONFINITE) fail_msg("'%s' was not refused for its size", outside[i]);
    memset(longest, '1', sizeof longest);
    assert_int_equal(jlt_number_parse(&value, longest, sizeof longest), JLT_ERR_ARG);
    assert_true(value == 42.0);
}

/* A multiple of pi is one double, in decimals as in fractions. */
static void multiples_of_pi_are_numbers(void **unused)
{
    static const double pi = 3.14159265358979323846;
    const struct {
        const char *text;
        double value;
    } cases[] = { { "pi", pi },         { "-pi", -pi },           { "+pi", pi },   { "2*pi", 2 * pi }, { "-2*pi/3", -2 * pi / 3 },
                  { "pi/2", pi / 2 },   { "1/3*pi", pi / 3 },     { "0*pi", 0 },   { "1e-300*pi", 1e-300 * pi },
                  { "0.5*pi/1e3", 0.5 * pi / 1e3 }, { "1e300*pi", 1e300 * pi } };

    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double value = 0.0, again = 0.0;
        char *fraction = NULL;
        if (parse(&value, cases[i].text) != JLT_OK || fabs(value - cases[i].value) > 2e-16 * fabs(value))
            fail_msg("%s: %a, not %a", cases[i].text, value, cases[i].value);
        assert_int_equal(jlt_number_fraction(&fraction, cases[i].text, strlen(cases[i].text)), JLT_OK);
        assert_int_equal(parse(&again, fraction), JLT_OK);
        assert_true(again == value);
        free(fraction);
    }
}

/* Oracle: IEEE division, which is correctly rounded when both sides are exact. */
static void multiples_begin_anywhere(void **unused)
{
    double values[3];

    (void)unused;
    for (size_t first = 0; first < 1000000; first += 99991) {
        assert_ok(jlt_number_multiples(values, "0.07", 4, 3, first, 3));
        for (size_t k = 0; k < 3; k++) assert_true(values[k] == (double)(7 * (first + k)) / 300);
    }
    assert_int_equal(jlt_number_multiples(values, "0.07", 4, 0, 0, 3), JLT_ERR_ARG);
}

static void fractions_are_kept_exactly(void **unused)
{
    static const char *const pairs[][2] = {
        { "0.51", "51/100" }, { "-1/3", "-1/3" }, { "2/6", "1/3" }, { "1e3", "1000" }, { "0.5/0.25e1", "1/5" }, { "0", "0" },
    };

    (void)unused;
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        char *fraction = NULL;
        assert_int_equal(jlt_number_fraction(&fraction, pairs[i][0], strlen(pairs[i][0])), JLT_OK);
        assert_string_equal(fraction, pairs[i][1]);
        free(fraction);
    }
}

/* What stands behind the length is another's. */
static void no_character_beyond_the_length_is_read(void **unused)
{
    (void)unused;
    double value = 0;
    assert_int_equal(jlt_number_parse(&value, "123456", 3), JLT_OK);
    assert_true(value == 123);
    assert_int_equal(jlt_number_parse(&value, "1.256", 3), JLT_OK);
    assert_true(value == 1.2);
    assert_int_equal(jlt_number_parse(&value, "1e23", 3), JLT_OK);
    assert_true(value == 100);
    assert_int_equal(jlt_number_parse(&value, "1/23", 3), JLT_OK);
    assert_true(value == 0.5);
    assert_int_equal(jlt_number_parse(&value, "1e5", 2), JLT_ERR_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(decimals_are_rounded_like_strtod),
        cmocka_unit_test(fractions_are_rounded_like_one_division),
        cmocka_unit_test(ties_go_to_even),
        cmocka_unit_test(what_is_no_finite_normal_number_is_refused),
        cmocka_unit_test(multiples_of_pi_are_numbers),
        cmocka_unit_test(multiples_begin_anywhere),
        cmocka_unit_test(fractions_are_kept_exactly),
        cmocka_unit_test(no_character_beyond_the_length_is_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
