/** Exact numbers written as text, as certificates have them, and balls of them. One grammar serves all:
 *
 *      NUMBER = [-] DIGITS [. DIGITS] [(e|E) [+|-] DIGITS]   an exponent has at most six digits
 *             | [-] DIGITS / DIGITS                          the second not 0
 *
 *  Anything else is no number: no blanks, no "+" in front, no names such as "inf", no hexadecimal digits. */
#ifndef JLT_VALIDATED_NUMERALS_H
#define JLT_VALIDATED_NUMERALS_H

#include <flint/fmpq.h>
#include <jansson.h>
#include <stdbool.h>

#include "validated/balls.h"

enum { JLT_NUMERALS_LENGTH_MAX = 16384 };

/** The number, rounded outwards to so many bits; false: it is none, or longer than is served, or the text is NULL. */
bool jlt_numerals_read(arb_t out, const char *text, slong bits);

/** A number without point and exponent, exactly; false as above. */
bool jlt_numerals_fraction(fmpq_t out, const char *text);

/** Whether it is {"middle": NUMBER, "radius": NUMBER}, with a radius that is not negative. */
bool jlt_numerals_is_ball(const json_t *ball);

/** Such a ball, as the least one that surely holds it; false: it is none. */
bool jlt_numerals_ball(arb_t out, const json_t *ball, slong bits);

/** Whether all of the value surely lies in such a ball, exactly as it is written. */
bool jlt_numerals_hold(const json_t *ball, const arb_t value, slong bits);

#endif
