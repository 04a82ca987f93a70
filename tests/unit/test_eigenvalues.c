/* Characteristic polynomials, closed forms and deflation on matrices whose eigenvalues are known. */
#include "unit/check.h"

#include "analysis/charpoly.h"
#include "analysis/deflation.h"
#include "analysis/linearization.h"
#include "analysis/quadratic.h"
#include "core/random.h"
#include "ext/arpack.h"
#include "ext/eigen.h"
#include "ext/quadrature.h"
#include "kernel/descriptor.h"

#include <gsl/gsl_errno.h>

#include <float.h>

/* Oracle: integer arithmetic, exact here. The companion matrix of a polynomial gives it back. */
static void faddeev_leverrier_returns_the_polynomial_of_a_companion_matrix(void **unused)
{
    static const double c[6] = { 1, -3, 7, 0, 2, -11 };
    double a[25] = { 0 }, computed[6], scale[6];

    (void)unused;
    for (int j = 0; j < 5; j++) a[j] = -c[j + 1];
    for (int i = 1; i < 5; i++) a[i * 5 + i - 1] = 1.0;
    assert_int_equal(jlt_charpoly_faddeev_leverrier(computed, scale, a, NULL, 5), JLT_OK);
    for (int k = 0; k < 6; k++) assert_true(computed[k] == c[k]);
    /* The same with entries near the ends of the range: the work is scaled, so only the result may overflow. */
    for (int i = 0; i < 25; i++) a[i] = ldexp(a[i], -180);
    assert_int_equal(jlt_charpoly_faddeev_leverrier(computed, NULL, a, NULL, 5), JLT_OK);
    for (int k = 0; k < 6; k++) assert_true(computed[k] == ldexp(c[k], -180 * k));
    for (int i = 0; i < 25; i++) a[i] = ldexp(a[i], 180 + 500);
    assert_int_equal(jlt_charpoly_faddeev_leverrier(computed, NULL, a, NULL, 5), JLT_ERR_NONFINITE);
}

/* Oracle: long double. Tolerance: the bound that the header derives, which must also be of the right order. */
static void faddeev_leverrier_errs_less_than_its_bound(void **unused)
{
    jlt_random random;
    double worst = 0.0;

    (void)unused;
    jlt_random_seed(&random, 3);
    for (int trial = 0; trial < 2000; trial++) {
        double a[25], computed[6], scale[6];
        long double m[25] = { 0 }, next[25], exact[6] = { 1 };
        for (int i = 0; i < 25; i++)
            a[i] = jlt_random_magnitude(&random, -3, 3) * (jlt_random_below(&random, 2) == 0 ? 1 : -1);
        assert_int_equal(jlt_charpoly_faddeev_leverrier(computed, scale, a, NULL, 5), JLT_OK);
        for (int i = 0; i < 5; i++) m[i * 6] = 1;
        for (int k = 1; k <= 5; k++) {
            long double trace = 0;
            for (int i = 0; i < 5; i++)
                for (int j = 0; j < 5; j++) {
                    next[i * 5 + j] = 0;
                    for (int l = 0; l < 5; l++) next[i * 5 + j] += a[i * 5 + l] * m[l * 5 + j];
                }
            for (int i = 0; i < 5; i++) trace += next[i * 6];
            exact[k] = -trace / k;
            memcpy(m, next, sizeof m);
            for (int i = 0; i < 5; i++) m[i * 6] += exact[k];
            const double part = fabs((double)(computed[k] - exact[k])) / (k * 8 * (DBL_EPSILON / 2) * scale[k]);
            assert_true(part <= 1.0);
            worst = fmax(worst, part);
        }
    }
    assert_true(worst > 1e-3);
}

/* A determinant that underflows beside an eigenvalue of size 1 would leave the other without a digit. */
static void quadratic_eigenvalues_lost_in_underflow_are_refused(void **unused)
{
    static const double none[4] = { 0 },
                        lost[3][4] = { { 1, 0, 0, 1e-300 }, { 1, 1e-200, 1e-200, 1e-300 }, { 1, 1e-160, -1e-160, 1e-300 } };
    double re[2] = { 7, 7 }, im[2] = { 7, 7 }, error[2] = { 7, 7 };

    (void)unused;
    for (int i = 0; i < 3; i++) {
        assert_int_equal(jlt_quadratic_eigenvalues(re, im, error, lost[i], none), JLT_ERR_NONFINITE);
        for (int k = 0; k < 2; k++) assert_true(re[k] == 7 && im[k] == 7 && error[k] == 7);
    }
}

