/** The table to which a way of a model leads: a check that the two fit, and the claim of it that leads back. */
#ifndef TTC_WAY_TABLE_H
#define TTC_WAY_TABLE_H

#include "prove/image.h"
#include "prove/prove.h"

/** Read the table, for ttc_model_destroy, and find its claim *back that leads back: an embedding of a smaller table into the model,
 *  a reduction of a larger one onto it; the first that gives all states of the model, preferably one whose target is the model's
 *  file. Returns NULL if the table cannot be read or does not fit; reason, shape (size,), then says why. It fits if the way gives
 *  each of its states and parameters, and the claim back gives all states of the model and all roots that a time lifts. */
ttc_model *ttc_way_table(const ttc_model *model, const ttc_way *way, ttc_resolver resolver, void *context, uint32_t *back,
                         char *reason, size_t size);

/* The way that a claim of the model is about. */
const ttc_way *ttc_way_of(const ttc_model *model, const ttc_claim *claim);

/* The same check for a table that was read already. */
bool ttc_way_fits(const ttc_model *model, const ttc_way *way, const ttc_model *table, uint32_t *back, char *reason,
                  size_t size);

/* The expression that a reduction or embedding gives for a name of its target, or TTC_NONE. */
ttc_id ttc_given_for(const ttc_claim *claim, const char *name);

/* Says which parameters of the model may have any value in the table, as neither a condition of the way, nor a name of the table,
 * nor the claim back tells them; NULL: none, or memory is out. Freed by the caller. */
char *ttc_way_untold(const ttc_model *model, const ttc_claim *way, const ttc_model *table, const ttc_claim *back);

#endif
