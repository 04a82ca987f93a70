/* Equilibria (4.4) where methods fail: no spin, poles, no axial inertia, equal moments, parameters from 1e-150 to 1e150.
 * Oracle for all: the closed form of Kilin and Ivanova (2023), section 4.1,
 *     lambda^2 + p lambda + q = 0,   p = m R I3 c v / (s Theta),   q = I3^2 w^2 (I3 + m R^2) / (I1 Theta),
 * in long double, whose range holds every intermediate, with s^2 = (1 - c)(1 + c). */
#include "unit/check.h"
#include "table.h"

#include "analysis/linearization.h"
#include "core/random.h"
#include "ext/eigen.h"
#include "kernel/descriptor.h"

#include <float.h>

enum { M, R, G, A3, I1, I3, PARAMS };
enum { GAMMA3, V_NU, OMEGA_TAU, OMEGA_N, OMEGA3, STATES };

typedef struct {
    long double p, re[2], im;
} closed_form;

static closed_form solve(const double *params, const double *x)
{
    const long double c = x[GAMMA3], v = x[V_NU], w = x[OMEGA3], m = params[M], r = params[R], i1 = params[I1], i3 = params[I3];
    const long double s = sqrtl((1 - c) * (1 + c)), theta = i1 * i3 + i1 * m * r * r * s * s + i3 * m * r * r * c * c;
    const long double p = m * r * i3 * c * v / (s * theta), q = i3 * i3 * w * w * (i3 + m * r * r) / (i1 * theta);
    const long double discriminant = p * p / 4 - q;
    closed_form f = { .p = p };

    if (discriminant < 0) {
        f.re[0] = f.re[1] = -p / 2;
        f.im = sqrtl(-discriminant);
    } else {
        const long double larger = p > 0 ? -p / 2 - sqrtl(discriminant) : -p / 2 + sqrtl(discriminant);
        const long double smaller = larger == 0 ? 0 : q / larger;
        f.re[0] = fminl(larger, smaller);
        f.re[1] = fmaxl(larger, smaller);
    }
    return f;
}

static const jlt_descriptor *top(void)
{
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);

    assert_non_null(d);
    assert_string_equal(d->params[I3].name, "I3");
    assert_string_equal(d->states[OMEGA3].name, "omega3");
    return d;
}

/* The two eigenvalues that the integrals do not claim, ascending; the number that they do. */
static int others(const jlt_linearization *r, jlt_eigenvalue pair[2])
{
    int zeros = 0, found = 0;

    for (size_t i = 0; i < r->n; i++) {
        if (r->eigen.values[i].source >= 0) {
            assert_true(r->eigen.values[i].re == 0.0 && r->eigen.values[i].im == 0.0);
            zeros++;
        } else if (found < 2) {
            pair[found++] = r->eigen.values[i];
        }
    }
    return zeros;
}

static void compare(const jlt_linearization *r, const closed_form *exact, const char *what)
{
    jlt_eigenvalue pair[2];

    if (others(r, pair) != 3) return; /* without v and w there is less to attribute */
    for (int i = 0; i < 2; i++) {
        const long double off = hypotl(pair[i].re - exact->re[i], fabs(pair[i].im) - exact->im);
        const long double size = hypotl(exact->re[i], exact->im);
        if (!(off <= pair[i].error + 4 * DBL_EPSILON * size))
            fail_msg("%s: eigenvalue %.17g %+.17gi, exactly %.17Lg %.17Lg: off by %.3Lg, bound %.3g", what, pair[i].re,
                     pair[i].im, exact->re[i], exact->im, off, pair[i].error);
    }
    if (!(fabsl(r->trace + exact->p) <= r->trace_error)) fail_msg("%s: trace %.17g, exactly %.17Lg", what, r->trace, -exact->p);
}

/* Overflow or underflow anywhere is an error; what is not refused is right to within its own bound. */
static void parameters_from_1e_150_to_1e150_give_errors_or_right_numbers(void **unused)
{
    const jlt_descriptor *d = top();
    jlt_random random;
    int right = 0, refused = 0;

    (void)unused;
    jlt_random_seed(&random, 11);
    for (int trial = 0; trial < 40000; trial++) {
        const double span = trial % 4 == 0 ? 150 : trial % 4 == 1 ? 60 : trial % 4 == 2 ? 20 : 8;
        double params[PARAMS] = { 0 }, x[STATES] = { 0 };
        jlt_linearization r;
        for (int i = 0; i < PARAMS; i++) params[i] = jlt_random_magnitude(&random, -span, span);
        params[A3] = 0.0;
        x[GAMMA3] = jlt_random_between(&random, -1.0, 1.0);
        x[V_NU] = jlt_random_magnitude(&random, -span, span);
        x[OMEGA3] = -jlt_random_magnitude(&random, -span, span);
        const jlt_status st = jlt_linearization_compute(&r, d, params, x, NULL, NULL, NULL);
        if (st == JLT_OK) {
            const closed_form exact = solve(params, x);
            compare(&r, &exact, "extreme parameters");
            right++;
        } else {
            assert_true(st == JLT_ERR_NONFINITE || st == JLT_ERR_DOMAIN);
            refused++;
        }
    }
    print_message("%d right, %d refused\n", right, refused);
    assert_true(right > 15000);
}

