/** Prints expressions as text or LaTeX. The text is in the language of tables: parsed again, it gives the same node. */
#ifndef TTC_PRINT_H
#define TTC_PRINT_H

#include "read/model.h"

typedef enum { TTC_NOTATION_TEXT, TTC_NOTATION_LATEX } ttc_notation;

/* False, and nothing is written, when the expression written out passes a million operands, or memory is out. */
bool ttc_print(FILE *stream, const ttc_model *model, ttc_id id, ttc_notation notation);

/* As text, with `relation` behind it, for free(). NULL where ttc_print is false. */
char *ttc_print_relation(const ttc_model *model, ttc_id id, const char *relation);

/* A name; in LaTeX, Greek letters by name and what follows `_`, or digits at the end, as index. */
void ttc_print_name(FILE *stream, const char *name, ttc_notation notation);
void ttc_print_symbol(FILE *stream, const ttc_model *model, uint32_t symbol, ttc_notation notation);

#endif
