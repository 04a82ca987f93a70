/* Ball enclosures of a model's expressions: they hold the exact value, are thin, and never claim too much. */
#include "unit/check.h"

#include "ball/ball.h"
#include "core/random.h"

#include <float.h>
#include <stdlib.h>

static const char table[] = "model sample\n"
                            "param p > 0\n"
                            "param q\n"
                            "state x in (-1, 1)\n"
                            "state y\n"
                            "root s = sqrt(1 - x^2)\n"
                            "let d = p + q^2*s^2\n"
                            "eq x =\n"
                            "    + s*y/d\n"
                            "    - x*y^3/7\n"
                            "eq y =\n"
                            "    + x/s\n"
                            "    - q*y*d\n";

typedef struct {
    ttc_diagnostics *diagnostics;
    ttc_model *model;
    ttc_ball *ball;
    uint32_t p, q, x, y;
} fixture;

static fixture set_up(void)
{
    fixture f = { .diagnostics = ttc_diagnostics_create() };

    f.model = ttc_model_parse(table, strlen(table), "sample.tt", f.diagnostics);
    assert_non_null(f.model);
    f.ball = ttc_ball_create(f.model);
    assert_non_null(f.ball);
    assert_true(ttc_model_find_symbol(f.model, "p", &f.p) && ttc_model_find_symbol(f.model, "q", &f.q) &&
                ttc_model_find_symbol(f.model, "x", &f.x) && ttc_model_find_symbol(f.model, "y", &f.y));
    return f;
}

static void tear_down(fixture *f)
{
    ttc_ball_destroy(f->ball);
    ttc_model_destroy(f->model);
    ttc_diagnostics_destroy(f->diagnostics);
}

/* Oracle: long double, 11 bits beyond double, with its own rounding allowed for. */
static void enclosures_hold_what_long_double_computes(void **unused)
{
    fixture f = set_up();
    jlt_random random;

    (void)unused;
    jlt_random_seed(&random, 31);
    for (int trial = 0; trial < 500; trial++) {
        const double p = jlt_random_magnitude(&random, -3, 3), q = jlt_random_between(&random, -5, 5);
        const double x = jlt_random_between(&random, -1, 1), y = jlt_random_between(&random, -5, 5);
        const long double s = sqrtl((1 - (long double)x) * (1 + (long double)x)), d = p + (long double)q * q * s * s;
        const long double expected[2] = { s * y / d - (long double)x * y * y * y / 7, x / s - (long double)q * y * d };
        const long double size[2] = { fabsl(s * y / d) + fabsl((long double)x * y * y * y / 7), fabsl(x / s) + fabsl(q * y * d) };
        assert_true(ttc_ball_set(f.ball, f.p, p) && ttc_ball_set(f.ball, f.q, q) && ttc_ball_set(f.ball, f.x, x) &&
                    ttc_ball_set(f.ball, f.y, y));
        for (size_t i = 0; i < 2; i++) {
            ttc_enclosure e;
            assert_true(ttc_ball_estimate(&e, f.ball, ttc_model_field(f.model, i)));
            const long double off = fabsl((long double)e.value + e.rest - expected[i]);
            assert_true(off <= e.radius + 16 * LDBL_EPSILON * size[i]);
            assert_true(e.radius <= 1e-30 * (double)size[i]);
            assert_true(e.plain_rounding >= e.rounding * 0.5);
            /* Double arithmetic errs by about this much: some units of the terms' size. */
            assert_true(e.rounding < 100 * DBL_EPSILON * (double)size[i]);
        }
    }
    tear_down(&f);
}