static void near_the_poles_nothing_is_lost(void **unused)
{
    const jlt_descriptor *d = top();

    (void)unused;
    for (int exponent = 1; exponent <= 16; exponent++)
        for (int side = -1; side <= 1; side += 2) {
            double params[PARAMS] = { 1.3, 0.7, 9.8, 0.0, 0.29, 0.21 }, x[STATES] = { 0 };
            jlt_linearization r;
            closed_form exact;
            x[GAMMA3] = side * (1.0 - (exponent == 16 ? DBL_EPSILON / 2 : pow(10.0, -exponent)));
            x[V_NU] = 0.8;
            x[OMEGA3] = -2.3;
            assert_ok(jlt_linearization_compute(&r, d, params, x, NULL, NULL, NULL));
            exact = solve(params, x);
            compare(&r, &exact, "near a pole");
            assert_below(fabs((double)((r.trace + exact.p) / exact.p)), 16 * DBL_EPSILON);
        }
}

static void axial_inertia_may_be_tiny_or_zero(void **unused)
{
    static const double inertias[] = { 1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-30, 1e-100, 0.0 };
    const jlt_descriptor *d = top();

    (void)unused;
    for (size_t k = 0; k < sizeof inertias / sizeof *inertias; k++) {
        double params[PARAMS] = { 1.3, 0.7, 9.8, 0.0, 0.29, inertias[k] }, x[STATES] = { 0.3, 0.8, 0, 0, -2.3 };
        jlt_linearization r;
        const closed_form exact = solve(params, x);
        assert_ok(jlt_linearization_compute(&r, d, params, x, NULL, NULL, NULL));
        compare(&r, &exact, "small axial inertia");
        if (inertias[k] == 0.0) assert_true(r.trace == 0.0 && !r.obstructs && r.eigen.defective_zero);
        else assert_true(r.obstructs);
    }
}

/* The moments equal, and one ulp to either side: the variant changes, the eigenvalues do so by rounding alone. */
static void equal_moments_and_their_neighbours_agree(void **unused)
{
    const jlt_descriptor *d = top();
    const double middle = 1.0 / 3.0, below = nextafter(middle, 0.0), above = nextafter(middle, 1.0);
    const double values[] = { below, middle, above };
    double trace[3];

    (void)unused;
    for (int k = 0; k < 3; k++) {
        double params[PARAMS] = { 1, 1, 1, 0.0, middle, values[k] }, x[STATES] = { 0.5, -2.0, 0, 0, 0.7 };
        jlt_linearization r;
        const closed_form exact = solve(params, x);
        assert_ok(jlt_linearization_compute(&r, d, params, x, NULL, NULL, NULL));
        assert_string_equal(r.descriptor->variant, k == 1 ? "balanced_equal" : "balanced");
        compare(&r, &exact, "equal moments");
        trace[k] = r.trace;
    }
    assert_below(fabs(trace[0] - trace[1]), 8 * DBL_EPSILON);
    assert_below(fabs(trace[2] - trace[1]), 8 * DBL_EPSILON);
}

/* Relative distance of general QR's nearest eigenvalue from the small one, its largest among those that should be smaller still, in
 * units of the largest of all, and the same for the matrix seen from other axes, H A H with a reflection H. */
