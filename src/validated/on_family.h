/** Evaluates expressions of a table at the points of a family of equilibria, symbolically. */
#ifndef JLT_VALIDATED_ON_FAMILY_H
#define JLT_VALIDATED_ON_FAMILY_H

#include "read/model.h"

/** Substitute what the family gives, in the expression and in those `let`s that it changes, so that terms cancel. The substituted
 *  expressions may contain symbols that the family gives as well. Returns TTC_NONE if this divides by zero. */
ttc_id jlt_on_family(const ttc_model *model, const ttc_claim *family, ttc_id id);

#endif
