/** What is positive by the signs of its parts, as it is written. */
#ifndef TTC_POSITIVE_H
#define TTC_POSITIVE_H

#include "prove/prove_task.h"

/** An expression is positive at every point of the leaf: by the signs of its parts, where sums without sums in them are looked at
 *  as ratios; else as one ratio, whose degree is high where quotients and roots were added. See ttc_task_require. */
TTC_PRINTF(4, 5)
void ttc_positive_require(ttc_task *task, ttc_valuation *valuation, ttc_id id, const char *format, ...);

#endif