/* By hand: p = 2, q = 1/2, x = 3/5, y = 5, s = 4/5, d = 54/25: f = 4/d - 3/5*125/7 = 50/27 - 75/7. */
static void rational_points_are_exact(void **unused)
{
    fixture f = set_up();
    bool excludes = false;
    int sign = 0;
    char *text;

    (void)unused;
    assert_true(ttc_ball_set_fraction(f.ball, f.p, "2") && ttc_ball_set_fraction(f.ball, f.q, "1/2") &&
                ttc_ball_set_fraction(f.ball, f.x, "3/5") && ttc_ball_set_fraction(f.ball, f.y, "5"));
    text = ttc_ball_exact_text(f.ball, ttc_model_field(f.model, 0));
    assert_string_equal(text, "-1675/189");
    free(text);
    assert_true(ttc_ball_exact_sign(&sign, f.ball, ttc_model_field(f.model, 0)));
    assert_int_equal(sign, -1);
    text = ttc_ball_text(f.ball, ttc_model_field(f.model, 0), 20, &excludes);
    assert_true(excludes && strncmp(text, "[-8.862433862433", 16) == 0);
    free(text);
    /* An irrational root has no exact value, a pole no enclosure, a symbol that stands for itself neither. */
    assert_true(ttc_ball_set_fraction(f.ball, f.x, "1/2"));
    assert_false(ttc_ball_exact_sign(&sign, f.ball, ttc_model_field(f.model, 0)));
    assert_null(ttc_ball_exact_text(f.ball, ttc_model_field(f.model, 0)));
    {
        ttc_enclosure e = { 7, 7, 7, 7, 7 };
        assert_true(ttc_ball_set_fraction(f.ball, f.x, "1"));
        assert_false(ttc_ball_estimate(&e, f.ball, ttc_model_field(f.model, 1)));
        assert_true(ttc_ball_set_fraction(f.ball, f.x, "2"));
        assert_false(ttc_ball_estimate(&e, f.ball, ttc_model_field(f.model, 0)));
        ttc_ball_bind(f.ball, f.x, f.model->symbols[f.x].node);
        assert_false(ttc_ball_estimate(&e, f.ball, ttc_model_field(f.model, 0)));
        assert_true(e.value == 7);
    }
    /* A third is not a sum of two doubles: the radius covers what they leave, which is found here without rounding. */
    {
        ttc_enclosure e;
        assert_true(ttc_ball_set_fraction(f.ball, f.p, "1/3"));
        assert_true(ttc_ball_estimate(&e, f.ball, f.model->symbols[f.p].node));
        const double left = fabs(fma(3, e.rest, fma(3, e.value, -1)));
        assert_true(left > 0 && left <= 3 * e.radius);
    }
    assert_false(ttc_ball_set(f.ball, f.x, NAN));
    assert_false(ttc_ball_set(f.ball, f.x, INFINITY));
    assert_false(ttc_ball_set_fraction(f.ball, f.x, "1/0"));
    assert_false(ttc_ball_set_fraction(f.ball, f.x, "one"));
    tear_down(&f);
}

/* Near x = 1 the radicand as written loses its digits and the factored one does not: the two running errors say so. */
static void running_errors_know_where_digits_are_lost(void **unused)
{
    fixture f = set_up();
    ttc_enclosure e;
    uint32_t s = 0;

    (void)unused;
    assert_true(ttc_model_find_symbol(f.model, "s", &s));
    for (int exponent = 2; exponent <= 14; exponent += 2) {
        assert_true(ttc_ball_set(f.ball, f.x, 1.0 - pow(10.0, -exponent)));
        assert_true(ttc_ball_estimate(&e, f.ball, f.model->symbols[s].node));
        assert_below(e.rounding, 4 * DBL_EPSILON * e.value);
        assert_true(e.plain_rounding > 0.01 * DBL_EPSILON * pow(10.0, exponent) * e.value);
    }
    tear_down(&f);
}

static const char functions[] = "model functions\n"
                                "param k > 0\n"
                                "state x\n"
                                "angle c s = cos(x + pi/3) sin(x + pi/3)\n"
                                "exp e = exp(x/2)\n"
                                "log l = log(k + x^2)\n"
                                "let d = x^2 - k\n"
                                "eq x = c + s + e + l + d\n";

