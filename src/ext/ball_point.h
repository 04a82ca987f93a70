/** Finds an equilibrium in ball arithmetic, near given states, and proves that it exists. */
#ifndef JLT_EXT_BALL_POINT_H
#define JLT_EXT_BALL_POINT_H

#include "ext/ball_spectrum.h"
#include "kernel_ball.h"

#include <stdbool.h>

typedef enum {
    JLT_BALL_POINT_NONE,  /* there is none within reach, or this precision does not show it */
    JLT_BALL_POINT_NEAR,  /* every component of the field contains zero; the balls are error estimates of first order, not proved */
    JLT_BALL_POINT_PROVED /* the balls contain an equilibrium */
} jlt_ball_point;

/* Set out to the value: exact, except that a fraction is rounded to `precision` bits. Returns false if its fraction is malformed,
 * or its double is not finite. */
bool jlt_ball_point_set(arb_t out, const jlt_ball_value *value, slong precision);

/* Whether a reversor fixes this point: x, shape (states,), is exactly zero where signs are -1. */
bool jlt_ball_point_fixed(arb_srcptr x, const signed char *signs, size_t states);

/** Find the equilibrium at the given states, or else one within 100 times the question's reach of them. Newton's method solves the
 *  smallest number of equations, in as many states, that makes every component of the field contain zero; a state with reach 0
 *  keeps its value, and so does one with a fraction, if an equilibrium is proved that way.
 *  Krawczyk's test proves that these equations have a solution in the balls. Each other equation follows if it holds identically
 *  in the balls; if a reversor fixes the point and does not flip that component; or from integrals I, since grad I . f = 0, if
 *  enough of their gradients are independent. If all follow, the point is proved to be an equilibrium.
 *  Out: x, shape (n,), untouched if NONE is returned. In: params, shape (params,).
 *  Source: R. Krawczyk, Computing 4 (1969) 187-201. */
jlt_ball_point jlt_ball_point_find(arb_ptr x, const jlt_ball_table *table, arb_srcptr params, const jlt_ball_question *question,
                                   slong precision);

/* The row of the table's integral_gradients that belongs to the integral of this name; -1 if there is none. */
slong jlt_ball_point_integral(const jlt_ball_table *table, const char *name);

#endif
