/* Recurrences of the exponential and the logarithm of a power series, against Arb's series at 256 bits.
 *
 * Tolerance: the radius to which the same recurrence grows in 53-bit balls, which bounds what rounding does to it, and twice that
 * as doubles add in another order; C's exp and log at order 0 are given one unit in the last place, as glibc's have. */
#include "unit/check.h"

#include "ball/ball.h"
#include "base/random.h"
#include "kernel_jet.h"

#if __has_include(<flint/arb_poly.h>)
#include <flint/arb_poly.h>
#else
#include <arb_poly.h>
#endif

enum { ORDER = 24, ROUNDS = 200, FINE = 256, COARSE = 53 };

static uint64_t random_state = 24;

/* In [0, 1). */
static double draw(void)
{
    return (double)(ttc_random_bits(&random_state) >> 11) * 0x1p-53;
}

static void add_ulp(arb_t ball)
{
    mag_t radius;
    mag_init(radius);
    arb_get_mag(radius, ball);
    mag_mul_2exp_si(radius, radius, 1 - COARSE);
    arb_add_error_mag(ball, radius);
    mag_clear(radius);
}

/* exp: k e_k = sum_j j a_j e_(k-j); log: k a_0 l_k = k a_k - sum_(j<k) j l_j a_(k-j); rounded to 53 bits at every operation. */
static void recurrence(arb_ptr out, arb_srcptr a, bool is_exp)
{
    arb_t term;
    arb_init(term);
    if (is_exp) arb_exp(out, a, COARSE);
    else arb_log(out, a, COARSE);
    add_ulp(out);
    for (unsigned long k = 1; k <= ORDER; k++) {
        for (unsigned long j = 1; j <= (is_exp ? k : k - 1); j++) {
            arb_mul_ui(term, is_exp ? a + j : out + j, j, COARSE);
            arb_mul(term, term, is_exp ? out + (k - j) : a + (k - j), COARSE);
            arb_add(out + k, out + k, term, COARSE);
        }
        arb_div_ui(out + k, out + k, k, COARSE);
        if (is_exp) continue;
        arb_sub(out + k, a + k, out + k, COARSE);
        arb_div(out + k, out + k, a, COARSE);
    }
    arb_clear(term);
}

static void compare(const double *found, arb_srcptr coarse, const arb_poly_t exact)
{
    arb_t error, bound;
    arb_init(error);
    arb_init(bound);
    for (long k = 0; k <= ORDER; k++) {
        arb_poly_get_coeff_arb(bound, exact, k);
        arb_set_d(error, found[k]);
        arb_sub(error, error, bound, FINE);
        arb_abs(error, error);
        arb_set_interval_mag(bound, arb_radref(coarse + k), arb_radref(coarse + k), FINE);
        arb_mul_2exp_si(bound, bound, 1);
        assert_true(arb_le(error, bound));
    }
    arb_clear(bound);
    arb_clear(error);
}

static void check(bool is_exp)
{
    double a[ORDER + 1], found[ORDER + 1];
    arb_poly_t series, exact;
    arb_ptr balls = _arb_vec_init(ORDER + 1), coarse = _arb_vec_init(ORDER + 1);
    arb_poly_init(series);
    arb_poly_init(exact);
    for (int round = 0; round < ROUNDS; round++) {
        arb_poly_zero(series);
        for (long k = 0; k <= ORDER; k++) {
            a[k] = k == 0 && !is_exp ? 0.01 + 3 * draw() : 4 * draw() - 2;
            arb_set_d(balls + k, a[k]);
            arb_poly_set_coeff_arb(series, k, balls + k);
        }
        for (unsigned k = 0; k <= ORDER; k++) found[k] = is_exp ? jlt_jet_exp(a, found, k) : jlt_jet_log(a, found, k);
        if (is_exp) arb_poly_exp_series(exact, series, ORDER + 1, FINE);
        else arb_poly_log_series(exact, series, ORDER + 1, FINE);
        _arb_vec_zero(coarse, ORDER + 1);
        recurrence(coarse, balls, is_exp);
        compare(found, coarse, exact);
    }
    arb_poly_clear(exact);
    arb_poly_clear(series);
    _arb_vec_clear(coarse, ORDER + 1);
    _arb_vec_clear(balls, ORDER + 1);
}

static void the_exponential_of_a_series_is_that_of_arb(void **unused)
{
    (void)unused;
    check(true);
}

static void the_logarithm_of_a_series_is_that_of_arb(void **unused)
{
    (void)unused;
    check(false);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_exponential_of_a_series_is_that_of_arb),
        cmocka_unit_test(the_logarithm_of_a_series_is_that_of_arb),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