static void general_qr(double *small, double *zero, double *turned, const jlt_linearization *r, const closed_form *exact)
{
    double a[STATES * STATES], re[STATES], im[STATES], u[STATES], norm = 0;

    for (int i = 0; i < STATES; i++) {
        u[i] = 1.0 + 0.3 * i * i;
        norm += u[i] * u[i];
    }
    memcpy(a, r->jacobian, sizeof a);
    for (int rotated = 0; rotated < 2; rotated++) {
        double *const farthest = rotated ? turned : zero;
        assert_ok(jlt_eigen_values(re, im, a, STATES));
        if (!rotated) *small = INFINITY;
        *farthest = 0;
        for (int i = 0; i < STATES; i++) {
            const double size = hypot(re[i], im[i]), large = hypot(re[i] - (double)exact->re[0], im[i]);
            if (!rotated) *small = fmin(*small, hypot(re[i] - (double)exact->re[1], im[i]) / fabs((double)exact->re[1]));
            if (large > size) *farthest = fmax(*farthest, size / fabs((double)exact->re[0]));
        }
        for (int side = 0; side < 2; side++) /* a <- H a, then transposed: twice is H a H */
            for (int j = 0; j < STATES; j++) {
                double *const v = a + (side == 0 ? j : j * STATES), dot = 0;
                const int step = side == 0 ? STATES : 1;
                for (int i = 0; i < STATES; i++) dot += u[i] * v[i * step];
                for (int i = 0; i < STATES; i++) v[i * step] -= 2 * u[i] * dot / norm;
            }
    }
}

/* omega3 -> 0: the small eigenvalue goes as omega3^2 and keeps all its digits until it leaves the range of doubles, where
 * general QR sees rounding noise from omega3 = 1e-8 on; at zero it is exact, and said to be defective. */
static void small_spin_keeps_relative_accuracy(void **unused)
{
    const jlt_descriptor *d = top();
    FILE *table = table_open("small_spin", "omega3,exact,deflated_error,qr_error,qr_zero,qr_turned");

    (void)unused;
    for (int exponent = 0; exponent <= 140; exponent += exponent < 20 ? 1 : 4) {
        double params[PARAMS] = { 1.3, 0.7, 9.8, 0.0, 0.29, 0.21 }, x[STATES] = { 0.3, 0.8, 0, 0, pow(10.0, -exponent) };
        jlt_linearization r;
        jlt_eigenvalue pair[2];
        const closed_form exact = solve(params, x);
        assert_ok(jlt_linearization_compute(&r, d, params, x, NULL, NULL, NULL));
        compare(&r, &exact, "small spin");
        assert_int_equal(others(&r, pair), 3);
        if (exponent >= 4) assert_below(pair[1].error / fabs(pair[1].re), 100 * DBL_EPSILON);
        assert_int_equal(r.verdict, JLT_STABLE);
        if (exponent > 0) { /* both real from here on */
            const double off = fabs((double)(pair[1].re / exact.re[1] - 1));
            double small, zero, turned;
            general_qr(&small, &zero, &turned, &r, &exact);
            table_row(table, "1e-%d,%.6Le,%.3e,%.3e,%.3e,%.3e", exponent, exact.re[1], off, small, zero, turned);
            if (exponent % 4 == 0 && exponent <= 20)
                print_message(
                    "omega3 = 1e-%d: small eigenvalue deflated %.0e, by QR %.0e; zeros by QR %.0e, from other axes %.0e\n",
                    exponent, off, small, zero, turned);
        }
    }
    table_close(&(void *){ table });
    {
        double params[PARAMS] = { 1.3, 0.7, 9.8, 0.0, 0.29, 0.21 }, x[STATES] = { 0.3, 0.8, 0, 0, 0.0 };
        jlt_linearization r;
        jlt_eigenvalue pair[2];
        assert_ok(jlt_linearization_compute(&r, d, params, x, NULL, NULL, NULL));
        assert_int_equal(others(&r, pair), 3);
        assert_true(pair[1].re == 0.0 && pair[1].im == 0.0 && r.eigen.defective_zero);
        assert_int_equal(r.verdict, JLT_UNSTABLE);
    }
}

static void nonfinite_values_and_other_states_are_refused(void **unused)
{
    static const double bad[] = { NAN, INFINITY, -INFINITY };
    const jlt_descriptor *d = top();
    const double params[PARAMS] = { 1.3, 0.7, 9.8, 0.0, 0.29, 0.21 }, x[STATES] = { 0.3, 0.8, 0, 0, -2.3 };
    jlt_linearization r;

    (void)unused;
    for (int i = 0; i < PARAMS; i++)
        for (int b = 0; b < 3; b++) {
            double changed[PARAMS];
            memcpy(changed, params, sizeof params);
            changed[i] = bad[b];
            assert_int_equal(jlt_linearization_compute(&r, d, changed, x, NULL, NULL, NULL), JLT_ERR_NONFINITE);
        }
    for (int i = 0; i < STATES; i++)
        for (int b = 0; b < 3; b++) {
            double changed[STATES];
            memcpy(changed, x, sizeof x);
            changed[i] = bad[b];
            assert_int_equal(jlt_linearization_compute(&r, d, params, changed, NULL, NULL, NULL), JLT_ERR_NONFINITE);
            assert_true(jlt_linearization_find(changed, d, params, NULL, 0) != JLT_OK);
        }
    {
        const double moving[STATES] = { 0.3, 0.8, 1e-9, 0, -2.3 };
        assert_int_equal(jlt_linearization_compute(&r, d, params, moving, NULL, NULL, NULL), JLT_ERR_EMPTY);
        assert_below(fabs(r.residual - sqrt(0.91) * 1e-9), 1e-8);
        assert_true(r.residual > 0.0);
    }
}

