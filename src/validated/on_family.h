/** Expressions of a table at the points of a family of equilibria. */
#ifndef JLT_VALIDATED_ON_FAMILY_H
#define JLT_VALIDATED_ON_FAMILY_H

#include "read/model.h"

/** What the family gives put in, and lets written out that this changes, so that terms cancel. TTC_NONE where that divides by zero.
 *  What has been put in may hold symbols that the family gives as well. */
ttc_id jlt_on_family(const ttc_model *model, const ttc_claim *family, ttc_id id);

#endif
