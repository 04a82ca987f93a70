/* Zeros of polynomials on [0, 1] against polynomials built from their zeros. */
#include "unit/check.h"

#include "integrate/bernstein.h"

/* Coefficients of scale * product of (theta - z_i). */
static unsigned from_zeros(double *c, const double *zeros, unsigned count, double scale)
{
    for (unsigned k = 0; k <= count; k++) c[k] = 0;
    c[0] = scale;
    for (unsigned i = 0; i < count; i++)
        for (unsigned k = i + 2; k-- > 0;) c[k] = (k > 0 ? c[k - 1] : 0) - zeros[i] * c[k];
    return count;
}

static unsigned zeros_of(double *roots, const double *zeros, unsigned count)
{
    double c[JLT_BERNSTEIN_DEGREE_MAX + 1], b[JLT_BERNSTEIN_DEGREE_MAX + 1];
    const unsigned degree = from_zeros(c, zeros, count, 2.5);
    jlt_bernstein_of(b, c, 1, degree);
    assert_near(b[0], c[0], 1e-15);
    for (double theta = 0; theta <= 1; theta += 0.125) {
        double horner = 0;
        for (unsigned k = degree + 1; k-- > 0;) horner = horner * theta + c[k];
        assert_near(jlt_bernstein_value(b, degree, theta), horner, 1e-13);
    }
    return jlt_bernstein_sign_changes(roots, b, degree);
}

/* Simple zeros 0.1 apart in degree 7: condition number below 1e4, so 1e-11. */
static void all_simple_zeros_inside_are_found_in_order(void **unused)
{
    (void)unused;
    const double zeros[7] = { 0.7, 0.1, 0.25, 0.5, 0.93, -0.2, 1.3 };
    const double expected[5] = { 0.1, 0.25, 0.5, 0.7, 0.93 };
    double roots[JLT_BERNSTEIN_DEGREE_MAX];

    assert_int_equal(zeros_of(roots, zeros, 7), 5);
    for (unsigned i = 0; i < 5; i++) assert_near(roots[i], expected[i], 1e-11);
}

/* b = -1, 2, -2, 1 vanishes at 1/2 exactly, in arithmetic too; with u = theta/(1 - theta) it is (u - 1)(u^2 - 5 u + 1). */
static void a_zero_at_the_cut_is_found_once(void **unused)
{
    (void)unused;
    const double b[4] = { -1, 2, -2, 1 };
    double roots[JLT_BERNSTEIN_DEGREE_MAX];

    assert_int_equal(jlt_bernstein_sign_changes(roots, b, 3), 3);
    for (unsigned i = 0; i < 3; i++) {
        const double u = i == 1 ? 1 : (5 + (i == 0 ? -1 : 1) * sqrt(21)) / 2;
        assert_near(roots[i], u / (1 + u), 1e-15);
    }
}

/* (theta - 1/2)(theta - 7/16), exactly: where a zero at 1/2 leads to another cut, that one may be a zero as well. Rounding 1e-16
 * over the slope 1/16. */
static void zeros_at_two_cuts_are_two(void **unused)
{
    (void)unused;
    const double b[3] = { 0.21875, -0.25, 0.28125 };
    double roots[JLT_BERNSTEIN_DEGREE_MAX];

    assert_int_equal(jlt_bernstein_sign_changes(roots, b, 2), 2);
    assert_near(roots[0], 0.4375, 1e-14);
    assert_near(roots[1], 0.5, 1e-14);
}

/* A pair 2e-6 apart: each zero to sqrt-like accuracy, rounding 1e-16 over the slope 2e-6. */
static void two_near_zeros_are_two_and_a_double_zero_is_none(void **unused)
{
    (void)unused;
    const double near[3] = { 0.3 - 1e-6, 0.3 + 1e-6, 2 }, twice[4] = { 0.375, 0.375, 0.8, 2 }, complex_pair[3] = { 2, 3, -1 };
    double roots[JLT_BERNSTEIN_DEGREE_MAX];

    assert_int_equal(zeros_of(roots, near, 3), 2);
    assert_near(roots[0], 0.3 - 1e-6, 1e-9);
    assert_near(roots[1], 0.3 + 1e-6, 1e-9);
    assert_int_equal(zeros_of(roots, twice, 4), 1);
    assert_near(roots[0], 0.8, 1e-14);
    assert_int_equal(zeros_of(roots, complex_pair, 3), 0);
}

