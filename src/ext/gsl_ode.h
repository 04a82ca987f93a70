/** Integrates ordinary differential equations by GSL's own evolution: its steps, its error control and its choice of step size. */
#ifndef JLT_EXT_GSL_ODE_H
#define JLT_EXT_GSL_ODE_H

#include "core/status.h"

#include <stddef.h>

typedef enum { JLT_GSL_RK8PD, JLT_GSL_RKF45, JLT_GSL_MSADAMS } jlt_gsl_ode_kind;

/* Computes f = dx/dtau, shape (dim,), at x, shape (dim,); context is the caller's. */
typedef void (*jlt_gsl_ode_field)(void *context, const double *x, double *f);

typedef struct jlt_gsl_ode jlt_gsl_ode;

/** Create an integrator with this relative tolerance; jlt_gsl_ode_reset must be called before the first step. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_gsl_ode_create(jlt_gsl_ode **out, jlt_gsl_ode_kind kind, size_t dim, jlt_gsl_ode_field field,
                                          void *context, double tolerance);
void jlt_gsl_ode_destroy(jlt_gsl_ode *self); /* NULL is legal */

/** Forget past steps; call it after x was changed. From here on GSL's scaled control keeps the error of x_i in a step below
 *  tolerance*(|x_i| + scale_i); `scale`, shape (dim,), is copied. Errors: ARG, GSL refuses the scale; NOMEM. */
JLT_CHECKED jlt_status jlt_gsl_ode_reset(jlt_gsl_ode *self, const double *scale);

/** Change the scales, and go on. Errors: as of jlt_gsl_ode_reset. */
JLT_CHECKED jlt_status jlt_gsl_ode_rescale(jlt_gsl_ode *self, const double *scale);

/** Advance x, shape (dim,), by one accepted step. In/out: *h, signed, the step to try, then the one proposed next; *rejected grows
 *  by the number of rejected attempts. Out: *taken, the signed size of the accepted step; f, shape (dim,), dx/dtau at the new x.
 *  In: limit, signed, |*taken| <= |limit|. Errors: NO_PROGRESS, GSL gave up or the step vanished; NONFINITE, the field is not
 *  finite however small the step, or GSL accepted a state that is not finite. x is then undefined. */
JLT_CHECKED jlt_status jlt_gsl_ode_step(jlt_gsl_ode *self, double *x, double *f, double *h, double *taken,
                                        size_t *rejected, double limit);

#endif
