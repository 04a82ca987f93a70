/** Taylor's method on generated jets: order by the tolerance, step by the last coefficients. */
#ifndef JLT_INTEGRATE_TAYLOR_H
#define JLT_INTEGRATE_TAYLOR_H

#include "integrate/method.h"

extern const jlt_method jlt_method_taylor;

/** The order used at a tolerance. */
unsigned jlt_taylor_order(double tolerance);

#endif
