/* Interval arithmetic by ends against exact rational arithmetic: results contain what the operations give at points, and signs that
 * hold everywhere are kept. Balls and bounds as certificates write them contain what they were written from. */
#include "unit/check.h"

#include "validated/numerals.h"
#include "validated/range.h"
#include "validated/shown.h"

#include <flint/fmpq.h>

enum { BITS = 24, ROUNDS = 2000, POINTS = 4 }; /* so few bits that most results are rounded */

static flint_rand_t dice;

static void random_fraction(fmpq_t out)
{
    fmpq_set_si(out, (slong)n_randint(dice, 2001) - 1000, 1 + n_randint(dice, 999));
}

/* A range with points of it, the ends among them; one in eight is a point. */
static void random_range(jlt_range *out, fmpq *points)
{
    random_fraction(&points[0]);
    random_fraction(&points[1]);
    if (n_randint(dice, 8) == 0) fmpq_set(&points[1], &points[0]);
    if (fmpq_cmp(&points[0], &points[1]) > 0) fmpq_swap(&points[0], &points[1]);
    for (unsigned i = 2; i < POINTS; i++) { /* a convex combination */
        fmpq_t share, rest;
        fmpq_init(share);
        fmpq_init(rest);
        fmpq_set_si(share, (slong)n_randint(dice, 101), 100);
        fmpq_sub(rest, &points[1], &points[0]);
        fmpq_mul(rest, rest, share);
        fmpq_add(&points[i], &points[0], rest);
        fmpq_clear(share);
        fmpq_clear(rest);
    }
    jlt_range_set_fractions(out, &points[0], &points[1], BITS);
}

static bool contains(const jlt_range *a, const fmpq_t x)
{
    fmpq_t end;
    bool good;

    fmpq_init(end);
    arf_get_fmpq(end, a->low);
    good = fmpq_cmp(end, x) <= 0;
    arf_get_fmpq(end, a->high);
    good = good && fmpq_cmp(x, end) <= 0;
    fmpq_clear(end);
    return good;
}

static void results_contain_those_at_points(void **unused)
{
    fmpq x[POINTS], y[POINTS];
    jlt_range a, b, out;
    fmpq_t exact;

    (void)unused;
    for (unsigned i = 0; i < POINTS; i++) {
        fmpq_init(&x[i]);
        fmpq_init(&y[i]);
    }
    jlt_range_init(&a);
    jlt_range_init(&b);
    jlt_range_init(&out);
    fmpq_init(exact);
    for (unsigned round = 0; round < ROUNDS; round++) {
        const unsigned exponent = (unsigned)n_randint(dice, 6);
        random_range(&a, x);
        random_range(&b, y);
        for (unsigned i = 0; i < POINTS * POINTS; i++) {
            const fmpq *p = &x[i % POINTS], *q = &y[i / POINTS];
            jlt_range_add(&out, &a, &b, BITS);
            fmpq_add(exact, p, q);
            assert_true(contains(&out, exact));
            jlt_range_multiply(&out, &a, &b, BITS);
            fmpq_mul(exact, p, q);
            assert_true(contains(&out, exact));
            jlt_range_power(&out, &a, exponent, BITS);
            fmpq_pow_si(exact, p, (slong)exponent);
            assert_true(contains(&out, exact));
            if (jlt_range_invert(&out, &b, BITS)) {
                fmpq_inv(exact, q);
                assert_true(contains(&out, exact));
            } else assert_true(fmpq_sgn(&y[0]) <= 0 && fmpq_sgn(&y[1]) >= 0);
            if (jlt_range_root(&out, &a, BITS)) {
                jlt_range_power(&out, &out, 2, 4 * BITS);
                assert_true(contains(&out, p));
            } else assert_true(fmpq_sgn(&x[0]) < 0);
        }
    }
    for (unsigned i = 0; i < POINTS; i++) {
        fmpq_clear(&x[i]);
        fmpq_clear(&y[i]);
    }
    jlt_range_clear(&a);
    jlt_range_clear(&b);
    jlt_range_clear(&out);
    fmpq_clear(exact);
}