/* Oracle: long double closed form, the determinant by exact products. */
static void quadratic_eigenvalues_keep_their_digits_across_scales(void **unused)
{
    static const double none[4] = { 0 };
    jlt_random random;

    (void)unused;
    jlt_random_seed(&random, 4);
    for (int trial = 0; trial < 20000; trial++) {
        double b[4], re[2], im[2], error[2];
        for (int i = 0; i < 4; i++)
            b[i] = jlt_random_below(&random, 6) == 0
                       ? 0.0
                       : jlt_random_magnitude(&random, -30, 30) * (jlt_random_below(&random, 2) == 0 ? 1 : -1);
        assert_int_equal(jlt_quadratic_eigenvalues(re, im, error, b, none), JLT_OK);
        const long double half = ((long double)b[0] - b[3]) / 2, middle = ((long double)b[0] + b[3]) / 2;
        const long double discriminant = half * half + (long double)b[1] * b[2];
        long double expected_re[2], expected_im = 0;
        if (discriminant < 0) {
            expected_re[0] = expected_re[1] = middle;
            expected_im = sqrtl(-discriminant);
        } else {
            const long double larger = middle < 0 ? middle - sqrtl(discriminant) : middle + sqrtl(discriminant);
            const long double smaller =
                larger == 0 ? 0 : ((long double)b[0] * b[3] - (long double)b[1] * b[2]) / larger;
            expected_re[0] = larger < smaller ? larger : smaller;
            expected_re[1] = larger < smaller ? smaller : larger;
        }
        for (int i = 0; i < 2; i++) {
            const long double off = hypotl(re[i] - expected_re[i], fabs(im[i]) - expected_im);
            /* Long double carries 11 bits more, of which a cancelling determinant loses as many as double does. */
            const long double slack = 0x1p-60L * (hypotl(expected_re[i], expected_im) +
                                                  (discriminant < 0 ? 0 : fabsl(half) * fabsl(half) / (fabsl(middle) + 1e-300L)));
            if (off > error[i] + slack) fail_msg("trial %d: off by %Lg, bound %g", trial, off, error[i]);
        }
    }
}

/* A rotation in the plane of two coordinates, applied to the matrix and to the gradients. */
static void rotate(double *a, double *w, size_t rows, size_t p, size_t q, double angle)
{
    const double c = cos(angle), s = sin(angle);

    for (size_t j = 0; j < 5; j++) {
        const double x = a[p * 5 + j], y = a[q * 5 + j];
        a[p * 5 + j] = c * x - s * y;
        a[q * 5 + j] = s * x + c * y;
    }
    for (size_t i = 0; i < 5; i++) {
        const double x = a[i * 5 + p], y = a[i * 5 + q];
        a[i * 5 + p] = c * x - s * y;
        a[i * 5 + q] = s * x + c * y;
    }
    for (size_t i = 0; i < rows; i++) {
        const double x = w[i * 5 + p], y = w[i * 5 + q];
        w[i * 5 + p] = c * x - s * y;
        w[i * 5 + q] = s * x + c * y;
    }
}

/* The matrix (4.5) without spin, in rotated coordinates so that no zero shows: eigenvalues 0 (four, in a Jordan block of
 * two) and the trace. A general solver returns zero with an error of the order of the square root of the rounding unit; the
 * deflated route must stay within a few units. */
