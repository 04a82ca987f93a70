/** Signs by the parts of what is written. */
#ifndef TTC_SIGNS_H
#define TTC_SIGNS_H

#include "prove/prove_task.h"

/** An expression stands in a relation to zero at every point of the leaf: by the signs of its parts, where sums without sums in
 *  them, and those without their longer terms of one sign, are looked at as ratios; else as one ratio, whose degree is high where
 *  quotients and roots were added. A product is not zero where its factors are not. See ttc_task_require. */
TTC_PRINTF(5, 6)
void ttc_signs_require(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_relation relation, const char *format, ...);

/* Returns true if the signs of its parts tell that an expression stands in a relation to zero at every point of the leaf. */
bool ttc_signs_tell(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_relation relation);

/* Returns true for a sum of terms of one sign in the task's field: it is zero only where all its terms are. */
bool ttc_signs_are_one(ttc_task *task, ttc_id id);

#endif