static void zeros_at_the_ends_belong_to_nobody(void **unused)
{
    (void)unused;
    const double zeros[3] = { 0, 1, 0.4 };
    double roots[JLT_BERNSTEIN_DEGREE_MAX];

    assert_int_equal(zeros_of(roots, zeros, 3), 1);
    assert_near(roots[0], 0.4, 1e-15);
}

/* With u = theta/(1 - theta) it is 0.486 + 3 u^2 - 4 u^3, whose one zero u > 0 is 0.9; the control polygon's zero, theta = 1/3, is
 * u = 1/2, where its slope is 0. Condition number near 1. */
static void a_first_guess_at_an_extremum_is_left(void **unused)
{
    (void)unused;
    const double b[4] = { 0.486, 0, 1, -4 };
    double root;

    assert_int_equal(jlt_bernstein_sign_changes(&root, b, 3), 1);
    assert_near(root, 9.0 / 19, 1e-14);
}

/* Products of two such coefficients underflow. */
static void signs_of_tiny_coefficients_count(void **unused)
{
    (void)unused;
    const double b[4] = { -0.1e-170, -0.2e-170, -0.1e-170, 3e-170 };
    double root;

    assert_int_equal(jlt_bernstein_sign_changes(&root, b, 3), 1);
    assert_true(jlt_bernstein_value(b, 3, root - 1e-9) < 0 && jlt_bernstein_value(b, 3, root + 1e-9) > 0);
}

/* theta^3/3 - 0.35 theta^2 + 0.343/6 has its minimum, 0, at 0.7, and a slope of 0 at 0. */
static void a_flat_beginning_hides_no_touch(void **unused)
{
    (void)unused;
    const double c[4] = { 0.343 / 6, 0, -0.35, 1.0 / 3 };
    double b[4], at[4];

    jlt_bernstein_of(b, c, 1, 3);
    assert_int_equal(jlt_bernstein_touches(at, b, 3, 1e-9), 1);
    assert_near(at[0], 0.7, 1e-8);
}

static void dividing_by_theta_and_deriving_match_the_coefficients(void **unused)
{
    (void)unused;
    const double c[5] = { 0, 3, -7, 2, 5 };
    double b[5], d[4];

    jlt_bernstein_of(b, c, 1, 4);
    jlt_bernstein_derive(d, b, 4);
    assert_near(jlt_bernstein_value(d, 3, 0.3), 3 - 14 * 0.3 + 6 * 0.09 + 20 * 0.027, 1e-14);
    jlt_bernstein_deflate(b, 4);
    assert_near(jlt_bernstein_value(b, 3, 0.3), 3 - 7 * 0.3 + 2 * 0.09 + 5 * 0.027, 1e-14);
}

/* (theta - 0.3)^2 (theta - 0.7)^2 (theta + 1) + lift has minima of value lift at 0.3 and 0.7, and a maximum of 2.4e-3 between
 * them. Simple zeros of the slope, whose derivative there is 0.4: 1e-8 is far above rounding. */
static void touches_are_the_extrema_within_the_bound_and_no_others(void **unused)
{
    (void)unused;
    const double zeros[5] = { 0.3, 0.3, 0.7, 0.7, -1 };
    double c[6], b[6], at[5];
    from_zeros(c, zeros, 5, 1);
    for (int side = -1; side <= 1; side += 2) {
        const double lift = side * 1e-7;
        jlt_bernstein_of(b, c, 1, 5);
        for (unsigned j = 0; j <= 5; j++) b[j] += lift;
        assert_int_equal(jlt_bernstein_touches(at, b, 5, 0.5e-7), 0);
        assert_int_equal(jlt_bernstein_touches(at, b, 5, 1.5e-7), 2);
        assert_near(at[0], 0.3, 1e-8);
        assert_near(at[1], 0.7, 1e-8);
        assert_int_equal(jlt_bernstein_touches(at, b, 5, 1), 3);
        assert_true(at[1] > 0.4 && at[1] < 0.6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_simple_zeros_inside_are_found_in_order),
        cmocka_unit_test(a_zero_at_the_cut_is_found_once),
        cmocka_unit_test(zeros_at_two_cuts_are_two),
        cmocka_unit_test(two_near_zeros_are_two_and_a_double_zero_is_none),
        cmocka_unit_test(zeros_at_the_ends_belong_to_nobody),
        cmocka_unit_test(touches_are_the_extrema_within_the_bound_and_no_others),
        cmocka_unit_test(a_first_guess_at_an_extremum_is_left),
        cmocka_unit_test(signs_of_tiny_coefficients_count),
        cmocka_unit_test(a_flat_beginning_hides_no_touch),
        cmocka_unit_test(dividing_by_theta_and_deriving_match_the_coefficients),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
