/** Small polynomials with integer coefficients, also random ones, and their text, for tables whose claims are true or false by
 *  construction. */
#ifndef RANDOM_POLYNOMIAL_H
#define RANDOM_POLYNOMIAL_H

#include "challenge/sample.h"

#include <stdbool.h>
#include <stdio.h>

enum { VARIABLES = 12, TERMS = 96 };

typedef struct {
    long coefficient;
    unsigned char exponents[VARIABLES];
} monomial;

typedef struct {
    size_t count;
    monomial terms[TERMS];
} polynomial;

polynomial polynomial_zero(void);
polynomial polynomial_number(long value);
polynomial polynomial_variable(size_t variable);

/* A random polynomial of at most `terms` terms of at most this degree in the variables of the mask; not constant unless the mask is
 * empty. */
polynomial polynomial_random(ttc_random *random, unsigned mask, size_t terms, unsigned degree);

polynomial polynomial_add(const polynomial *a, const polynomial *b);
polynomial polynomial_scale(const polynomial *a, long factor);
polynomial polynomial_multiply(const polynomial *a, const polynomial *b); /* may overflow: see polynomial_overflowed */
polynomial polynomial_derivative(const polynomial *a, size_t variable);

/* Whether a sum or a product has overflowed since the last call, so that its result is wrong. */
bool polynomial_overflowed(void);

bool polynomial_is_zero(const polynomial *a);
bool polynomial_is_number(const polynomial *a);

/* Write it in parentheses, with these names of the variables. */
void polynomial_print(FILE *out, const polynomial *a, const char *const *names);

#endif
