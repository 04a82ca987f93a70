/** A section of a model and the table of its coordinates, called its chart: a check that the two fit, and lookup in them. */
#ifndef TTC_SECTION_CHART_H
#define TTC_SECTION_CHART_H

#include "prove/image.h"
#include "prove/prove.h"

/** Read the chart, for ttc_model_destroy. Returns NULL if it cannot be read or does not fit; reason, shape (size,), then says why.
 *  It fits if its states are the section's coordinates, each of its parameters is a level, or a parameter of the model with the
 *  same sign condition, and it lifts all states of the model and all roots that a time lifts. */
ttc_model *ttc_section_chart(const ttc_model *model, const ttc_section *section, ttc_resolver resolver, void *context, char *reason,
                             size_t size);

/* The section that a claim of the model is about. */
const ttc_section *ttc_section_of(const ttc_model *model, const ttc_claim *claim);

/* Returns true if a table fits the section; otherwise reason says why not. */
bool ttc_section_fits(const ttc_model *model, const ttc_section *section, const ttc_model *chart, char *reason, size_t size);

/* For a chart that fits, the index of its i-th parameter in the list of the model's parameters followed by the levels. */
uint32_t ttc_section_place(const ttc_model *model, const ttc_section *section, const ttc_model *chart, size_t i);

/* The expression of the chart that it lifts to the model's state or root of that name, or TTC_NONE. */
ttc_id ttc_chart_lift(const ttc_model *chart, const char *name);

#endif
