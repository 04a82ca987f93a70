/** Polynomials that are zero at all states for some values of the parameters. */
#ifndef TTC_VANISHING_H
#define TTC_VANISHING_H

#include "prove/prove_task.h"

/* Flags of the variables of the ring that change with the states, shape (variable_count,), for free(); NULL when memory is out. */
bool *ttc_vanishing_moves(ttc_task *task);

/** Search for a point of the leaf at which polynomial/below is zero whatever the variables flagged in `moves` are: all coefficients
 *  of the polynomial, as one in these variables, are zero, and `below`, the denominator of the normal form, is not. (Both may
 *  vanish: x (r - 1)/k^2 is x/(r + 1) for r^2 = 1 + k^2.) If there is no such point, zeros of `below` are put aside (see
 *  ttc_task_put_aside), unless `below` changes with the states. Returns TTC_POINT_NOT_DECIDED if `below` does so, and no point was
 *  found at which it is not zero as well. text: NULL, or gets a text of the point that is found, for free(). */
ttc_search_result ttc_vanishing_search(ttc_task *task, const fmpz_mpoly_t polynomial, const fmpz_mpoly_t below, const bool *moves,
                                       char **text);

#endif
