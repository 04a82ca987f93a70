/** Interval arithmetic by ends, with Arb's floats and outward rounding. A ball of Arb around a wide range of positive numbers loses
 *  their sign in a product; ends keep it (R. E. Moore, Interval Analysis, 1966).
 *
 *  Every result contains what the operation gives at all points of its operands. Results may be operands. */
#ifndef JLT_VALIDATED_RANGE_H
#define JLT_VALIDATED_RANGE_H

#include "validated/balls.h"

#include <flint/fmpq.h>
#include <stdbool.h>

typedef struct {
    arf_t low, high; /* finite, low <= high */
} jlt_range;

void jlt_range_init(jlt_range *self); /* to [0, 0] */
void jlt_range_clear(jlt_range *self);
void jlt_range_set(jlt_range *out, const jlt_range *a);
void jlt_range_set_fractions(jlt_range *out, const fmpq_t low, const fmpq_t high, slong bits);

void jlt_range_add(jlt_range *out, const jlt_range *a, const jlt_range *b, slong bits);
void jlt_range_multiply(jlt_range *out, const jlt_range *a, const jlt_range *b, slong bits);
void jlt_range_power(jlt_range *out, const jlt_range *a, unsigned exponent, slong bits); /* sharp: squares are not negative */

/** 1/a. False: a holds 0, and out is untouched. */
bool jlt_range_invert(jlt_range *out, const jlt_range *a, slong bits);

/** The square root. False: a holds a negative number, and out is untouched. */
bool jlt_range_root(jlt_range *out, const jlt_range *a, slong bits);

/** A function of Arb over a ball around a. False: it is not shown to be finite everywhere there. */
typedef void (*jlt_range_function)(arb_t out, const arb_t of, slong bits);
bool jlt_range_apply(jlt_range *out, const jlt_range *a, jlt_range_function function, slong bits);

/* -1, 1: all of it is; 0: it holds 0. */
int jlt_range_sign(const jlt_range *a);
bool jlt_range_is_zero(const jlt_range *a); /* [0, 0] */

#endif
