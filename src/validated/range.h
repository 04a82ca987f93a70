/** Interval arithmetic with lower and upper ends, in Arb's floats with outward rounding. A ball around a wide range of positive
 *  numbers loses the sign of their product; intervals by ends keep it (R. E. Moore, Interval Analysis, 1966).
 *
 *  Every result contains the values of the operation at all points of its operands. Results may alias operands. */
#ifndef JLT_VALIDATED_RANGE_H
#define JLT_VALIDATED_RANGE_H

#include "ext/scoped.h"

#include <flint/fmpq.h>
#include <stdbool.h>

typedef struct {
    arf_t low, high; /* finite, low <= high */
} jlt_range;

void jlt_range_init(jlt_range *self); /* to [0, 0] */
void jlt_range_clear(jlt_range *self);

typedef jlt_range jlt_range_t[1];
JLT_SCOPED_TYPE(jlt_range, jlt_range)

void jlt_range_set(jlt_range *out, const jlt_range *a);
/** Enclose [low, high], low <= high. */
void jlt_range_set_fractions(jlt_range *out, const fmpq_t low, const fmpq_t high, slong bits);

void jlt_range_add(jlt_range *out, const jlt_range *a, const jlt_range *b, slong bits);
void jlt_range_multiply(jlt_range *out, const jlt_range *a, const jlt_range *b, slong bits);
void jlt_range_power(jlt_range *out, const jlt_range *a, unsigned exponent, slong bits); /* sharp: even powers are not negative */

/** 1/a. Returns false, and leaves *out as it is, if a contains 0. */
bool jlt_range_invert(jlt_range *out, const jlt_range *a, slong bits);

/** The square root. Returns false, and leaves *out as it is, if a contains a negative number. */
bool jlt_range_root(jlt_range *out, const jlt_range *a, slong bits);

/** A function of Arb over a ball around a. Returns false if it is not proved to be finite there. */
typedef void (*jlt_range_function)(arb_t out, const arb_t of, slong bits);
bool jlt_range_apply(jlt_range *out, const jlt_range *a, jlt_range_function function, slong bits);

/* 1 or -1 if all of a is positive or negative; 0 if a contains 0. */
int jlt_range_sign(const jlt_range *a);
bool jlt_range_is_zero(const jlt_range *a); /* whether a is [0, 0] */

#endif
