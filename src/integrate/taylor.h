/** Taylor's method on generated jets: order by the tolerance, step by the last coefficients. */
#ifndef JLT_INTEGRATE_TAYLOR_H
#define JLT_INTEGRATE_TAYLOR_H

#include "integrate/method.h"

/** The order used at a tolerance. */
unsigned jlt_taylor_order(double tolerance);

#endif
