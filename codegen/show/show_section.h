/** Shows the records on sections and poles. Returns false as in show.h. */
#ifndef TTC_SHOW_SECTION_H
#define TTC_SHOW_SECTION_H

#include "show/print.h"

bool ttc_show_sections(FILE *stream, const ttc_model *model, ttc_notation notation); /* and poles; nothing where there are none */
bool ttc_show_lift(FILE *stream, const ttc_model *model, ttc_notation notation);     /* in rows; of a table of coordinates */

/* What the table is called among those that serve in its place, and the ways to them. */
bool ttc_show_ways(FILE *stream, const ttc_model *model, ttc_notation notation);

#endif
