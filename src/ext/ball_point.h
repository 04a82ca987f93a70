/** Inside the ball arithmetic of equilibria: the point itself. */
#ifndef JLT_EXT_BALL_POINT_H
#define JLT_EXT_BALL_POINT_H

#include "ext/ball_spectrum.h"
#include "kernel_ball.h"

#include <stdbool.h>

typedef enum {
    JLT_BALL_POINT_NONE,  /* there is none, or this precision does not show it */
    JLT_BALL_POINT_NEAR,  /* every component of the field may vanish in the balls; they are right to first order */
    JLT_BALL_POINT_PROVED /* the balls hold an equilibrium */
} jlt_ball_point;

/* The value, exact but for the rounding to `precision` bits; false when its fraction is none. */
bool jlt_ball_point_set(arb_t out, const jlt_ball_value *value, slong precision);

/* Whether a reversor leaves this point where it is: x, shape (states,), is exactly zero where signs are -1. */
bool jlt_ball_point_fixed(arb_srcptr x, const signed char *signs, size_t states);

/** The equilibrium at the states given, or else one within 100 times the question's reach of them, by Newton's method with
 *  as few equations as make every component of the field vanish; states with nothing within reach keep their values, and if that
 *  can be so those that have a fraction.
 *  Krawczyk's test proves that these equations have a solution in the balls. The others hold with them where they hold at all
 *  points of the balls, where a reversor leaves the point where it is, in the components that it leaves, and where integrals I
 *  have grad I . f = 0 with enough independent gradients; then it is an equilibrium.
 *  Out: x, shape (n,), untouched where there is none. In: params, shape (params,).
 *  Source: R. Krawczyk, Computing 4 (1969) 187-201. */
jlt_ball_point jlt_ball_point_find(arb_ptr x, const jlt_ball_table *table, arb_srcptr params, const jlt_ball_question *question,
                                   slong precision);

/* Which row of the table's integrals bears this name; -1 for none. */
slong jlt_ball_point_integral(const jlt_ball_table *table, const char *name);

#endif
