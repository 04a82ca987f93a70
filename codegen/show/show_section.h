/** Shows sections, poles, lifts, and the ways to other tables. Functions return false as in show.h. */
#ifndef TTC_SHOW_SECTION_H
#define TTC_SHOW_SECTION_H

#include "show/print.h"

bool ttc_show_sections(FILE *stream, const ttc_model *model, ttc_notation notation); /* and poles */
bool ttc_show_lift(FILE *stream, const ttc_model *model, ttc_notation notation);     /* the lift of a table of coordinates */

/* The tier that the table is, and its ways to tables that serve in its place. */
bool ttc_show_ways(FILE *stream, const ttc_model *model, ttc_notation notation);

#endif
