/** Prints expressions as text or LaTeX. The text is in the language of tables: parsed again, it gives the same node. */
#ifndef TTC_PRINT_H
#define TTC_PRINT_H

#include "read/model.h"

typedef enum { TTC_NOTATION_TEXT, TTC_NOTATION_LATEX } ttc_notation;

/* Returns false, and writes nothing, if the expression written out passes a million operands, or memory is out. */
bool ttc_print(FILE *stream, const ttc_model *model, ttc_id id, ttc_notation notation);

/* As text, followed by `relation`, for free(). NULL where ttc_print is false. */
char *ttc_print_relation(const ttc_model *model, ttc_id id, const char *relation);

/* Print a name. In LaTeX, names of Greek letters become letters; what follows `_`, and digits at the end, become an index. */
void ttc_print_name(FILE *stream, const char *name, ttc_notation notation);
void ttc_print_symbol(FILE *stream, const ttc_model *model, uint32_t symbol, ttc_notation notation);

#endif
