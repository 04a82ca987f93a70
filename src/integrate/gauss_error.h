/** The error of a step by Gauss collocation, from its polynomial of f alone.
 *
 *  Let a_k be the coefficients of f on the step in Legendre polynomials, n_k their size relative to the states times h. For
 *  analytic solutions n_k falls like r^k, and the quadrature at the end errs by the aliased part, ~ n_0 r^16. With
 *  r = (n_7/n_0)^(1/7), where n_0 is the largest of the first three, the estimate is n_7 r^9, proportional to h^17. Where the last
 *  two coefficients have fallen by less than r^2 from the two before, r is what they have fallen by. The polynomial inside the step
 *  errs by the part left out, n_8 ~ r n_7.
 *
 *  The slopes at both ends of the step, which are known, show n_8 anew: where the polynomial misses one by q r n_7, q > 1, r counts
 *  as r sqrt(q). No node sees the fiftieth of a step before the first one, or behind the last: a rate that turns there, as where
 *  friction changes its sign, leaves all coefficients as they are. Where the polynomial misses a slope by more than is known of
 *  analytic solutions, the step errs by that over half a fiftieth of its length.
 *
 *  Where slopes are known to fewer digits than states, as a cosine of a large phase, the last coefficients and the slopes at the
 *  ends show their errors alike: r then comes to no more than 1, and what they leave, and the estimate, is proportional to h. */
#ifndef JLT_INTEGRATE_GAUSS_ERROR_H
#define JLT_INTEGRATE_GAUSS_ERROR_H

/* Binary logarithms, as a next step waits for them, and quotients and roots would take most of the time. */
typedef struct {
    double local;      /* the error at the end, in tolerances; NaN where coefficients are not finite */
    double root;       /* no logarithm: local is proportional to h^(1/root) */
    double dense;      /* n_8 h, the error inside the step, relative to the states */
    double size, rate; /* n_0, r */
    double left_out;   /* n_8 */
    double units;      /* of h over the tolerance */
} jlt_gauss_error;

/** sizes: shape (JLT_GAUSS_NODES,), binary logarithms of n_k/h. */
jlt_gauss_error jlt_gauss_error_of(const double *sizes, double h, double tolerance);

/** Let the slopes at the ends correct both errors. legendre: shape (columns, JLT_GAUSS_NODES); before, after: the slopes, shape
 *  (columns,); weights: shape (columns,), the inverse sizes of the states. */
void jlt_gauss_error_see_ends(jlt_gauss_error *io, const double *legendre, const double *before, const double *after,
                              const double *weights, unsigned columns);

#endif
