/** Inside the ball arithmetic of equilibria: the point itself. */
#ifndef JLT_EXT_BALL_POINT_H
#define JLT_EXT_BALL_POINT_H

#include "ext/ball_spectrum.h"
#include "kernel_ball.h"

#include <stdbool.h>

/* The value, exact but for the rounding to `precision` bits; false when its fraction is none. */
bool jlt_ball_point_set(arb_t out, const jlt_ball_value *value, slong precision);

/** The equilibrium at the states given, or else one within 100 times the question's reach of them, by Newton's method with
 *  as few equations as make every component of the field vanish; states with nothing within reach keep their values.
 *  Out: x, shape (n,), untouched where it returns false: there is none, or this precision does not show it. In: params,
 *  shape (params,). An equilibrium found so is enclosed to first order: by a ball of twice the last step. */
bool jlt_ball_point_find(arb_ptr x, const jlt_ball_table *table, arb_srcptr params, const jlt_ball_question *question,
                         slong precision);

#endif
