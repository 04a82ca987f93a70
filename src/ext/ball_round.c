/* Rounds balls to the nearest doubles, and computes condition numbers of eigenvalues. */
#include "ext/ball_problem.h"

#include <math.h>

enum { CONDITION_BITS = 60 };

/* The condition number |x| |y| / |y^H x| of a simple eigenvalue with right and left eigenvectors x and y. The product of A - mu
 * over all other eigenvalues mu is a multiple of x y^H, so the number is its Frobenius norm divided by |trace|. *sure becomes
 * false if the ball has fewer than 60 accurate bits. A multiple eigenvalue gives NaN, or INFINITY if it is defective.
 * zeros: the factors of the eigenvalues zero, A^(n - count). */
static double condition(bool *sure, const jlt_ball_problem *p, const arb_mat_t zeros, slong which)
{

    if (p->kinds[which].multiplicity > 1) return p->kinds[which].semisimple ? NAN : INFINITY;
    JLT_SCOPED_MATRIX(acb, p->n, p->n, product, factor);
    JLT_SCOPED(acb, trace);
    JLT_SCOPED(arb, size, ratio);
    acb_mat_set_arb_mat(product, zeros);
    for (slong i = 0, factors = p->n - p->count; i < p->count; i++) {
        if (i == which) continue;
        acb_mat_set_arb_mat(factor, p->a);
        for (slong j = 0; j < p->n; j++)
            acb_sub(acb_mat_entry(factor, j, j), acb_mat_entry(factor, j, j), p->roots + i, p->precision);
        if (factors++ == 0) acb_mat_swap(product, factor);
        else acb_mat_mul(product, product, factor, p->precision);
    }
    acb_mat_trace(trace, product, p->precision);
    acb_abs(ratio, trace, p->precision);
    acb_mat_frobenius_norm(size, product, p->precision);
    arb_div(ratio, size, ratio, p->precision);
    *sure = *sure && arb_rel_accuracy_bits(ratio) >= CONDITION_BITS;
    return arb_is_finite(ratio) ? arf_get_d(arb_midref(ratio), ARF_RND_NEAR) : NAN;
}

/* Conjugate eigenvalues of a real matrix have the same condition number. */
static bool conjugate(const acb_t a, const acb_t b)
{
    JLT_SCOPED(acb, mirrored);

    acb_conj(mirrored, b);
    return acb_equal(a, mirrored);
}

/* The nearest double, or zero if the ball contains zero; *error grows by the distance from it to the farthest point of the ball.
 * *sure becomes false unless all numbers in the ball have the same nearest double. */
static double rounded(double *error, bool *sure, arb_srcptr ball, slong precision)
{
    const double value = arb_contains_zero(ball) ? 0.0 : arf_get_d(arb_midref(ball), ARF_RND_NEAR);

    if (arb_is_zero(ball)) return value;
    JLT_SCOPED(arb, distance);
    JLT_SCOPED(arf, low, high);
    JLT_SCOPED(mag, bound);

    arb_get_interval_arf(low, high, ball, precision + 2 * MAG_BITS);
    if (arb_contains_zero(ball)) *sure = false;
    else *sure = *sure && !(arf_get_d(low, ARF_RND_NEAR) < arf_get_d(high, ARF_RND_NEAR));
    arb_set_d(distance, value);
    arb_sub(distance, ball, distance, 64);
    arb_get_mag(bound, distance);
    *error += mag_get_d(bound);
    return value;
}

bool jlt_ball_problem_round(jlt_ball_spectrum *s, bool *sure, const jlt_ball_problem *p)
{
    double unused = 0.0;
    bool finite = true;

    *sure = true;
    JLT_SCOPED(arb, trace);
    arb_neg(trace, arb_poly_get_coeff_ptr(p->charpoly, p->n - 1));
    s->trace_error = 0.0;
    s->trace = rounded(&s->trace_error, sure, trace, p->precision);
    for (slong i = 0; i < p->n * p->n; i++) {
        s->jacobian[i] = rounded(&unused, sure, arb_mat_entry(p->a, i / p->n, i % p->n), p->precision);
        finite = finite && isfinite(s->jacobian[i]);
    }
    for (size_t k = 0; k <= s->n; k++) {
        s->charpoly_error[k] = 0.0;
        s->charpoly[k] = rounded(&s->charpoly_error[k], sure, arb_poly_get_coeff_ptr(p->charpoly, (slong)(s->n - k)), p->precision);
        finite = finite && isfinite(s->charpoly[k]);
    }
    JLT_SCOPED_MATRIX(arb, p->n, p->n, zeros);
    arb_mat_pow_ui(zeros, p->a, (ulong)(p->n - p->count), p->precision);
    for (slong i = 0; i < p->count; i++) {
        jlt_ball_eigenvalue *value = &s->values[i];
        const bool mirrored = i > 0 && conjugate(p->roots + i, p->roots + i - 1);
        *value = (jlt_ball_eigenvalue){ .condition = mirrored ? value[-1].condition : condition(sure, p, zeros, i) };
        value->re = rounded(&value->error, sure, acb_realref(p->roots + i), p->precision);
        value->im = rounded(&value->error, sure, acb_imagref(p->roots + i), p->precision);
        finite = finite && isnormal(hypot(value->re, value->im));
    }
    return finite;
}
