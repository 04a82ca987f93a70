/** The directions in which a leaf goes on, parameters being fixed: those along its free states under which what is bound beside
 *  states, a parameter or a cosine, stays what it is bound to. */
#ifndef TTC_TANGENT_H
#define TTC_TANGENT_H

#include "prove/prove_task.h"

typedef struct {
    size_t columns;         /* free states */
    ttc_ratio *states;      /* shape (columns, state_count): the rates of all states along each */
    ttc_ratio *constraints; /* shape (constraint_count, columns): zero along the leaf */
    size_t constraint_count;
} ttc_tangent;

/* False, and not settled, when memory is out; to be cleared in any case. */
bool ttc_tangent_init(ttc_task *task, ttc_tangent *tangent);
void ttc_tangent_clear(ttc_task *task, ttc_tangent *tangent);

/* row, shape (columns,), zeros: the rate of an expression along each free state. */
void ttc_tangent_gradient(ttc_task *task, const ttc_tangent *tangent, ttc_ratio *row, ttc_id expression);

#endif
