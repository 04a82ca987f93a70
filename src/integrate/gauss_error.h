/** The error of a step by Gauss collocation, from its polynomial of f alone.
 *
 *  Let a_k be the coefficients of f on the step in Legendre polynomials, n_k their size relative to the states times h. For
 *  analytic solutions n_k falls like r^k, and the quadrature at the end errs by the aliased part, ~ n_0 r^16. With r =
 *  (n_7/n_0)^(1/7), where n_0 is the largest of the first three, the estimate is n_7 r^9, proportional to h^17. Where the last
 *  two coefficients have fallen by less than r^2 from the two before, r is what they have fallen by. The polynomial inside the
 *  step errs by the part left out, n_8 ~ r n_7.
 *
 *  The slopes at both ends of the step, which are known, show n_8 anew: where the polynomial misses one by q r n_7, q > 1, r
 *  counts as r sqrt(q), but at most as 1. No node sees the fiftieth of a step before the first one, or behind the last: a rate
 *  that turns there, as where friction changes its sign, leaves all coefficients as they are. Where the polynomial misses a slope
 *  by more than is known of analytic solutions, the step errs by that over half a fiftieth of its length. A miss is ignored if it
 *  is no larger than what errors in the states, by rounding and unfinished sweeps, may move the slopes by: on the slow motion of a
 *  stiff problem, and where a difference has lost its digits, that is far above n_8. */
#ifndef JLT_INTEGRATE_GAUSS_ERROR_H
#define JLT_INTEGRATE_GAUSS_ERROR_H

#include "integrate/field.h"

/* Binary logarithms, but for `falls`: the next step waits for them, and quotients and roots would take most of the time. */
typedef struct {
    double local;    /* the error at the end, in tolerances; NaN where coefficients are not finite */
    double dense;    /* n_8 h, the error inside the step, relative to the states */
    double left_out; /* n_8 */
    double rate;     /* r */
    double units;    /* of h over the tolerance */
    bool falls;      /* the last coefficients fall as the others do */
} jlt_gauss_error;

/** sizes: shape (JLT_GAUSS_NODES,), binary logarithms of n_k/h. noise: the binary logarithm of the change of the slopes that errors
 *  in the states cause; coefficients below this that do not fall count as such errors. */
jlt_gauss_error jlt_gauss_error_of(const double *sizes, double h, double tolerance, double noise);

/* A step as it was made. Arrays have shape (columns,) but for legendre, (columns, JLT_GAUSS_NODES), and work, (2, columns). */
typedef struct {
    double h;
    const jlt_field *field;
    const double *legendre;
    const double *before, *after; /* the slopes at both ends, */
    const double *end;            /* the state where it leads, */
    const double *weights;        /* and the inverse sizes of the states */
    double *work;
    double rounding, left; /* what rounding alone, and with it unfinished sweeps, leave, relative to the states */
    unsigned columns;
} jlt_gauss_step;

/** Correct the error, which was made with noise INFINITY, for coefficients that do not fall. In: sizes, tolerance, as above.
 *  Returns the number of evaluations: 1 where they would limit steps, else 0. */
unsigned jlt_gauss_error_see_tail(jlt_gauss_error *io, const jlt_gauss_step *step, const double *sizes, double tolerance);

/** Correct both errors by the slopes at the ends. Returns the number of evaluations: 1 where a miss would limit steps, else 0. */
unsigned jlt_gauss_error_see_ends(jlt_gauss_error *io, const jlt_gauss_step *step);

/** Raise the error at the end to what a slope of size 2^miss, relative to the states, adds if it is missed all along the step.
 *  Returns the number of evaluations, as above. */
unsigned jlt_gauss_error_raise(jlt_gauss_error *io, const jlt_gauss_step *step, double miss);

#endif
