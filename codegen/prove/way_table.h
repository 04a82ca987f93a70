/** The table that a way of a model leads to: whether the two fit, and which record of it leads back. */
#ifndef TTC_WAY_TABLE_H
#define TTC_WAY_TABLE_H

#include "prove/image.h"
#include "prove/prove.h"

/** The table, for ttc_model_destroy, and in *back its claim that leads back: of a smaller one an embedding into the model, of a
 *  larger one a reduction onto it; that whose target is the model's file, else the first that gives all its states. NULL: it
 *  cannot be read, or does not fit; reason, shape (size,), then says why. It fits where each of its states and parameters is
 *  given, and the record back gives all states of the model and all roots that a time lifts. */
ttc_model *ttc_way_table(const ttc_model *model, const ttc_way *way, ttc_resolver resolver, void *context, uint32_t *back,
                         char *reason, size_t size);

/* The same of a table that was read. */
bool ttc_way_fits(const ttc_model *model, const ttc_way *way, const ttc_model *table, uint32_t *back, char *reason,
                  size_t size);

/* What a reduction or embedding gives for a name of its target, or TTC_NONE. */
ttc_id ttc_given_for(const ttc_claim *claim, const char *name);

#endif
