/** Expressions of a table at the points of a family of equilibria. */
#ifndef JLT_VALIDATED_ON_FAMILY_H
#define JLT_VALIDATED_ON_FAMILY_H

#include "read/model.h"

/** The expression with what the family gives put in, and with those `let`s written out that this changes, so that terms cancel.
 *  What has been put in may hold symbols that the family gives as well. Returns TTC_NONE where that divides by zero. */
ttc_id jlt_on_family(const ttc_model *model, const ttc_claim *family, ttc_id id);

#endif
