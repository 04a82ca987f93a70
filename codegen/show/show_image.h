/** Shows what a claim gives for the names of another table. Returns false as in show.h. */
#ifndef TTC_SHOW_IMAGE_H
#define TTC_SHOW_IMAGE_H

#include "show/print.h"

/* NAME = expression; and the end of such a row, for LaTeX in an alignment. */
bool ttc_show_row(FILE *stream, const ttc_model *model, const char *name, ttc_id id, ttc_notation notation);
const char *ttc_show_end_of_row(ttc_notation notation, bool is_last);

/* All these expressions, one a row. */
bool ttc_show_image(FILE *stream, const ttc_model *model, const ttc_claim *claim, const ttc_image *image,
                    ttc_notation notation);

#endif
