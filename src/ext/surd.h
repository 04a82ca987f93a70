/** Exact real numbers in a tower of square roots over the rationals: sums, products and quotients of rationals and of successive
 *  square roots. Only roots outside the field are adjoined, so a number is zero exactly if its coordinates are. */
#ifndef JLT_EXT_SURD_H
#define JLT_EXT_SURD_H

#include "ext/scoped.h"

#include <flint/fmpq.h>

#include <stdbool.h>

enum { JLT_SURD_ROOTS_MAX = 4 };

/* coordinates, shape (2^roots,): with t the last of its roots, the number is (first half) + (second half) t. */
typedef struct {
    unsigned roots; /* how many of the field's first roots it needs */
    fmpq *coordinates;
    fmpq few[2];    /* where they lie if there are no more */
} jlt_surd; /* not to be copied by assignment: see jlt_surd_set, jlt_surd_swap */

typedef struct {
    unsigned count;
    jlt_surd radicands[JLT_SURD_ROOTS_MAX]; /* of root k: positive, in the field of the roots before it */
} jlt_surd_field;

jlt_surd_field *jlt_surd_field_create(void);      /* the rationals; returns NULL if memory is out */
void jlt_surd_field_destroy(jlt_surd_field *field); /* legal on NULL */

void jlt_surd_init(jlt_surd *a); /* zero */
void jlt_surd_clear(jlt_surd *a);

typedef jlt_surd jlt_surd_t[1];
JLT_SCOPED_TYPE(jlt_surd, jlt_surd)

void jlt_surd_set(jlt_surd *out, const jlt_surd *a);
void jlt_surd_set_rational(jlt_surd *out, const fmpq_t value);
void jlt_surd_swap(jlt_surd *a, jlt_surd *b);
bool jlt_surd_is_zero(const jlt_surd *a);

/** Arithmetic; out may alias inputs. Cost: at most 5^roots products of rationals per product. */
void jlt_surd_add(jlt_surd *out, const jlt_surd *a, const jlt_surd *b);
void jlt_surd_subtract(jlt_surd *out, const jlt_surd *a, const jlt_surd *b);
void jlt_surd_multiply(jlt_surd *out, const jlt_surd *a, const jlt_surd *b, const jlt_surd_field *field);
bool jlt_surd_invert(jlt_surd *out, const jlt_surd *a, const jlt_surd_field *field); /* returns false if a is zero */

/** The positive square root of a; it is adjoined to the field if the field does not contain it. Returns false if a is not
 *  positive, or a root would have to be adjoined to a field that already has JLT_SURD_ROOTS_MAX. */
bool jlt_surd_root(jlt_surd *out, const jlt_surd *a, jlt_surd_field *field);

/** A ball that contains a, computed with `precision` bits. */
void jlt_surd_enclose(arb_t out, const jlt_surd *a, const jlt_surd_field *field, slong precision);

/** The largest number of bits of a numerator or denominator among the coordinates. */
slong jlt_surd_height(const jlt_surd *a);

#endif
