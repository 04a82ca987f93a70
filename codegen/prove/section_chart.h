/** A section of a model and the table of its coordinates, called its chart: whether the two fit, and what is where. */
#ifndef TTC_SECTION_CHART_H
#define TTC_SECTION_CHART_H

#include "prove/image.h"
#include "prove/prove.h"

/** The chart, for ttc_model_destroy. NULL: it cannot be read, or does not fit; reason, shape (size,), then says why. It fits where
 *  its states are the section's coordinates, each of its parameters is a level or one of the model with the same condition, and
 *  its lift has all states of the model and all roots that a time lifts. */
ttc_model *ttc_section_chart(const ttc_model *model, const ttc_section *section, ttc_resolver resolver, void *context, char *reason,
                             size_t size);

/* Whether a table is the chart of that section. */
bool ttc_section_fits(const ttc_model *model, const ttc_section *section, const ttc_model *chart, char *reason, size_t size);

/* Of a chart that fits: the place of its i-th parameter among the model's parameters with the levels after them. */
uint32_t ttc_section_place(const ttc_model *model, const ttc_section *section, const ttc_model *chart, size_t i);

/* What a table of coordinates lifts to the state or root of that name, or TTC_NONE. */
ttc_id ttc_chart_lift(const ttc_model *chart, const char *name);

#endif
