/** Definite integrals by GSL. */
#ifndef JLT_EXT_QUADRATURE_H
#define JLT_EXT_QUADRATURE_H

#include "core/status.h"

/* The integrand; a status other than JLT_OK ends the integration with that status. */
typedef jlt_status (*jlt_quadrature_integrand)(void *context, double *value, double at);

/** Integral from low to high (either order), adaptive 31-point Gauss-Kronrod; where that does not reach the accuracy, as at
 *  singular ends, 21 points with extrapolation, which takes a peak beside an end for a singularity, and loses digits there.
 *  Out: *integral; *error, an estimate of its absolute error; both untouched on failure.
 *  In:  absolute, relative: accuracy asked for, the looser one decides; the integrand, whose endpoint values are never taken.
 *  Errors: the integrand's; NO_CONVERGENCE when the accuracy is not reached and rounding is not the reason; NONFINITE; NOMEM.
 *  Cost: 31 values of the integrand where one interval does.
 *  Source: Piessens et al., QUADPACK, routines QAG and QAGS. */
JLT_CHECKED jlt_status jlt_quadrature_integrate(double *integral, double *error, jlt_quadrature_integrand integrand,
                                                void *context, double low, double high, double absolute,
                                                double relative);

#endif