/* Oracle: long double. Its rounding: of the argument, which sines and the exponential pass on as it is, and of the value. */
static void functions_are_enclosed(void **unused)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_parse(functions, strlen(functions), "functions.tt", diagnostics);
    static const char *const names[] = { "c", "s", "e", "l", "d" };
    uint32_t k, x, symbol = 0;
    jlt_random random;

    (void)unused;
    assert_non_null(model);
    ttc_ball *ball = ttc_ball_create(model);
    assert_true(ttc_model_find_symbol(model, "k", &k) && ttc_model_find_symbol(model, "x", &x));
    jlt_random_seed(&random, 47);
    for (int trial = 0; trial < 50; trial++) {
        const double kv = jlt_random_magnitude(&random, -3, 3), xv = jlt_random_between(&random, -5, 5);
        const long double turn = xv + acosl(-1) / 3, square = (long double)xv * xv;
        const long double expected[5] = { cosl(turn), sinl(turn), expl((long double)xv / 2), logl(kv + square), square - kv };
        assert_true(ttc_ball_set(ball, k, kv) && ttc_ball_set(ball, x, xv));
        for (int i = 0; i < 5; i++) {
            ttc_enclosure e;
            assert_true(ttc_model_find_symbol(model, names[i], &symbol));
            assert_true(ttc_ball_estimate(&e, ball, model->symbols[symbol].node));
            const long double size = 1 + fabsl(turn) + fabsl(expected[i]) + square + kv;
            assert_true(fabsl((long double)e.value + e.rest - expected[i]) <= e.radius + 4 * LDBL_EPSILON * size);
            assert_true(e.radius <= 1e-30 * (double)size);
        }
    }
    ttc_ball_destroy(ball);
    ttc_model_destroy(model);
    ttc_diagnostics_destroy(diagnostics);
}

/* An enclosure does not depend on what was asked before: after one that failed at every precision, and after one that needed
 * many bits, it is that of a new ball to the last bit. */
static void an_enclosure_is_that_of_a_new_ball_whatever_went_before(void **unused)
{
    const double before[] = { 1.0, 1.0 - 0x1p-53, -1.0 };

    (void)unused;
    for (size_t k = 0; k < sizeof before / sizeof *before; k++) {
        fixture used = set_up(), fresh = set_up();
        ttc_enclosure ignored, one, other;
        assert_true(ttc_ball_set(used.ball, used.p, 1.3) && ttc_ball_set(used.ball, used.q, 0.7)
                    && ttc_ball_set(used.ball, used.y, -2.1));
        assert_true(ttc_ball_set(used.ball, used.x, before[k]));
        assert_int_equal(ttc_ball_estimate(&ignored, used.ball, ttc_model_field(used.model, 1)), fabs(before[k]) < 1.0);
        assert_true(ttc_ball_set(used.ball, used.x, 0.3));
        assert_true(ttc_ball_set(fresh.ball, fresh.p, 1.3) && ttc_ball_set(fresh.ball, fresh.q, 0.7) &&
                    ttc_ball_set(fresh.ball, fresh.y, -2.1) && ttc_ball_set(fresh.ball, fresh.x, 0.3));
        for (size_t i = 0; i < 2; i++) {
            assert_true(ttc_ball_estimate(&one, used.ball, ttc_model_field(used.model, i)));
            assert_true(ttc_ball_estimate(&other, fresh.ball, ttc_model_field(fresh.model, i)));
            assert_true(one.value == other.value && one.rest == other.rest && one.radius == other.radius);
            assert_true(one.rounding == other.rounding && one.plain_rounding == other.plain_rounding);
            assert_true(one.radius > 0.0);
        }
        tear_down(&used);
        tear_down(&fresh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(enclosures_hold_what_long_double_computes),
        cmocka_unit_test(rational_points_are_exact),
        cmocka_unit_test(running_errors_know_where_digits_are_lost),
        cmocka_unit_test(functions_are_enclosed),
        cmocka_unit_test(an_enclosure_is_that_of_a_new_ball_whatever_went_before),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
