/** Names of quantities as they are printed: alpha_1 is α with the index 1. */
#ifndef JLT_REPORT_SYMBOL_H
#define JLT_REPORT_SYMBOL_H

#include <stdio.h>

/** Write a name of a table in gnuplot's enhanced text: names of Greek letters as letters; what follows the first '_', and digits
 *  behind a single letter, as an index. Any other text is written as it stands. */
void jlt_symbol_write(FILE *stream, const char *name);

/** Write text in enhanced text so that it is shown to the letter. */
void jlt_symbol_plain(FILE *stream, const char *text, size_t length);

#endif
