/** Shows sections, poles, lifts and ways. Returns false as in show.h. */
#ifndef TTC_SHOW_SECTION_H
#define TTC_SHOW_SECTION_H

#include "show/print.h"

bool ttc_show_sections(FILE *stream, const ttc_model *model, ttc_notation notation); /* and poles */
bool ttc_show_lift(FILE *stream, const ttc_model *model, ttc_notation notation);     /* the lift of a table of coordinates */

/* The table's tier, and its ways to tables that serve in its place. */
bool ttc_show_ways(FILE *stream, const ttc_model *model, ttc_notation notation);

#endif
