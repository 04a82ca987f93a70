/** The tangent space of a leaf at fixed parameters: directions along its free states in which bound symbols follow
 *  their expressions: a parameter or level stays constant, a cosine agrees with its angle. */
#ifndef TTC_TANGENT_H
#define TTC_TANGENT_H

#include "prove/prove_task.h"

typedef struct {
    size_t columns;         /* number of free states */
    ttc_ratio *states;      /* shape (columns, state_count): derivatives of all states by each free state */
    ttc_ratio *constraints; /* shape (constraint_count, columns): linear forms that are zero on the tangent space */
    size_t constraint_count;
} ttc_tangent;

/* Returns false, with the claim not settled, when memory is out. The tangent must be cleared in either case. */
bool ttc_tangent_init(ttc_task *task, ttc_tangent *tangent);
void ttc_tangent_clear(ttc_task *task, ttc_tangent *tangent);

/* row, shape (columns,), += the derivatives of an expression by each free state. */
void ttc_tangent_gradient(ttc_task *task, const ttc_tangent *tangent, ttc_ratio *row, ttc_id expression);

#endif
