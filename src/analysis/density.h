/** The density of an invariant measure, computed from the field's divergence alone.
 *
 *  For a density rho that depends on one state q alone, div(rho f) = 0 reads  d ln rho / dq = -div f / f_q,  so the
 *  right-hand side must depend on q alone. If it does, a quadrature gives rho (the theorem of Euler and Jacobi). The defect
 *  measures how much it varies with the other states; where it is not zero there is no such density. Source: Kilin, Ivanova
 *  2023, section 4.2. */
#ifndef JLT_ANALYSIS_DENSITY_H
#define JLT_ANALYSIS_DENSITY_H

#include "core/random.h"
#include "core/status.h"
#include "kernel/instance.h"

#include <stddef.h>

/* A defect below this is rounding: the ratio is then a function of one state. */
#define JLT_DENSITY_TOLERANCE 1e-9

/** How far -div f / f_q is from being a function of state q = `along` alone: the largest spread over random values of the
 *  other states at one q, relative to the largest ratio met. 0 where the divergence vanishes identically.
 *  Out: *defect, between 0 and 2; 2 when f_q vanishes everywhere and the divergence does not.
 *  In:  random, advanced. Errors: UNSUPPORTED (no divergence kernel), DOMAIN, NONFINITE, NO_CONVERGENCE (f_q or the field
 *  hardly ever usable). Cost: 1000 evaluations. */
JLT_CHECKED jlt_status jlt_density_defect(double *defect, const jlt_instance *instance, size_t along, jlt_random *random);

typedef struct {
    double at;         /* the state q */
    double density;    /* rho(q) / rho(q0), q0 the middle of the table */
    double error;      /* estimate of the quadrature's error, relative */
} jlt_density_point;

/** rho along q by quadrature, with the other states held at `x`.
 *  Out: points, shape (count,), q equally spaced from low to high. In: x, shape (states,), f_q != 0 for all those q.
 *  Errors: DOMAIN, NONFINITE, NO_CONVERGENCE, NOMEM. Cost: some 21 evaluations of field and divergence a point. */
JLT_CHECKED jlt_status jlt_density_tabulate(jlt_density_point *points, size_t count, const jlt_instance *instance,
                                            size_t along, double low, double high, const double *x);

/** A random state: bounded states inside their interval (jlt_region_intervals), a part of them near its ends; others of magnitude
 *  0.1 to 10. Out: x, shape (states,). In: prepared, values of the parameters, or NULL: ends that are no numbers are passed
 *  over. */
void jlt_density_draw_state(double *x, const jlt_descriptor *descriptor, const double *prepared, jlt_random *random);

/** The largest |div(rho f)| over random states, for the table's densities, relative to the size of its terms,
 *  |rho| sum_i (|df_i/dx_i| + |f_i/x_i|); in rounding units where the claim is true, also of a field that keeps volume, whose
 *  divergence is a sum of terms that cancel. Out: residual, shape (measures,). Errors as above; UNSUPPORTED (no Jacobian). */
JLT_CHECKED jlt_status jlt_density_residual(double *residual, const jlt_instance *instance, size_t samples,
                                            jlt_random *random);

#endif
