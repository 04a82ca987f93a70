/** Taylor's method on generated jets: order by the tolerance, step by the last coefficients. */
#ifndef JLT_INTEGRATE_TAYLOR_H
#define JLT_INTEGRATE_TAYLOR_H

#include "integrate/method.h"

/** The order used at a tolerance of a step, 0 < tolerance < 1: -ln(tolerance)/2 + 1 rounded up, within 4 and JLT_JET_ORDER_MAX.
 *  Source: A. Jorba, M. Zou, Experimental Mathematics 14 (2005). */
unsigned jlt_taylor_order(double tolerance);

#endif