/* (1/5 .. 1)^8 begins at 5^-8; a ball of Arb around it begins below 0. The square of -1 .. 2 is 0 .. 4. */
static void signs_and_squares_are_sharp(void **unused)
{
    jlt_range a, out;
    fmpq_t low, high;

    (void)unused;
    jlt_range_init(&a);
    jlt_range_init(&out);
    fmpq_init(low);
    fmpq_init(high);
    fmpq_set_si(low, 1, 5);
    fmpq_set_si(high, 1, 1);
    jlt_range_set_fractions(&a, low, high, BITS);
    jlt_range_set(&out, &a);
    for (unsigned i = 0; i < 7; i++) jlt_range_multiply(&out, &out, &a, BITS);
    assert_int_equal(jlt_range_sign(&out), 1);
    assert_true(arf_cmp_d(out.low, 2.5e-6) > 0 && arf_cmp_d(out.low, 2.56e-6) <= 0); /* 5^-8 = 2.56e-6 */
    fmpq_set_si(low, -1, 1);
    fmpq_set_si(high, 2, 1);
    jlt_range_set_fractions(&a, low, high, BITS);
    jlt_range_power(&out, &a, 2, BITS);
    assert_true(arf_is_zero(out.low) && arf_cmp_d(out.high, 4) == 0);
    assert_int_equal(jlt_range_sign(&out), 0);
    assert_false(jlt_range_is_zero(&out));
    jlt_range_clear(&a);
    jlt_range_clear(&out);
    fmpq_clear(low);
    fmpq_clear(high);
}

static void balls_are_written_outwards_also_around_zero(void **unused)
{
    static const double balls[][2] = { { 0, 1e-5 }, { 0, 0 }, { 1, 1e-5 }, { -0.3, 1e-12 }, { 1e-9, 1 } };
    arb_t ball, read;

    (void)unused;
    arb_init(ball);
    arb_init(read);
    for (size_t i = 0; i < sizeof balls / sizeof *balls; i++) {
        json_t *text;
        arb_set_d(ball, balls[i][0]);
        mag_set_d(arb_radref(ball), balls[i][1]);
        text = jlt_shown_ball(ball, 20, false);
        assert_true(jlt_numerals_ball(read, text, 200));
        assert_true(arb_contains(read, ball));
        assert_true(mag_cmp_2exp_si(arb_radref(read), 2) <= 0); /* written twice as wide, with three digits */
        json_decref(text);
    }
    arb_clear(ball);
    arb_clear(read);
}

static void bounds_are_written_outwards(void **unused)
{
    arb_t read;
    arf_t value;

    (void)unused;
    arb_init(read);
    arf_init(value);
    for (unsigned round = 0; round < ROUNDS; round++) {
        json_t *low, *high;
        arf_randtest(value, dice, 100, 6);
        low = jlt_shown_lower_bound(value);
        high = jlt_shown_upper_bound(value);
        assert_true(jlt_numerals_read(read, json_string_value(low), 200));
        arb_sub_arf(read, read, value, 300);
        assert_true(arb_is_nonpositive(read));
        assert_true(jlt_numerals_read(read, json_string_value(high), 200));
        arb_sub_arf(read, read, value, 300);
        assert_true(arb_is_nonnegative(read));
        json_decref(low);
        json_decref(high);
    }
    arb_clear(read);
    arf_clear(value);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(results_contain_those_at_points),
        cmocka_unit_test(signs_and_squares_are_sharp),
        cmocka_unit_test(balls_are_written_outwards_also_around_zero),
        cmocka_unit_test(bounds_are_written_outwards),
    };
    int failed;

    flint_randinit(dice);
    failed = cmocka_run_group_tests(tests, NULL, NULL);
    flint_randclear(dice);
    return failed;
}
