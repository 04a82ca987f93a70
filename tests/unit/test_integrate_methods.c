/* One-step methods on problems with known solutions: order, honesty of tolerance, dense output, failure by name. */
#include <float.h>

#include "unit/check.h"
#include "unit/sample_fields.h"

#include "integrate/bernstein.h"
#include "integrate/orbit.h"
#include "integrate/taylor.h"

static const jlt_field kepler_field = { .dim = 4, .call = kepler, .jet = kepler_jet, .root = -1 };
static const double eccentricity = 0.5;
static const double pi = 3.14159265358979323846;

/* From the pericentre; the period is 2 pi. */
static void kepler_start(double *x)
{
    x[0] = 1 - eccentricity;
    x[1] = 0;
    x[2] = 0;
    x[3] = sqrt((1 + eccentricity) / (1 - eccentricity));
}

/* State at mean anomaly M by Newton's method on Kepler's equation: independent of all integration. */
static void kepler_state(double *x, double M)
{
    double E = M;
    for (int i = 0; i < 50; i++) E -= (E - eccentricity * sin(E) - M) / (1 - eccentricity * cos(E));
    const double q = sqrt(1 - eccentricity * eccentricity), rate = 1 / (1 - eccentricity * cos(E));
    x[0] = cos(E) - eccentricity;
    x[1] = q * sin(E);
    x[2] = -sin(E) * rate;
    x[3] = q * cos(E) * rate;
}

static double kepler_error(const jlt_method *method, double tolerance, double t)
{
    double x[4], expected[4], worst = 0;
    jlt_orbit *orbit = NULL;

    kepler_start(x);
    assert_ok(jlt_orbit_create(&orbit, method, &kepler_field, &(jlt_options){ .tolerance = tolerance }));
    assert_ok(jlt_orbit_start(orbit, 0, x, t > 0 ? +1 : -1));
    assert_ok(jlt_orbit_propagate(orbit, t, x));
    kepler_state(expected, t);
    for (unsigned i = 0; i < 4; i++) worst = fmax(worst, fabs(x[i] - expected[i]));
    jlt_orbit_destroy(orbit);
    return worst;
}

/* Along a Kepler orbit errors grow like t^2 by the drift of the period: one and a half turns with some 50 steps amplify a
 * local error about a hundredfold. */
static void every_method_keeps_its_tolerance_on_kepler_forwards_and_backwards(void **unused)
{
    (void)unused;
    for (size_t i = 0; jlt_method_at(i) != NULL; i++) {
        const jlt_method *method = jlt_method_at(i);
        const double slack = method->order == 0 && !method->needs_jet ? 2e4 : 500;
        for (double tolerance = 1e-6; tolerance > 5e-13; tolerance *= 0.01) {
            assert_below(kepler_error(method, tolerance, 9), slack * tolerance + 1e-13);
            assert_below(kepler_error(method, tolerance, -9), slack * tolerance + 1e-13);
        }
    }
}

/* Fixed steps: tolerance so loose that max_step rules. Halving divides the error by 2^8 = 256; 150 to 400 is accepted. */
static void dop853_has_order_eight(void **unused)
{
    (void)unused;
    double error[2], x[2];
    const jlt_field field = { .dim = 2, .call = oscillator, .root = -1 };
    for (unsigned k = 0; k < 2; k++) {
        const double h = k == 0 ? 0.5 : 0.25;
        jlt_orbit *orbit = NULL;
        assert_ok(jlt_orbit_create(&orbit, jlt_method_find("dop853"), &field,
                                   &(jlt_options){ .tolerance = 0.1, .max_step = h, .first_step = h }));
        x[0] = 1, x[1] = 0;
        assert_ok(jlt_orbit_start(orbit, 0, x, +1));
        assert_ok(jlt_orbit_propagate(orbit, 4, x));
        error[k] = hypot(x[0] - cos(4), x[1] + sin(4));
        jlt_orbit_destroy(orbit);
    }
    assert_true(error[0] / error[1] > 150 && error[0] / error[1] < 400);
}

/* The polynomial on each step, at 16 points, against Kepler's equation. Shares of the tolerance are such
 * that errors are about it (test_equal_tolerances.c): ten tolerances bound the states. Polynomials of order 7 under steps of order
 * 8 are as good; that of gauss, of order 8 under 16, errs by the root of it at worst, and 1e3 tolerances bound it at these nodes.
 * Ends are met exactly. Bernstein form is the same polynomial
 * but for rounding: coefficients of powers grow to 6000 times the smallest terms, 1e-13 bounds their rounding. */
