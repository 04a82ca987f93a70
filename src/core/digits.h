/** Converts doubles to the shortest decimal text that reads back bit for bit, and such text to doubles, in any locale. */
#ifndef JLT_CORE_DIGITS_H
#define JLT_CORE_DIGITS_H

#include <stdbool.h>

enum { JLT_DIGITS_SIZE = 32 };

/** Write `value` with the fewest digits that read back as the same double; of all such texts, the one nearest to `value`. The form
 *  is that of printf's %.Pg, P = max(15, number of digits written); NaN and infinities are written as printf writes them.
 *  Out: text, shape (JLT_DIGITS_SIZE,), null-terminated; returns a pointer to the null byte. Cost: less than a fifth of a printf of
 *  17 digits. Source: std::to_chars of the C++ library (U. Adams, Ryu: fast float-to-string conversion, PLDI 2018). */
char *jlt_digits_shortest(char *text, double value);

/** Read the decimal number that the bytes from `text` up to `end` hold, rounded to the nearest double, in any locale. Returns
 *  false, and leaves *value, if these bytes as a whole are no number, or the number lies outside the range of doubles. */
bool jlt_digits_read(double *value, const char *text, const char *end);

#endif
