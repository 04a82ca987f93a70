/** Exact polynomials with coefficients in a tower of square roots. Outputs must be initialized before a call, and may alias
 *  inputs. FLINT ends the program if memory is out. */
#ifndef JLT_EXT_EXACT_POLY_H
#define JLT_EXT_EXACT_POLY_H

#include "ext/surd.h"

#include <stddef.h>

typedef struct {
    size_t length; /* number of coefficients, the last of them not zero; 0: the zero polynomial */
    jlt_surd *coefficients; /* constant term first */
} jlt_exact_poly;

void jlt_exact_poly_init(jlt_exact_poly *p); /* zero */
void jlt_exact_poly_clear(jlt_exact_poly *p);

typedef jlt_exact_poly jlt_exact_poly_t[1];
JLT_SCOPED_TYPE(jlt_exact_poly, jlt_exact_poly)

/* The polynomial with these coefficients, shape (count,). */
void jlt_exact_poly_set(jlt_exact_poly *p, const jlt_surd *coefficients, size_t count);

void jlt_exact_poly_shift(jlt_exact_poly *out, const jlt_exact_poly *p, size_t places); /* p/x^places, lower terms dropped */
void jlt_exact_poly_reflect(jlt_exact_poly *out, const jlt_exact_poly *p);              /* p(-x) */
void jlt_exact_poly_derive(jlt_exact_poly *out, const jlt_exact_poly *p);
void jlt_exact_poly_subtract(jlt_exact_poly *out, const jlt_exact_poly *p, const jlt_exact_poly *q);

/* Divide p by q, which is not zero, with remainder. quotient or remainder may be NULL; outputs may alias inputs. */
void jlt_exact_poly_divide(jlt_exact_poly *quotient, jlt_exact_poly *remainder, const jlt_exact_poly *p, const jlt_exact_poly *q,
                           const jlt_surd_field *field);

/** The monic greatest common divisor, by Euclid's algorithm on monic remainders. Cost: the heights of coefficients grow with the
 *  square of the degree. */
void jlt_exact_poly_gcd(jlt_exact_poly *out, const jlt_exact_poly *p, const jlt_exact_poly *q, const jlt_surd_field *field);

bool jlt_exact_poly_is_even(const jlt_exact_poly *p); /* p(-x) = p(x) */

/* Enclose the coefficients in balls, computed with `precision` bits. */
void jlt_exact_poly_enclose(arb_poly_t out, const jlt_exact_poly *p, const jlt_surd_field *field, slong precision);

#endif
