#ifndef TTC_SHOW_IMAGE_H
#define TTC_SHOW_IMAGE_H

#include "show/print.h"

/* NAME = expression, and what ends a row: of LaTeX, rows are those of an alignment. */
bool ttc_show_row(FILE *stream, const ttc_model *model, const char *name, ttc_id id, ttc_notation notation);
const char *ttc_show_end_of_row(ttc_notation notation, bool is_last);

/* The expressions that give the names of another table, one a row. */
bool ttc_show_image(FILE *stream, const ttc_model *model, const ttc_claim *claim, const ttc_image *image,
                    ttc_notation notation);

#endif
