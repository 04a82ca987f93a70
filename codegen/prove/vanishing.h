/** What is zero for some values of the parameters, at all states. */
#ifndef TTC_VANISHING_H
#define TTC_VANISHING_H

#include "prove/prove_task.h"

/* Which variables of the ring change with the states, shape (variable_count,), for free(); NULL when memory is out. */
bool *ttc_vanishing_moves(ttc_task *task);

/** Look for a point of the leaf at which all coefficients of a polynomial of the ring are zero, it being one in what moves.
 *  text, when not NULL, receives the point. */
ttc_search_result ttc_vanishing_search(ttc_task *task, const fmpz_mpoly_t polynomial, const bool *moves, char **text);

#endif
