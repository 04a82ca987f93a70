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
 * TTC_CAN_BE_ANY: also if it depends on more states, on a parameter, or on a bound symbol.
 * negative: NULL, or gets a value of the state at which the expression is not positive, if one was met.
 * Cost: at most 400 pieces of the interval, and 20000 expressions on pieces. */
unsigned ttc_one_state_signs(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_state_value *negative);

#endif