static void deflation_keeps_all_digits_of_a_defective_zero_where_qr_loses_half(void **unused)
{
    static const double trace = -0.139152854432113;
    double a[25] = { 0 }, w[15] = { 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0.38, -0.1 };
    double re[5], im[5], qr_worst = 0.0, worst = 0.0;
    jlt_deflation d;
    int zeros = 0;

    (void)unused;
    a[0 * 5 + 2] = 0.95;
    a[3 * 5 + 3] = trace;
    a[4 * 5 + 3] = trace * 3.8;
    w[2 * 5 + 3] = 3.8 * 0.1;
    for (size_t k = 0; k < 8; k++)
        rotate(a, w, 3, k % 5, (3 * k + 1) % 5 == k % 5 ? (k + 1) % 5 : (3 * k + 1) % 5, 0.3 + 0.41 * (double)k);
    assert_int_equal(jlt_eigen_values(re, im, a, 5), JLT_OK);
    assert_int_equal(jlt_deflation_compute(&d, a, NULL, 5, w, NULL, 3), JLT_OK);
    for (int i = 0; i < 5; i++) {
        double size = hypot(re[i], im[i]);
        if (fabs(re[i] - trace) > 0.1) qr_worst = fmax(qr_worst, size);
        size = hypot(d.values[i].re, d.values[i].im);
        if (d.values[i].source >= 0) {
            assert_true(size == 0.0);
            zeros++;
        } else {
            worst = fmax(worst, fmin(size, fabs(d.values[i].re - trace)));
        }
    }
    print_message("defective zero: QR off by %.2g, deflated by %.2g\n", qr_worst, worst);
    assert_int_equal(zeros, 3);
    /* Rounding has made the zero one of 1e-16 at most, and a matrix so near may have no Jordan block. */
    assert_true(d.doubtful_zero && !d.defective_zero);
    assert_true(qr_worst > 1e-10);
    assert_true(worst < 64 * DBL_EPSILON);
    assert_true(d.plain_difference > 1e-10);
}

/* Dependent gradients, also dependent only to rounding, count once; a vector that is no left null vector at all must not be
 * deflated by. */
static void dependent_gradients_are_not_counted_twice(void **unused)
{
    double a[9] = { 0, 0, 0, 1, -2, 5, 2, -5, -2 };
    double w[9] = { 1, 0, 0, 3, 1e-16, -2e-16, 2, 1e-17, 0 };
    jlt_deflation d;

    (void)unused;
    assert_int_equal(jlt_deflation_compute(&d, a, NULL, 3, w, NULL, 3), JLT_OK);
    assert_int_equal(d.kept, 2);
    assert_int_equal(d.values[0].source, 0);
    /* lambda = -2 +- 5i, by hand. */
    assert_true(fabs(d.values[1].re + 2) < 1e-15 && fabs(d.values[1].im + 5) < 1e-15);
    assert_true(fabs(d.values[2].re + 2) < 1e-15 && fabs(d.values[2].im - 5) < 1e-15);
}

/* Oracle: a diagonal matrix, rotated; condition numbers of a symmetric matrix are one. */
static void condition_numbers_are_one_for_symmetric_matrices(void **unused)
{
    double a[25] = { 0 }, w[5] = { 1, 0, 0, 0, 0 };
    jlt_deflation d;

    (void)unused;
    for (int i = 1; i < 5; i++) a[i * 6] = i * i;
    for (size_t k = 0; k < 6; k++) rotate(a, w, 1, k % 5, (k + 2) % 5, 0.2 + 0.5 * (double)k);
    assert_int_equal(jlt_deflation_compute(&d, a, NULL, 5, w, NULL, 1), JLT_OK);
    for (int i = 0; i < 5; i++) {
        assert_true(fabs(d.values[i].re - i * i) < 1e-13);
        if (i > 0) assert_true(fabs(d.values[i].condition - 1.0) < 1e-9);
    }
    assert_true(d.arpack_difference < 1e-13);
}

/* By hand: [[1, k], [0, 2]] has eigenvectors (1, 0), (k, 1) and left (1, -k), (0, 1): condition sqrt(1 + k^2). */
static void condition_numbers_of_a_triangular_matrix_are_those_by_hand(void **unused)
{
    const double a[4] = { 1, 1000, 0, 2 };
    jlt_deflation d;

    (void)unused;
    assert_int_equal(jlt_deflation_compute(&d, a, NULL, 2, NULL, NULL, 0), JLT_OK);
    for (int i = 0; i < 2; i++) assert_true(fabs(d.values[i].condition / sqrt(1.0 + 1e6) - 1.0) < 1e-9);
}

/* One number that is not finite, wherever it stands: in the matrix, in gradients, or in the bounds of either. */
static void what_is_not_finite_is_refused_wherever_it_stands(void **unused)
{
    const double wrong[] = { NAN, INFINITY, -INFINITY };
    const size_t sizes[4] = { 4, 4, 2, 2 };

    (void)unused;
    for (size_t argument = 0; argument < 4; argument++)
        for (size_t at = 0; at < sizes[argument]; at++)
            for (size_t k = 0; k < 3; k++) {
                double a[4] = { 0, 1, 0, 2 }, error[4] = { 1e-16, 1e-16, 1e-16, 1e-16 }, w[2] = { 2, -1 }, w_error[2] = { 0, 0 };
                double *const arguments[] = { a, error, w, w_error };
                jlt_deflation d;
                assert_int_equal(jlt_deflation_compute(&d, a, error, 2, w, w_error, 1), JLT_OK);
                arguments[argument][at] = wrong[k];
                assert_int_equal(jlt_deflation_compute(&d, a, error, 2, w, w_error, 1), JLT_ERR_NONFINITE);
            }
}

