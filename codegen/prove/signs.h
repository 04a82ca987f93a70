/** Signs of expressions from the signs of their parts, as the table writes them. */
#ifndef TTC_SIGNS_H
#define TTC_SIGNS_H

#include "prove/prove_task.h"

/** Require that an expression stands in a relation to zero at every point of the leaf. First by the signs of its parts: a sum whose
 *  terms do not tell its sign is examined as one ratio, then without those terms that contain sums and are of one sign. Where this
 *  fails, by ttc_task_require for the whole expression as one ratio, whose degree is high where quotients and roots are added.
 *  NONZERO is required of each factor of a product separately. */
TTC_PRINTF(5, 6)
void ttc_signs_require(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_relation relation, const char *format, ...);

/* Returns true if the signs of its parts tell that an expression stands in a relation to zero at every point of the leaf. */
bool ttc_signs_tell(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_relation relation);

/* Returns true for a sum of terms of one sign in the task's field: it is zero only where all its terms are. */
bool ttc_signs_are_one(ttc_task *task, ttc_id id);

#endif
