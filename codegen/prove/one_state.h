/** Signs of expressions in one state and numbers, all over the state's interval: by balls on pieces of it, and by derivatives where
 *  a piece is unbounded or the expression goes to zero at its end. */
#ifndef TTC_ONE_STATE_H
#define TTC_ONE_STATE_H

#include "prove/prove_task.h"

/* Returns TTC_CAN_BE_POSITIVE or TTC_CAN_BE_NEGATIVE if an expression has that sign wherever the state is in its interval, else
 * TTC_CAN_BE_ANY: also if it depends on another number of states, on a parameter, or on what has a meaning of its own here. */
unsigned ttc_one_state_signs(ttc_task *task, ttc_valuation *valuation, ttc_id id);

#endif
