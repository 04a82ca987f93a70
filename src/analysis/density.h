/** Computes the density of an invariant measure from the field's divergence alone.
 *
 *  For a density rho that depends on one state q alone, div(rho f) = 0 reads  d ln rho / dq = -div f / f_q,  so the right-hand
 *  side must depend on q alone. If it does, a quadrature gives rho (the theorem of Euler and Jacobi). The defect measures how much
 *  it varies with the other states; if it is not zero there is no such density. Source: Kilin, Ivanova 2023, section 4.2. */
#ifndef JLT_ANALYSIS_DENSITY_H
#define JLT_ANALYSIS_DENSITY_H

#include "core/random.h"
#include "core/status.h"
#include "kernel/instance.h"

#include <stddef.h>

/* A defect below this is attributed to rounding: -div f / f_q is then taken as a function of one state. */
#define JLT_DENSITY_TOLERANCE 1e-9

/** Measure how far -div f / f_q is from being a function of state q = `along` alone: the largest spread over random values of the
 *  other states at one q, divided by the largest ratio found. It is 0 if the divergence vanishes identically.
 *  Out: *defect, between 0 and 2; 2 if f_q vanishes everywhere and the divergence does not.
 *  In/out: random, advanced.
 *  Errors: UNSUPPORTED (no divergence kernel, more than 64 states, or no state `along`), NO_CONVERGENCE (at no q could the field
 *  be evaluated for two draws of the other states).
 *  Cost: 480 evaluations of field and divergence if all draws are usable, at most 8000. */
JLT_CHECKED jlt_status jlt_density_defect(double *defect, const jlt_instance *instance, size_t along, jlt_random *random);

typedef struct {
    double at;         /* the state q */
    double density;    /* rho(q) / rho(q0), q0 the middle of the table */
    double error;      /* estimate of the relative error of `density`, from the quadratures and from rounding */
} jlt_density_point;

/** Tabulate rho along q by quadrature, with the other states fixed at `x`.
 *  Out: points, shape (count,), q equally spaced from low to high; not meaningful on failure. In: x, shape (states,); f_q must not
 *  vanish at any of these q.
 *  Errors: ARG, count is 0, no state `along`, or more than 64 states; DOMAIN, NONFINITE, NO_CONVERGENCE, NOMEM. Cost: mostly 31
 *  evaluations of field and divergence per point (jlt_quadrature_integrate). */
JLT_CHECKED jlt_status jlt_density_tabulate(jlt_density_point *points, size_t count, const jlt_instance *instance,
                                            size_t along, double low, double high, const double *x);

/** Draw a random state. A state bounded on both sides lies inside its interval (jlt_region_intervals), one time in four near an
 *  end; a state bounded on one side lies 0.1 to 10 from the bound; any other has a magnitude of 0.1 to 10.
 *  Out: x, shape (states,). In: prepared, values prepared from the parameters; NULL ignores bounds that depend on them. */
void jlt_density_draw_state(double *x, const jlt_descriptor *descriptor, const double *prepared, jlt_random *random);

/** The largest |div(rho f)| over `samples` random states, for each density of the table, relative to the size of its terms, |rho|
 *  sum_i (|df_i/dx_i| + |f_i/x_i|). It is of the order of roundoff if the claim is true, even for a field that preserves volume,
 *  whose divergence is a sum of cancelling terms. Out: residual, shape (measures,), untouched on failure. Errors: UNSUPPORTED (no
 *  Jacobian kernel, or more than 64 states or densities); NO_CONVERGENCE (the field could be evaluated at no sample). */
JLT_CHECKED jlt_status jlt_density_residual(double *residual, const jlt_instance *instance, size_t samples,
                                            jlt_random *random);

#endif
