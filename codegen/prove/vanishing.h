/** Polynomials that are zero at all states for some values of the parameters. */
#ifndef TTC_VANISHING_H
#define TTC_VANISHING_H

#include "prove/prove_task.h"

/* Flags of the variables of the ring that change with the states, shape (variable_count,), for free(); NULL when memory is out. */
bool *ttc_vanishing_moves(ttc_task *task);

/** Search for a point of the leaf at which all coefficients of a polynomial, taken as one in the variables flagged in `moves`, are
 *  zero, and `below` is not, what the polynomial is divided by in its normal form: x (r - 1)/k^2 is x/(r + 1) for r^2 = 1 + k^2.
 *  If there is none, zeros of `below` are put aside if it does not move. Not decided if it moves, and is zero wherever the
 *  coefficients are. text: NULL, or gets the point that is found. */
ttc_search_result ttc_vanishing_search(ttc_task *task, const fmpz_mpoly_t polynomial, const fmpz_mpoly_t below, const bool *moves,
                                       char **text);

#endif
