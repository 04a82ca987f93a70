/** Everything about one equilibrium: residual, Jacobian, characteristic polynomial, trace, eigenvalues, stability, and what
 *  follows for an invariant measure. */
#ifndef JLT_ANALYSIS_LINEARIZATION_H
#define JLT_ANALYSIS_LINEARIZATION_H

#include "analysis/deflation.h"
#include "core/status.h"
#include "ext/ball_spectrum.h"
#include "kernel_abi.h"

#include <stdbool.h>

enum { JLT_LINEARIZATION_SIZE_MAX = JLT_DEFLATION_SIZE_MAX };

/* A state counts as an equilibrium when one lies this near: relative to each |x_j|, and to the distance of x_j from the
 * ends of its interval, whichever is less; two roundings of x_j are always allowed, but no more than a thousandth of that
 * distance. */
#define JLT_LINEARIZATION_TOLERANCE 1e-12

/* The linearized motion. */
typedef enum {
    JLT_STABLE,   /* every eigenvalue but zero has a negative real part, and zero is semisimple */
    JLT_UNSTABLE, /* one has a positive real part, or one on the imaginary axis is defective: growth, at least linear */
    JLT_CENTRE,   /* none has a positive real part, none on the axis is defective, and some but zero lie on it, or all are zero */
    JLT_UNDECIDED /* errors leave it open */
} jlt_verdict;

/* What follows for the motion itself. UNSTABLE: an eigenvalue has a positive real part. ATTRACTED: all have negative ones. STABLE:
 * all but zero have, and as many integrals with independent gradients force zeros as there are, so that each level nearby has one
 * equilibrium near this one, which attracts there; or there are two states with a pair on the imaginary axis, and a reversor
 * changes the sign of one that is zero, so that orbits, which meet the other's axis twice, are closed. Else nothing follows: a
 * linear centre may be a weak focus, and zero may hide x' = x^2. */
typedef enum { JLT_MOTION_OPEN, JLT_MOTION_ATTRACTED, JLT_MOTION_STABLE, JLT_MOTION_UNSTABLE } jlt_motion;

typedef struct {
    const jlt_descriptor *descriptor; /* the variant whose kernels were used: the most special that serves */
    const jlt_equilibria *family;     /* the family of the table that the point belongs to, or NULL */
    size_t n;
    double f[JLT_LINEARIZATION_SIZE_MAX];
    double residual;                  /* largest |f_i| */
    double reach[JLT_LINEARIZATION_SIZE_MAX]; /* how far from x_j an equilibrium may lie for x to count as one, see
                                                 JLT_LINEARIZATION_TOLERANCE */
    double residual_ratio;            /* largest JLT_LINEARIZATION_TOLERANCE |f_i| / sum_j |df_i/dx_j| reach_j: x counts as an
                                         equilibrium where this is at most the tolerance; 0 where f_i is exactly 0 */
    double jacobian[JLT_LINEARIZATION_SIZE_MAX * JLT_LINEARIZATION_SIZE_MAX]; /* row-major, shape (n, n) */
    size_t integrals;                 /* of the variant, those that are proved */
    jlt_named held[JLT_LINEARIZATION_SIZE_MAX]; /* shape (integrals,) */
    double gradients[JLT_LINEARIZATION_SIZE_MAX * JLT_LINEARIZATION_SIZE_MAX]; /* of these, shape (integrals, n) */
    double charpoly[JLT_LINEARIZATION_SIZE_MAX + 1]; /* monic, highest power first, Faddeev-LeVerrier; coefficients beyond
                                                        n - zeros are exactly zero by the integrals and set so */
    double charpoly_error[JLT_LINEARIZATION_SIZE_MAX + 1];
    double charpoly_formula[JLT_LINEARIZATION_SIZE_MAX + 1]; /* the table's, made monic; NaN when it has none */
    double trace, trace_error;        /* the generated divergence */
    double trace_formula;             /* the table's; NaN when it has none */
    jlt_deflation eigen;
    long precision;                   /* bits of the arithmetic behind the eigenvalues */
    bool exists;                      /* the equilibrium is proved in balls; false: it may be missing, or where the trace is zero */
    bool proved;                      /* so is the verdict; false: it is that of doubles to first order, or UNDECIDED */
    bool sure;                        /* every number is proved to be the double nearest to the exact one */
    jlt_ball_texts *texts;            /* all numbers as decimals, for jlt_ball_texts_destroy; NULL where none were asked for */
    const char *sources[JLT_LINEARIZATION_SIZE_MAX]; /* names of the integrals, by jlt_eigenvalue.source */
    jlt_verdict verdict;
    jlt_motion motion;                /* proved, or OPEN */
    int obstructs;                    /* the trace differs from zero by more than its error: no smooth positive density, where the
                                         equilibrium exists; in doubles the error is that at x, rounded as it is */
} jlt_linearization;