/* Newton from a disturbed state of each family comes back to an equilibrium. */
static void newton_finds_equilibria_again(void **unused)
{
    const jlt_descriptor *d = top();
    jlt_random random;
    int found = 0, tried = 0;

    (void)unused;
    jlt_random_seed(&random, 2);
    for (int trial = 0; trial < 300; trial++) {
        double params[PARAMS] = { 1, 1, 1, 0.51, 1.0 / 3, 1.0 / 3 };
        /* omega_n^2 a3/3 = a3 s^2: steady precession of (5.1) with equal moments. */
        const double c = jlt_random_between(&random, -0.95, 0.95), s = sqrt((1 - c) * (1 + c)), wn = s * sqrt(3.0);
        const double at[STATES] = { c, 0, 0, wn, -(0.51 + c) * wn / s };
        double x[STATES];
        const size_t order[] = { GAMMA3 };
        jlt_linearization r;
        for (int i = 0; i < STATES; i++) x[i] = at[i] + (i == GAMMA3 ? 0.0 : jlt_random_between(&random, -0.05, 0.05));
        tried++;
        if (jlt_linearization_find(x, d, params, order, 1) != JLT_OK) continue;
        found++;
        assert_true(x[GAMMA3] == c);
        assert_near(fabs(x[OMEGA_N]), wn, 1e-9);
        assert_ok(jlt_linearization_compute(&r, d, params, x, NULL, NULL, NULL));
        assert_string_equal(r.family->name, "precession");
        assert_below(fabs(r.trace), 1e-12);
    }
    assert_int_equal(found, tried);
}

/* The field gamma3' = s omega_tau falls with the distance from a pole while its derivative grows: a state that spins past a
 * pole is no equilibrium, however close, and Newton's method does not end there. */
static void poles_are_no_equilibria(void **unused)
{
    const jlt_descriptor *d = top();
    const double params[PARAMS] = { 1, 1, 1, 0.51, 1.0 / 3, 1.0 / 3 };
    jlt_linearization r;
    jlt_random random;

    (void)unused;
    for (double off = DBL_EPSILON / 2; off < 0.1; off *= 8) {
        const double at[STATES] = { 1.0 - off, 0, 1, 0, 0 };
        assert_int_equal(jlt_linearization_compute(&r, d, params, at, NULL, NULL, NULL), JLT_ERR_EMPTY);
        assert_near(r.residual, sqrt(off * (2 - off)), 1e-15);
    }
    jlt_random_seed(&random, 4);
    for (int trial = 0; trial < 60; trial++) {
        static const size_t order[] = { OMEGA_TAU, OMEGA_N };
        double x[STATES] = { 0 };
        const size_t held = (size_t)trial % 3;
        if (trial % 4 != 0) x[GAMMA3] = jlt_random_between(&random, -1.0, 1.0);
        for (int i = V_NU; i < STATES; i++) x[i] = i == OMEGA_TAU || trial % 4 != 0 ? jlt_random_between(&random, -2.0, 2.0) : 0;
        assert_ok(jlt_linearization_find(x, d, params, order, held));
        assert_ok(jlt_linearization_compute(&r, d, params, x, NULL, NULL, NULL));
        assert_non_null(r.family);
        assert_string_equal(r.family->name, "precession");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parameters_from_1e_150_to_1e150_give_errors_or_right_numbers),
        cmocka_unit_test(near_the_poles_nothing_is_lost),
        cmocka_unit_test(axial_inertia_may_be_tiny_or_zero),
        cmocka_unit_test(equal_moments_and_their_neighbours_agree),
        cmocka_unit_test(small_spin_keeps_relative_accuracy),
        cmocka_unit_test(nonfinite_values_and_other_states_are_refused),
        cmocka_unit_test(newton_finds_equilibria_again),
        cmocka_unit_test(poles_are_no_equilibria),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
