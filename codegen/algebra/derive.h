/** Derivatives of a model's expressions, for the prover alone: kernels are made by other code, which proofs must not rest on. */
#ifndef TTC_DERIVE_H
#define TTC_DERIVE_H

#include "read/model.h"

/* Derivatives, through definitions by the chain rule. TTC_NONE on failure; ttc_graph_error() then says why. */
ttc_id ttc_derive_field(const ttc_model *model, ttc_id id);                   /* d(id)/dt along the equations */
/* The same with given rates of some definitions. rates: shape (symbol_count,), TTC_NONE for those that follow by the chain rule. */
ttc_id ttc_derive_field_given(const ttc_model *model, ttc_id id, const ttc_id *rates);
ttc_id ttc_derive_state(const ttc_model *model, ttc_id id, size_t state);     /* partial derivative by state number `state` */

#endif