static void dense_output_follows_the_solution_on_every_step(void **unused)
{
    (void)unused;
    const double tolerance = 1e-10;
    for (size_t i = 0; jlt_method_at(i) != NULL; i++) {
        jlt_stepper *stepper = NULL;
        double x[4], expected[4], partial[16], worst = 0, worst_partial = 0;
        kepler_start(x);
        assert_ok(jlt_stepper_create(&stepper, jlt_method_at(i), &kepler_field, tolerance, INFINITY));
        assert_ok(jlt_stepper_start(stepper, 0, x, 1, 0));
        while (stepper->tau < 2 * pi) {
            assert_ok(jlt_stepper_advance(stepper, INFINITY));
            assert_ok(jlt_stepper_dense(stepper));
            for (unsigned k = 0; k < 4; k++) {
                assert_near(jlt_stepper_value(stepper, k, 0), stepper->x_start[k], 1e-15);
                assert_near(jlt_stepper_value(stepper, k, 1), stepper->x[k], 1e-14);
            }
            for (unsigned k = 0; stepper->method->bernstein != NULL && k < 4; k++) {
                double b[JLT_BERNSTEIN_DEGREE_MAX + 1];
                const unsigned degree = stepper->method->bernstein(stepper, k, b);
                for (double theta = 0; theta <= 1; theta += 1.0 / 16)
                    assert_near(jlt_bernstein_value(b, degree, theta), jlt_stepper_value(stepper, k, theta), 1e-13);
            }
            for (double theta = 0; theta <= 1; theta += 1.0 / 16) {
                kepler_state(expected, stepper->tau_start + theta * stepper->h);
                assert_ok(stepper->method->partial(stepper, theta, partial));
                for (unsigned k = 0; k < 4; k++) {
                    worst = fmax(worst, fabs(jlt_stepper_value(stepper, k, theta) - expected[k]));
                    worst_partial = fmax(worst_partial, fabs(partial[k] - expected[k]));
                }
            }
        }
        assert_below(worst, (strcmp(stepper->method->name, "gauss") == 0 ? 1e3 : 10) * tolerance);
        assert_below(worst_partial, 10 * tolerance);
        jlt_stepper_destroy(stepper);
    }
}

/* Period of the Arenstorf orbit to the digits of the literature; its instability amplifies local errors by about 1e5, roundings
 * too. */
static void the_arenstorf_orbit_closes(void **unused)
{
    (void)unused;
    static const double mu = 0.012277471;
    const jlt_field field = { .dim = 4, .call = arenstorf, .p = &mu, .root = -1 };
    const double start[4] = { 0.994, 0, 0, -2.00158510637908252240537862224 };
    const char *const methods[] = { "dop853", "rk8pd" };
    for (size_t m = 0; m < 2; m++) {
        double last = INFINITY;
        for (double tolerance = 1e-10; tolerance > 5e-15; tolerance *= 0.01) {
            jlt_orbit *orbit = NULL;
            double x[4];
            assert_ok(jlt_orbit_create(&orbit, jlt_method_find(methods[m]), &field, &(jlt_options){ .tolerance = tolerance }));
            assert_ok(jlt_orbit_start(orbit, 0, start, +1));
            assert_ok(jlt_orbit_propagate(orbit, 17.0652165601579625588917206249, x));
            const double error = hypot(x[0] - start[0], x[1] - start[1]);
            assert_below(error, 1e5 * tolerance);
            assert_below(error, fmax(last, 1e5 * DBL_EPSILON));
            last = error;
            jlt_orbit_destroy(orbit);
        }
    }
}

/* Lorenz AB orbit at sigma = 10, rho = 28, beta = 8/3: T = 1.55865221071617 (D. Viswanath, Nonlinearity 16, 2003). On z = 27
 * it starts where its coordinates are published; closing is judged by the return itself after one period, amplified by the
 * multiplier 4.7. Both methods must agree with each other beyond that. */
static void taylor_and_dop853_agree_on_lorenz(void **unused)
{
    (void)unused;
    static const double p[3] = { 10, 28, 8.0 / 3 };
    const jlt_field field = { .dim = 3, .call = lorenz, .p = p, .jet = lorenz_jet, .root = -1 };
    const double start[3] = { -13.763610682134, -19.578751942452, 27 };
    const char *const methods[] = { "taylor", "dop853" };
    double x[2][3];

    for (unsigned m = 0; m < 2; m++) {
        jlt_orbit *orbit = NULL;
        assert_ok(jlt_orbit_create(&orbit, jlt_method_find(methods[m]), &field, &(jlt_options){ .tolerance = 1e-15 }));
        assert_ok(jlt_orbit_start(orbit, 0, start, +1));
        assert_ok(jlt_orbit_propagate(orbit, 1.55865221071617, x[m]));
        for (unsigned i = 0; i < 3; i++) assert_near(x[m][i], start[i], 1e-10);
        jlt_orbit_destroy(orbit);
    }
    for (unsigned i = 0; i < 3; i++) assert_near(x[0][i], x[1][i], 2e-12);
}

