/** Reads numbers as people write them: 2, -0.51, 1e-3, 1/3, 0.1/3e2, and multiples of pi, such as pi, -pi, 2*pi, 2*pi/3.
 *
 *  A value without pi is an exact rational until it is rounded, once, to the nearest double (ties to even). A multiple of pi is
 *  computed in doubles, which may be off by two units in the last place, and that double then counts as exact. Independent of
 *  locale. */
#ifndef JLT_EXT_NUMBER_H
#define JLT_EXT_NUMBER_H

#include "core/status.h"

#include <stddef.h>

/* The longest text, in bytes, and the largest decimal exponent that are accepted. */
enum { JLT_NUMBER_LENGTH_MAX = 1024, JLT_NUMBER_EXPONENT_MAX = 4096 };

/** Read a number: NUMBER = [+-]DECIMAL[/DECIMAL] with DECIMAL = DIGITS[.DIGITS][(e|E)[+-]DIGITS], where the digits on one side of
 *  the point may be missing; or [+-]pi or NUMBER*pi, optionally followed by /DECIMAL.
 *  Out: *value, rounded as said above, untouched on failure.
 *  In:  text, `length` bytes, all of which must belong to the number.
 *  Errors: ARG (not a number; zero denominator; longer than the limits; "nan" and "inf" are no numbers),
 *          NONFINITE (beyond the range of normal doubles: overflow, or underflow to a subnormal or to zero). */
JLT_CHECKED jlt_status jlt_number_parse(double *value, const char *text, size_t length);

/** Point number `index` of the partition of [low, high] into `parts` equal parts, ((parts - index) low + index high)/parts,
 *  computed exactly and rounded once. low and high: texts as above. Errors: as above; ARG, parts is 0 or index > parts. */
JLT_CHECKED jlt_status jlt_number_between(double *value, const char *low, size_t low_length, const char *high,
                                          size_t high_length, size_t index, size_t parts);

/** Multiples of a part of a number, k text/parts for k = first .. first + count - 1, each computed exactly and rounded once, also
 *  to 0, a subnormal or an infinity. Out: values, shape (count,). Errors: ARG, not a number, or parts is 0; NONFINITE, a multiple
 *  of pi beyond the range. */
JLT_CHECKED jlt_status jlt_number_multiples(double *values, const char *text, size_t length, size_t parts, size_t first,
                                            size_t count);

/** Convert a number to an exact fraction in lowest terms, "p/q" or "p". Out: *fraction, a string that the caller frees, NULL on
 *  failure. Errors: ARG, as jlt_number_parse; NONFINITE, a multiple of pi beyond the range; NOMEM. */
JLT_CHECKED jlt_status jlt_number_fraction(char **fraction, const char *text, size_t length);

#endif