const char *jlt_linearization_verdict(jlt_verdict verdict); /* "stable", "unstable", "centre", "not settled" */
const char *jlt_linearization_motion(jlt_motion motion);    /* "asymptotically stable", "stable", "unstable", "not settled" */

/** Fill states that were not given, from the first family of equilibria whose condition the parameters satisfy; zero where no
 *  family says otherwise.
 *  In/out: x, shape (state_count,). In: given, shape (state_count,), 1 where x is kept; descriptor, a general field. */
void jlt_linearization_complete(double *x, const unsigned char *given, const jlt_descriptor *descriptor,
                                const double *params);

/** Compute the residual alone, and choose the variant. Out: f, residual, residual_ratio, jacobian, gradients,
 *  integrals, held, descriptor, n of *result.
 *  Errors: as jlt_linearization_compute, but a large residual is none. */
JLT_CHECKED jlt_status jlt_linearization_residual(jlt_linearization *result, const jlt_descriptor *descriptor,
                                                  const double *params, const double *x);

/** Compute the whole report.
 *  Out: *result; on failure only what jlt_linearization_residual fills is meaningful, and only for EMPTY.
 *  In:  descriptor, the general field of a model; params, shape (param_count,); x, shape (state_count,); jacobian_error, shape
 *       (n, n), bound on the absolute error of the Jacobian's entries with respect to exact inputs, or NULL: four units roundoff;
 *       gradient_error, shape (integrals, n), the same for the gradients, or NULL: eight.
 *  Errors: EMPTY (no equilibrium: residual_ratio > JLT_LINEARIZATION_TOLERANCE), DOMAIN, NONFINITE (overflow or lost
 *          underflow anywhere), UNSUPPORTED (more than JLT_LINEARIZATION_SIZE_MAX states), NOMEM. Where rounding spoils
 *          the eigenvalues they are NaN, and the verdict is UNDECIDED.
 *  Not reentrant: it calls ARPACK. Source: Kilin, Ivanova 2023, (4.4)-(4.6), Proposition 1. */
JLT_CHECKED jlt_status jlt_linearization_compute(jlt_linearization *result, const jlt_descriptor *descriptor,
                                                 const double *params, const double *x, const double *jacobian_error,
                                                 const double *gradient_error);

/** The same in ball arithmetic, from exact values: Jacobian, polynomial, trace, eigenvalues and verdict of a report that
 *  jlt_linearization_compute has filled, each number the nearest double. What belongs to doubles alone (differences from other
 *  routes) stays. The verdict is proved, or JLT_UNDECIDED.
 *  In/out: *result, untouched on failure. In: params, shape (param_count,); x, shape (state_count,); the table's descriptor;
 *  exact, the equilibrium in exact numbers, or NULL: multiple eigenvalues, and zeros that no integral and no reversor explains, are
 *  then not settled; digits, of texts, or 0 for none.
 *  Errors: as jlt_ball_spectrum_compute. Source: as there. */
JLT_CHECKED jlt_status jlt_linearization_enclose(jlt_linearization *result, const jlt_descriptor *descriptor,
                                                 const jlt_ball_value *params, const jlt_ball_value *x,
                                                 struct jlt_exact_matrix *exact, long digits);

/** Newton's method (shortest steps in the least-squares sense, since equilibria come in families) from x to a nearby
 *  equilibrium. States that the caller gave are held as far as possible: first all of them, then all but the last, and so on.
 *  In/out: x, shape (state_count,), untouched on failure. In: params, shape (param_count,); order, shape (held,), indices of the
 *  states to hold, the most important first. Errors: NO_CONVERGENCE, DOMAIN, NONFINITE, UNSUPPORTED, NOMEM. */
JLT_CHECKED jlt_status jlt_linearization_find(double *x, const jlt_descriptor *descriptor, const double *params,
                                              const size_t *order, size_t held);

#endif