/* Fills the stack that the next call uses, so that what is read there before it is written is no address. */
static int scribble(void)
{
    volatile unsigned char room[16384];
    for (size_t i = 0; i < sizeof room; i++) room[i] = 0xa5;
    return room[77];
}

static void a_model_of_too_many_states_is_refused(void **unused)
{
    const jlt_descriptor *full = jlt_descriptor_find("spherical_top_full", NULL, NULL, NULL);
    const double params[] = { 1, 1, 1, 0.5, 1, 1 }, x[JLT_LINEARIZATION_SIZE_MAX + 1] = { 0 };
    static jlt_linearization result;
    jlt_descriptor wide;

    (void)unused;
    assert_non_null(full);
    wide = *full;
    wide.state_count = JLT_LINEARIZATION_SIZE_MAX + 1;
    assert_int_equal(scribble(), 0xa5);
    assert_int_equal(jlt_linearization_residual(&result, &wide, params, x), JLT_ERR_UNSUPPORTED);
    assert_int_equal(scribble(), 0xa5);
    assert_int_equal(jlt_linearization_compute(&result, &wide, params, x, NULL, NULL, NULL), JLT_ERR_UNSUPPORTED);
}

static void wrong_arguments_of_outside_solvers_are_statuses(void **unused)
{
    double re[5], im[5], a[25] = { NAN };
    size_t found;

    (void)unused;
    assert_int_equal(jlt_eigen_values(re, im, a, 5), JLT_ERR_NONFINITE);
    assert_int_equal(jlt_arpack_largest(re, im, &found, a, 5, 1), JLT_ERR_NONFINITE);
    assert_int_equal(jlt_arpack_largest(re, im, &found, a, 5, 4), JLT_ERR_ARG);
    assert_int_equal(jlt_arpack_largest(re, im, &found, a, 2, 1), JLT_ERR_ARG);
    assert_int_equal(jlt_eigen_least_squares(re, a, im, 5, 5, 0.0), JLT_ERR_NONFINITE);
    assert_int_equal(jlt_charpoly_faddeev_leverrier(re, NULL, a, NULL, 0), JLT_ERR_ARG);
}

static jlt_status inverse_root(void *context, double *value, double at)
{
    (void)context;
    *value = 1.0 / sqrt(at);
    return JLT_OK;
}

static jlt_status failing(void *context, double *value, double at)
{
    (void)context;
    (void)value;
    return at > 0.5 ? JLT_ERR_DOMAIN : JLT_OK;
}

static void quadrature_is_exact_to_its_estimate_and_passes_failures_on(void **unused)
{
    double value = 0.0, error = 0.0;

    (void)unused;
    assert_int_equal(jlt_quadrature_integrate(&value, &error, inverse_root, NULL, 0.0, 1.0, 0.0, 1e-12), JLT_OK);
    assert_true(fabs(value - 2.0) <= error + 4 * DBL_EPSILON && error < 1e-10);
    assert_int_equal(jlt_quadrature_integrate(&value, &error, failing, NULL, 0.0, 1.0, 0.0, 1e-12), JLT_ERR_DOMAIN);
}

/* The balanced top with I1 = 2^-170: the gradients of G and F0 differ by one part in 2^170 alone, but the zeros stand in
 * empty columns. Oracle: lambda^2 - q lambda + k I3 w/I1 = 0, whose discriminant is negative. Budget: eight roundings of
 * entries and two of the closed form, in each part by itself. */
