/** Signs of expressions in numbers and at most one state, all over its interval: by balls on pieces of it, and by derivatives where
 *  a piece is unbounded or the expression goes to zero at its end. */
#ifndef TTC_ONE_STATE_H
#define TTC_ONE_STATE_H

#include "prove/prove_task.h"

/* A value of a state. */
typedef struct {
    uint32_t symbol;
    fmpq_t value;
    bool is_known;
} ttc_state_value;

/* Returns TTC_CAN_BE_POSITIVE or TTC_CAN_BE_NEGATIVE if an expression has that sign wherever the state is in its interval, else
 * TTC_CAN_BE_ANY: also if it depends on more states, on a parameter, or on what has a meaning of its own here.
 * negative: NULL, or gets a place at which the expression is known not to be positive, if one was met. */
unsigned ttc_one_state_signs(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_state_value *negative);

#endif
