/** Real numbers in a tower of square roots over the rationals, exactly: sums, products and quotients of rationals and of roots
 *  taken one after another. Each root is adjoined only where it is not in the field already, so that a number is zero where all
 *  its coordinates are. */
#ifndef JLT_EXT_SURD_H
#define JLT_EXT_SURD_H

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif
#include <flint/fmpq.h>

#include <stdbool.h>

enum { JLT_SURD_ROOTS_MAX = 4 };

/* coordinates, shape (2^level,): the first half is free of root number `level` - 1, the second half is what stands with it. */
typedef struct {
    unsigned level; /* the least that serves */
    fmpq *coordinates;
} jlt_surd;

typedef struct {
    unsigned count;
    jlt_surd radicands[JLT_SURD_ROOTS_MAX]; /* that of root k is positive, and made of roots before it */
} jlt_surd_field;

jlt_surd_field *jlt_surd_field_create(void);      /* the rationals; NULL when memory is out */
void jlt_surd_field_destroy(jlt_surd_field *field); /* legal on NULL */

void jlt_surd_init(jlt_surd *a); /* zero */
void jlt_surd_clear(jlt_surd *a);
void jlt_surd_set(jlt_surd *out, const jlt_surd *a);
void jlt_surd_set_rational(jlt_surd *out, const fmpq_t value);
void jlt_surd_swap(jlt_surd *a, jlt_surd *b);
bool jlt_surd_is_zero(const jlt_surd *a);

/** Arithmetic; out may alias. Cost: at most 5^level products of rationals a product. */
void jlt_surd_add(jlt_surd *out, const jlt_surd *a, const jlt_surd *b);
void jlt_surd_subtract(jlt_surd *out, const jlt_surd *a, const jlt_surd *b);
void jlt_surd_multiply(jlt_surd *out, const jlt_surd *a, const jlt_surd *b, const jlt_surd_field *field);
bool jlt_surd_invert(jlt_surd *out, const jlt_surd *a, const jlt_surd_field *field); /* false of zero */

/** The positive root, adjoined to the field where it is not in it; false where a is not positive, or the field has as many roots
 *  as it may. */
bool jlt_surd_root(jlt_surd *out, const jlt_surd *a, jlt_surd_field *field);

/** A ball that holds a, computed with so many bits. */
void jlt_surd_enclose(arb_t out, const jlt_surd *a, const jlt_surd_field *field, slong precision);

/** The largest number of bits of a numerator or denominator. */
slong jlt_surd_height(const jlt_surd *a);

#endif
