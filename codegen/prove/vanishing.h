/** Polynomials that are zero at all states for some values of the parameters. */
#ifndef TTC_VANISHING_H
#define TTC_VANISHING_H

#include "prove/prove_task.h"

/* Flags of the variables of the ring that change with the states, shape (variable_count,), for free(); NULL when memory is out. */
bool *ttc_vanishing_moves(ttc_task *task);

/** Search for a point of the leaf at which all coefficients of a polynomial, taken as one in the variables flagged in `moves`, are
 *  zero. *text, unless text is NULL, receives the point. */
ttc_search_result ttc_vanishing_search(ttc_task *task, const fmpz_mpoly_t polynomial, const bool *moves, char **text);

#endif
