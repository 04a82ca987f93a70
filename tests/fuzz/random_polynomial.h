/** Small polynomials with whole coefficients, random ones among them, and their text: what tables are made of whose claims are
 *  true, or false, by construction. */
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

/* A few terms of low degree in the variables of the mask, at least one of them not constant where the mask is not empty. */
polynomial polynomial_random(ttc_random *random, unsigned mask, size_t terms, unsigned degree);

polynomial polynomial_add(const polynomial *a, const polynomial *b);
polynomial polynomial_scale(const polynomial *a, long factor);
polynomial polynomial_multiply(const polynomial *a, const polynomial *b); /* terms that do not fit are an error: see full */
polynomial polynomial_derivative(const polynomial *a, size_t variable);

/* True when a sum or a product did not fit since the last call: the result is then wrong. */
bool polynomial_overflowed(void);

bool polynomial_is_zero(const polynomial *a);
bool polynomial_is_number(const polynomial *a);

/* In parentheses, with the names of the variables. */
void polynomial_print(FILE *out, const polynomial *a, const char *const *names);

#endif
