/** Encloses expressions of a table over a box: for all values of parameters and states between exact bounds. */
#ifndef JLT_VALIDATED_OVER_BOX_H
#define JLT_VALIDATED_OVER_BOX_H

#include "core/status.h"
#include "read/model.h"
#include "validated/range.h"

typedef struct jlt_over_box jlt_over_box;

/** Out: *over, NULL on failure; destroy it with jlt_over_box_destroy. In: model, borrowed; its graph must not grow during the
 *  lifetime of *over. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_over_box_create(jlt_over_box **over, const ttc_model *model, slong bits);
void jlt_over_box_destroy(jlt_over_box *over); /* legal on NULL */

/** Give a symbol its meaning: an expression, as on a family of equilibria; or all values from low to high. */
void jlt_over_box_bind(jlt_over_box *over, uint32_t symbol, ttc_id id);
void jlt_over_box_set(jlt_over_box *over, uint32_t symbol, const fmpq_t low, const fmpq_t high);

/** The range of an expression, valid until the next value is set; NULL if it may be undefined at a point of the box, or a symbol
 *  has no value. Cost: one visit per node, cached until a value changes. */
const jlt_range *jlt_over_box_enclose(jlt_over_box *over, ttc_id id);

#endif
