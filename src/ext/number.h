/** Numbers as people write them, read exactly: 2, -0.51, 1e-3, 1/3, 0.1/3e2; and multiples of pi, each of which is a double: pi,
 *  -pi, 2*pi, 2*pi/3.
 *
 *  The value is an exact rational until it is rounded, once, to the nearest double (ties to even). Independent of locale. */
#ifndef JLT_EXT_NUMBER_H
#define JLT_EXT_NUMBER_H

#include "core/status.h"

#include <stddef.h>

/* Longest text and largest decimal exponent accepted. */
enum { JLT_NUMBER_LENGTH_MAX = 1024, JLT_NUMBER_EXPONENT_MAX = 4096 };

/** Read [+-]DIGITS[.DIGITS][(e|E)[+-]DIGITS] [ / the same without sign ], or [+-]pi or such a number times it, NUMBER*pi, with no
 *  divisor or /NUMBER behind it.
 *  Out: *value, correctly rounded, untouched on failure.
 *  In:  text, `length` bytes, all of which must belong to the number.
 *  Errors: ARG (not a number; zero denominator; longer than the limits; "nan" and "inf" are no numbers),
 *          NONFINITE (beyond the range of normal doubles: overflow, or underflow to a subnormal or to zero). */
JLT_CHECKED jlt_status jlt_number_parse(double *value, const char *text, size_t length);

/** Step `index` of `parts` equal ones from low to high, ((parts - index) low + index high)/parts, exact until it is rounded once.
 *  low and high: texts as above. Errors: as above; ARG, parts is 0 or index > parts. */
JLT_CHECKED jlt_status jlt_number_between(double *value, const char *low, size_t low_length, const char *high,
                                          size_t high_length, size_t index, size_t parts);

/** A number as an exact fraction in lowest terms, "p/q" or "p". Out: *fraction, a string that the caller frees, NULL on failure.
 *  Errors: ARG, as jlt_number_parse; NOMEM. */
JLT_CHECKED jlt_status jlt_number_fraction(char **fraction, const char *text, size_t length);

#endif
