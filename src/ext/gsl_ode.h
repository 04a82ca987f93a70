/** GSL's evolution of ordinary differential equations, as it is: step, its own error control, its own step size. */
#ifndef JLT_EXT_GSL_ODE_H
#define JLT_EXT_GSL_ODE_H

#include "core/status.h"

#include <stddef.h>

typedef enum { JLT_GSL_RK8PD, JLT_GSL_RKF45, JLT_GSL_MSADAMS } jlt_gsl_ode_kind;

/* dx/dtau (dim,) at x (dim,); context is the caller's. */
typedef void (*jlt_gsl_ode_field)(void *context, const double *x, double *f);

typedef struct jlt_gsl_ode jlt_gsl_ode;

/** Create it, to be reset before its first step. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_gsl_ode_create(jlt_gsl_ode **out, jlt_gsl_ode_kind kind, size_t dim, jlt_gsl_ode_field field,
                                          void *context, double tolerance);
void jlt_gsl_ode_destroy(jlt_gsl_ode *self); /* NULL is legal */

/** Forget the past (after x was changed). From now on the error of x_i in a step is held under tolerance*(|x_i| + scale_i) by GSL's
 *  scaled control; `scale`, shape (dim,), is copied. Errors: ARG, GSL refuses; NOMEM. */
JLT_CHECKED jlt_status jlt_gsl_ode_reset(jlt_gsl_ode *self, const double *scale);

/** One accepted step from x in place. In/out: *h, signed, the length tried and then the one proposed next; *rejected grows
 *  by the attempts that failed. Out: *taken, its length. In: limit, signed, |*taken| <= |limit|.
 *  Errors: NO_PROGRESS, GSL gave up or the step vanished; NONFINITE, the field is not finite however short the step, or the state
 *  that GSL accepted is not (GSL accepts such steps). x is then undefined. */
JLT_CHECKED jlt_status jlt_gsl_ode_step(jlt_gsl_ode *self, double *x, double *h, double *taken, size_t *rejected,
                                        double limit);

#endif