/* p = L/2 + 1 for tolerance exp(-L), bounded. */
static void taylor_chooses_its_order_by_the_tolerance(void **unused)
{
    (void)unused;
    assert_int_equal(jlt_taylor_order(1e-16), 20);
    assert_int_equal(jlt_taylor_order(1e-10), 13);
    assert_int_equal(jlt_taylor_order(0.5), 4);
}

/* x' = x^2 has its pole at t = 1: no method may pass it in silence, and the last point is good. */
static void a_solution_that_ends_is_reported_and_not_passed(void **unused)
{
    (void)unused;
    const jlt_field field = { .dim = 1, .call = blow_up, .root = -1 };
    for (size_t i = 0; jlt_method_at(i) != NULL; i++) {
        if (jlt_method_at(i)->needs_jet) continue;
        jlt_orbit *orbit = NULL;
        double x[1] = { 1 };
        assert_ok(jlt_orbit_create(&orbit, jlt_method_at(i), &field, &(jlt_options){ .tolerance = 1e-9, .max_steps = 100000 }));
        assert_ok(jlt_orbit_start(orbit, 0, x, +1));
        const jlt_status st = jlt_orbit_propagate(orbit, 2, x);
        assert_true(st == JLT_ERR_NO_PROGRESS || st == JLT_ERR_NONFINITE || st == JLT_ERR_BUDGET);
        const double t = jlt_orbit_stepper(orbit)->tau;
        assert_true(isfinite(x[0]) && t < 1 + 1e-6);
        jlt_orbit_destroy(orbit);
    }
}

static void bad_arguments_are_refused(void **unused)
{
    (void)unused;
    jlt_stepper *stepper = NULL;
    const double nan_state[4] = { NAN, 0, 0, 1 };
    const jlt_field no_jet = { .dim = 1, .call = blow_up, .root = -1 };

    assert_int_equal(jlt_stepper_create(&stepper, NULL, &kepler_field, 0, INFINITY), JLT_ERR_ARG);
    assert_int_equal(jlt_stepper_create(&stepper, NULL, &kepler_field, 1e-9, -1), JLT_ERR_ARG);
    assert_int_equal(jlt_stepper_create(&stepper, jlt_method_find("taylor"), &no_jet, 1e-9, 1), JLT_ERR_UNSUPPORTED);
    assert_null(stepper);
    assert_null(jlt_method_find("euler"));
    assert_ok(jlt_stepper_create(&stepper, NULL, &kepler_field, 1e-9, INFINITY));
    assert_int_equal(jlt_stepper_start(stepper, 0, nan_state, 1, 0), JLT_ERR_NONFINITE);
    jlt_stepper_destroy(stepper);
}

static void focus(const double *restrict x, const double *restrict p, double *restrict f)
{
    (void)p;
    f[0] = -0.3 * x[0] - x[1];
    f[1] = x[0] - 0.3 * x[1];
}

/* The same motion in other units, of length, a power of two, with the scales. Every step is the same to the last bit,
 * from the first one, which the method proposes, on. */
static void steps_are_the_same_in_other_units(void **unused)
{
    const jlt_method *method;

    (void)unused;
    for (size_t i = 0; (method = jlt_method_at(i)) != NULL; i++) {
        double lengths[2][4];
        if (method->needs_jet) continue;
        for (int large = 0; large < 2; large++) {
            const double unit = large != 0 ? 0x1p20 : 1, x[] = { 0.7 * unit, 0.2 * unit }, scale[] = { 0.5 * unit, 0.5 * unit };
            const jlt_field field = { .dim = 2, .call = focus, .root = -1, .scale = scale };
            jlt_stepper *stepper = NULL;
            assert_ok(jlt_stepper_create(&stepper, method, &field, 1e-9, INFINITY));
            assert_ok(jlt_stepper_start(stepper, 0, x, 1, 0));
            lengths[large][0] = stepper->h_next;
            for (int k = 1; k < 4; k++) {
                assert_ok(jlt_stepper_advance(stepper, INFINITY));
                lengths[large][k] = stepper->h;
            }
            jlt_stepper_destroy(stepper);
        }
        for (int k = 0; k < 4; k++)
            if (lengths[0][k] != lengths[1][k])
                fail_msg("%s: step %d is %.17g, and %.17g in other units", method->name, k, lengths[0][k], lengths[1][k]);
        assert_true(lengths[0][0] > 1e-4 && lengths[0][0] < 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_keeps_its_tolerance_on_kepler_forwards_and_backwards),
        cmocka_unit_test(dop853_has_order_eight),
        cmocka_unit_test(dense_output_follows_the_solution_on_every_step),
        cmocka_unit_test(the_arenstorf_orbit_closes),
        cmocka_unit_test(taylor_and_dop853_agree_on_lorenz),
        cmocka_unit_test(taylor_chooses_its_order_by_the_tolerance),
        cmocka_unit_test(a_solution_that_ends_is_reported_and_not_passed),
        cmocka_unit_test(steps_are_the_same_in_other_units),
        cmocka_unit_test(bad_arguments_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
