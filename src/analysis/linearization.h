/** Computes a report on one equilibrium: residual, Jacobian, characteristic polynomial, trace, eigenvalues, stability, and whether
 *  it excludes an invariant measure. */
#ifndef JLT_ANALYSIS_LINEARIZATION_H
#define JLT_ANALYSIS_LINEARIZATION_H

#include "analysis/deflation.h"
#include "core/status.h"
#include "ext/ball_spectrum.h"
#include "kernel_abi.h"

#include <stdbool.h>

enum { JLT_LINEARIZATION_SIZE_MAX = JLT_DEFLATION_SIZE_MAX };

/* x counts as an equilibrium if one lies within `reach` of it: this tolerance times |x_j|, or times the distance of x_j from the
 * ends of its interval, whichever is less. Rounding of the states is always allowed for, up to a thousandth of that distance. But
 * the reach ends where slopes of the field differ from those at x by more than a third, or more than 128 roundings of the slopes at
 * x_j (1 +- 1/8). */
#define JLT_LINEARIZATION_TOLERANCE 1e-12

/* Stability of the linearized motion. */
typedef enum {
    JLT_STABLE,   /* every nonzero eigenvalue has a negative real part, and zero is semisimple */
    JLT_UNSTABLE, /* an eigenvalue has a positive real part, or one on the imaginary axis is defective: growth, at least linear */
    JLT_CENTRE,   /* no eigenvalue has a positive real part, none on the imaginary axis is defective; nonzero ones lie on it, or
                   * all are zero */
    JLT_UNDECIDED /* rounding errors leave it open */
} jlt_verdict;

/* What the spectrum proves of the nonlinear motion. UNSTABLE: an eigenvalue has a positive real part. ATTRACTED: all have negative
 * real parts. STABLE: all nonzero ones have, and all zeros are forced by integrals with independent gradients, so that each level
 * set nearby contains one equilibrium near this one, which attracts within it; or the model has two states and a pair on the
 * imaginary axis, and a reversor changes the sign of a state that is zero here, so that nearby orbits meet the axis of the other
 * state twice and are closed. Otherwise nothing follows (OPEN): a linear centre may be a weak focus, and an eigenvalue zero may
 * belong to x' = x^2. */
typedef enum { JLT_MOTION_OPEN, JLT_MOTION_ATTRACTED, JLT_MOTION_STABLE, JLT_MOTION_UNSTABLE } jlt_motion;

typedef struct {
    const jlt_descriptor *descriptor; /* the most special variant that holds for the parameters, whose kernels were used */
    const jlt_equilibria *family;     /* the family of the table on which the point lies, or NULL */
    size_t n;
    double residual;                  /* largest |f_i| */
    double residual_ratio;            /* largest JLT_LINEARIZATION_TOLERANCE |f_i| / sum_j |df_i/dx_j| reach_j, over all f_i that
                                       * are not exactly 0: x counts as an equilibrium if this is at most the tolerance */
    size_t integrals;                 /* number of proved integrals of the variant; 0 where one has a pole */
    double charpoly[JLT_LINEARIZATION_SIZE_MAX + 1]; /* monic, highest power first, Faddeev-LeVerrier; the coefficients that
                                                      * integrals force to be zero are exactly zero */
    double trace, trace_error;        /* the generated divergence */
    double trace_formula;             /* the table's formula; NaN if it has none */
    long precision;                   /* bits of the arithmetic that the eigenvalues were computed in */
    bool exists;                      /* balls prove the equilibrium; if not, x may be none, or one of trace zero */
    bool proved;                      /* the verdict is proved; if false, it is a first-order verdict in doubles, or UNDECIDED */
    bool sure;                        /* every number is proved to be the double nearest to the exact value */
    jlt_ball_texts *texts;            /* all numbers as decimals (jlt_ball_texts_destroy); NULL if not asked for */
    jlt_verdict verdict;
    jlt_motion motion;                /* proved, or OPEN */
    int obstructs;                    /* the trace differs from zero by more than its error, which excludes a smooth positive
                                       * density if the equilibrium exists; in doubles, the trace is that at the rounded x */
    jlt_deflation eigen;
    /* A sweep of many points keeps what is before these, and n eigenvalues. */
    double f[JLT_LINEARIZATION_SIZE_MAX];
    double reach[JLT_LINEARIZATION_SIZE_MAX]; /* (n,): how far from x_j an equilibrium may lie, see JLT_LINEARIZATION_TOLERANCE */
    double charpoly_error[JLT_LINEARIZATION_SIZE_MAX + 1];
    double charpoly_formula[JLT_LINEARIZATION_SIZE_MAX + 1]; /* the table's formula, made monic; NaN if it has none */
    const char *sources[JLT_LINEARIZATION_SIZE_MAX]; /* names of the integrals, indexed by jlt_eigenvalue.source */
    double jacobian[JLT_LINEARIZATION_SIZE_MAX * JLT_LINEARIZATION_SIZE_MAX]; /* row-major, shape (n, n) */
    jlt_named held[JLT_LINEARIZATION_SIZE_MAX]; /* shape (integrals,) */
    double gradients[JLT_LINEARIZATION_SIZE_MAX * JLT_LINEARIZATION_SIZE_MAX]; /* their gradients, shape (integrals, n) */
} jlt_linearization;

