/** Writes a double as the shortest decimal text that reads back bit for bit, and reads it, with a decimal point in any locale. */
#ifndef JLT_CORE_DIGITS_H
#define JLT_CORE_DIGITS_H

#include <stdbool.h>

enum { JLT_DIGITS_SIZE = 32 };

/** Write `value` with the fewest digits that read back, and of those the nearest to it, in the form that printf's %g has for at
 *  least 15; NaN and infinities as printf does.
 *  Out: text, shape (JLT_DIGITS_SIZE,), ends with a null byte, to which a pointer is returned. Cost: less than a fifth of a printf
 *  of 17 digits. Source: std::to_chars of the C++ library (U. Adams, Ryu: fast float-to-string conversion, PLDI 2018). */
char *jlt_digits_shortest(char *text, double value);

/** The double nearest to a decimal, all of the text before `end`, in any locale. False: it is none, or lies beyond the doubles;
 *  *value stays. */
bool jlt_digits_read(double *value, const char *text, const char *end);

#endif