static void nearly_dependent_gradients_do_not_spoil_what_stands_in_the_matrix(void **unused)
{
    (void)unused;
    const double I1 = 0x1p-170, I3 = 0.25, c = 0.6, s = 0.8, v = 0.7, w = 1.1;
    const double theta = I1 * I3 + I1 * s * s + I3 * c * c;
    const double k = I3 * w * (I3 + 1) / theta, q = -I3 * c * v / (s * theta), u = -I1 * v / theta;
    const double a[25] = {
        [2] = s, [8] = w, [13] = -I3 * w / I1, [17] = k, [18] = q, [22] = c * s * w * (I1 - I3) / theta, [23] = u
    };
    const double slope = 2 * (I1 - I3) * c * w * w * (I3 - I1), gradients[15] = {
        -c * w * w, v, 0, c * s * w, (I3 + s * s) * w,
        -I3 * w, 0, 0, I1 * s, -I3 * c,
        slope, 2 * I1 * I1 * v, 2 * I1 * I1 * v, 0, 2 * (I1 - I3) * theta * w };
    jlt_deflation d;

    assert_int_equal(jlt_deflation_compute(&d, a, NULL, 5, gradients, NULL, 3), JLT_OK);
    assert_int_equal(d.kept, 2);
    assert_true(fabs(d.values[3].re - q / 2) <= 10 * DBL_EPSILON * fabs(q));
    assert_true(fabs(fabs(d.values[3].im) / sqrt(k * I3 * w / I1) - 1.0) <= 10 * DBL_EPSILON);
    assert_true(d.values[4].im == -d.values[3].im);
}

/* An oscillator in a rotating frame, x'' = -q x + k y', y'' = -q y - k x': lambda = +-i (sqrt(k^2/4 + q) +- k/2). In coordinates
 * scaled by sqrt(q), from 1/2 to 2, the matrix is normal: no error is above twice that of a backward stable algorithm. GSL's QR
 * misses one in 400 of these by much more, some altogether. */
static void eigenvalues_of_oscillators_in_a_rotating_frame_keep_their_digits(void **unused)
{
    (void)unused;
    for (int i = 0; i < 100; i++)
        for (int j = 0; j < 100; j++) {
            const double q = 0.25 + i * 3.75 / 99, k = 0.1 + j * 9.9 / 99, large = sqrt(k * k / 4 + q) + k / 2, small = q / large;
            const double a[16] = { 0, 0, 1, 0, 0, 0, 0, 1, -q, 0, 0, k, 0, -q, -k, 0 };
            const double bound = 2 * (10 * 4 * DBL_EPSILON / 2) * sqrt(2 * (1 + q * q + k * k));
            double re[4], im[4];
            int larger = 0;
            assert_int_equal(jlt_eigen_values(re, im, a, 4), JLT_OK);
            for (int m = 0; m < 4; m++) {
                const bool far = fabs(fabs(im[m]) - large) < fabs(fabs(im[m]) - small);
                larger += far;
                assert_true(hypot(re[m], fabs(im[m]) - (far ? large : small)) <= bound);
            }
            assert_int_equal(larger, 2);
        }
}

/* Threads call GSL at once: a handler put back by one would be on under another. */
static void gsl_has_no_handler_between_calls(void **unused)
{
    static const double a[] = { 1, 2, 3, 4 };
    double norm;

    (void)unused;
    assert_int_equal(jlt_eigen_norm(&norm, a, 2), JLT_OK);
    assert_ptr_equal(gsl_set_error_handler_off(), gsl_set_error_handler_off());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faddeev_leverrier_returns_the_polynomial_of_a_companion_matrix),
        cmocka_unit_test(faddeev_leverrier_errs_less_than_its_bound),
        cmocka_unit_test(quadratic_eigenvalues_lost_in_underflow_are_refused),
        cmocka_unit_test(quadratic_eigenvalues_keep_their_digits_across_scales),
        cmocka_unit_test(deflation_keeps_all_digits_of_a_defective_zero_where_qr_loses_half),
        cmocka_unit_test(nearly_dependent_gradients_do_not_spoil_what_stands_in_the_matrix),
        cmocka_unit_test(dependent_gradients_are_not_counted_twice),
        cmocka_unit_test(condition_numbers_are_one_for_symmetric_matrices),
        cmocka_unit_test(condition_numbers_of_a_triangular_matrix_are_those_by_hand),
        cmocka_unit_test(what_is_not_finite_is_refused_wherever_it_stands),
        cmocka_unit_test(a_model_of_too_many_states_is_refused),
        cmocka_unit_test(wrong_arguments_of_outside_solvers_are_statuses),
        cmocka_unit_test(quadrature_is_exact_to_its_estimate_and_passes_failures_on),
        cmocka_unit_test(eigenvalues_of_oscillators_in_a_rotating_frame_keep_their_digits),
        cmocka_unit_test(gsl_has_no_handler_between_calls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
