/** Definite integrals by GSL. */
#ifndef JLT_EXT_QUADRATURE_H
#define JLT_EXT_QUADRATURE_H

#include "core/status.h"

/* The integrand; a status other than JLT_OK ends the integration with that status. */
typedef jlt_status (*jlt_quadrature_integrand)(void *context, double *value, double at);

/** Integral from low to high, in either order, by adaptive 31-point Gauss-Kronrod. If that does not reach the accuracy, as at
 *  singular ends, 21 points with extrapolation are tried, which take a peak near an end for a singularity, and lose digits there.
 *  Out: *integral; *error, an estimate of its absolute error; both untouched on failure.
 *  In:  absolute, relative: the accuracy required, of which the looser one decides; the integrand is never evaluated at the ends.
 *  Errors: the integrand's; NO_CONVERGENCE if the accuracy is not reached for another reason than rounding; NONFINITE; NOMEM.
 *  Cost: 31 evaluations of the integrand if one interval suffices.
 *  Source: Piessens et al., QUADPACK, routines QAG and QAGS. */
JLT_CHECKED jlt_status jlt_quadrature_integrate(double *integral, double *error, jlt_quadrature_integrand integrand,
                                                void *context, double low, double high, double absolute,
                                                double relative);

#endif
