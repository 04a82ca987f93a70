/** Names of quantities as printed symbols: alpha_1 becomes α with the index 1. */
#ifndef JLT_REPORT_SYMBOL_H
#define JLT_REPORT_SYMBOL_H

#include <stdio.h>

/** Write a name of a table in gnuplot's enhanced text: names of Greek letters as letters; what follows the first '_', and digits
 *  behind a single letter, as an index, whose parts commas separate: p_xi_2 has the index ξ,2. Any other text is written as it
 *  stands. */
void jlt_symbol_write(FILE *stream, const char *name);

/** Write a number as it is printed, to six digits: 0.51, −3×10^{−14}. */
void jlt_symbol_number(FILE *stream, double value);

/** Write `length` bytes of text with gnuplot's marks escaped, so that enhanced text shows them as they are. */
void jlt_symbol_plain(FILE *stream, const char *text, size_t length);

/** Write a unit of a table in gnuplot's enhanced text, with exponents raised: kg*m^{2}/s. */
void jlt_symbol_unit(FILE *stream, const char *unit);

#endif
