/** Reads exact numbers written as text in certificates, and balls of them. One grammar serves all:
 *
 *      NUMBER = [-] DIGITS [. DIGITS] [(e|E) [+|-] DIGITS]   an exponent has at most six digits
 *             | [-] DIGITS / DIGITS                          the second not 0
 *
 *  Nothing else is a number: no blanks, no leading "+", no names such as "inf", no hexadecimal digits. */
#ifndef JLT_VALIDATED_NUMERALS_H
#define JLT_VALIDATED_NUMERALS_H

#include <flint/fmpq.h>
#include <jansson.h>
#include <stdbool.h>

#include "ext/scoped.h"

enum { JLT_NUMERALS_LENGTH_MAX = 16384 };

/** Read a number, rounded outwards to `bits` bits. Returns false if the text is no number, too long, or NULL. */
bool jlt_numerals_read(arb_t out, const char *text, slong bits);

/** Read a number without point and exponent exactly. Returns false likewise. */
bool jlt_numerals_fraction(fmpq_t out, const char *text);

/** Whether this is {"middle": NUMBER, "radius": NUMBER} with a radius that is not negative. */
bool jlt_numerals_is_ball(const json_t *ball);

/** Read such a ball, rounded outwards. Returns false if it is not one. */
bool jlt_numerals_ball(arb_t out, const json_t *ball, slong bits);

/** Whether all of `value` certainly lies in such a ball, exactly as it is written. */
bool jlt_numerals_hold(const json_t *ball, const arb_t value, slong bits);

#endif
