/** Total derivatives along a model's motion, as exact ratios and as expressions. The prover has these to itself: kernels are
 *  made from other code. */
#ifndef TTC_DERIVE_H
#define TTC_DERIVE_H

#include "read/model.h"

/** Derivative of `id` along a direction, through definitions by the chain rule.
 *  direction: shape (state_count,), the rate of each state; TTC_NONE stands for zero.
 *  Returns TTC_NONE on failure; ttc_graph_error() then says why. */
ttc_id ttc_derive_along(const ttc_model *model, ttc_id id, const ttc_id *direction);

ttc_id ttc_derive_field(const ttc_model *model, ttc_id id);                   /* along the field: the rate of id */
ttc_id ttc_derive_state(const ttc_model *model, ttc_id id, size_t state);     /* the partial derivative */

#endif