const char *jlt_linearization_verdict(jlt_verdict verdict); /* "stable", "unstable", "centre", "not settled" */
const char *jlt_linearization_motion(jlt_motion motion);    /* "asymptotically stable", "stable", "unstable", "not settled" */

/** Choose the variant, and compute the residual and what it needs. Out: f, residual, residual_ratio, reach, jacobian, gradients,
 *  integrals, held, descriptor, n of *result.
 *  Errors: as jlt_linearization_compute, but a large residual is no error. */
JLT_CHECKED jlt_status jlt_linearization_residual(jlt_linearization *result, const jlt_descriptor *descriptor,
                                                  const double *params, const double *x);

/** Check that x is an equilibrium, and compute all but polynomial, eigenvalues and verdict, which stay open: the eigenvalues NaN.
 *  jlt_linearization_enclose fills them. Errors: as jlt_linearization_compute. */
JLT_CHECKED jlt_status jlt_linearization_place(jlt_linearization *result, const jlt_descriptor *descriptor, const double *params,
                                               const double *x);

/** Compute the whole report in doubles.
 *  Out: *result; on failure only what jlt_linearization_residual fills is meaningful, and only for EMPTY.
 *  In:  descriptor, the general field of a model; params, shape (param_count,); x, shape (state_count,); exact, shape
 *       (n + n n,), lower bounds of sizes of the field and the Jacobian at exact inputs, to judge whether x is an equilibrium,
 *       or NULL: those in doubles; jacobian_error, shape (n, n), bound on the absolute error of the Jacobian's entries with
 *       respect to exact inputs, or NULL: four units roundoff; gradient_error, shape (integrals, n), the same for the gradients,
 *       or NULL: eight.
 *  Errors: EMPTY (no equilibrium: residual_ratio > JLT_LINEARIZATION_TOLERANCE), DOMAIN, NONFINITE (overflow or an underflow that
 *          loses digits anywhere), UNSUPPORTED (more than JLT_LINEARIZATION_SIZE_MAX states), NOMEM. If rounding spoils the
 *          eigenvalues they are NaN, and the verdict is UNDECIDED.
 *  Not reentrant: it calls ARPACK. Source: Kilin, Ivanova 2023, (4.4)-(4.6), Proposition 1. */
JLT_CHECKED jlt_status jlt_linearization_compute(jlt_linearization *result, const jlt_descriptor *descriptor,
                                                 const double *params, const double *x, const double *exact,
                                                 const double *jacobian_error, const double *gradient_error);

/** Recompute Jacobian, polynomial, trace, eigenvalues and verdict of a report that jlt_linearization_place or _compute has
 *  filled, in ball arithmetic from exact values; each number becomes the nearest double. Differences between eigenvalues by
 *  several routes stay as they are. The verdict is proved, or JLT_UNDECIDED.
 *  In/out: *result, untouched on failure. In: descriptor, the general field; params, shape (param_count,); x, shape
 *  (state_count,); exact, the equilibrium in exact numbers, or NULL: multiple eigenvalues, and zeros that neither an integral nor
 *  a reversor explains, are then not settled; digits, of the texts, or 0 for none.
 *  Errors and source: as jlt_ball_spectrum_compute. */
JLT_CHECKED jlt_status jlt_linearization_enclose(jlt_linearization *result, const jlt_descriptor *descriptor,
                                                 const jlt_ball_value *params, const jlt_ball_value *x,
                                                 struct jlt_exact_matrix *exact, long digits);

/** Find an equilibrium near x by Newton's method, with steps of least norm, since equilibria come in families, in sizes of the
 *  states that balance the Jacobian where these differ by more than a factor 64. Given states are held as far as possible: first
 *  all of them, then all but the last, and so on.
 *  In/out: x, shape (state_count,), untouched on failure. In: params, shape (param_count,); order, shape (held,), indices of the
 *  states to hold, the most important first. Errors: NO_CONVERGENCE, DOMAIN, NONFINITE, UNSUPPORTED, NOMEM. */
JLT_CHECKED jlt_status jlt_linearization_find(double *x, const jlt_descriptor *descriptor, const double *params,
                                              const size_t *order, size_t held);

#endif
