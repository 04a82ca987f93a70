#include "fuzz/random_polynomial.h"

#include <stdlib.h>
#include <string.h>

static bool overflowed;

bool polynomial_overflowed(void)
{
    bool result = overflowed;
    overflowed = false;
    return result;
}

polynomial polynomial_zero(void) { return (polynomial){ 0 }; }

static void add_term(polynomial *p, const monomial *term)
{
    if (term->coefficient == 0) return;
    for (size_t i = 0; i < p->count; i++)
        if (memcmp(p->terms[i].exponents, term->exponents, sizeof term->exponents) == 0) {
            p->terms[i].coefficient += term->coefficient;
            if (p->terms[i].coefficient == 0) p->terms[i] = p->terms[--p->count];
            return;
        }
    if (p->count == TERMS) overflowed = true;
    else p->terms[p->count++] = *term;
}

polynomial polynomial_number(long value)
{
    polynomial p = polynomial_zero();
    add_term(&p, &(monomial){ .coefficient = value });
    return p;
}

polynomial polynomial_variable(size_t variable)
{
    polynomial p = polynomial_number(1);
    p.terms[0].exponents[variable] = 1;
    return p;
}

static size_t pick(ttc_random *random, unsigned mask)
{
    size_t variable;
    do variable = (size_t)ttc_random_below(random, VARIABLES);
    while ((mask >> variable & 1) == 0);
    return variable;
}

polynomial polynomial_random(ttc_random *random, unsigned mask, size_t terms, unsigned degree)
{
    polynomial p = polynomial_zero();
    for (size_t i = 0; i < terms; i++) {
        monomial term = { .coefficient = (long)ttc_random_below(random, 9) - 4 };
        if (term.coefficient == 0) term.coefficient = 1;
        unsigned left = (unsigned)ttc_random_below(random, degree + 1) + (i == 0);
        while (mask != 0 && left-- > 0) term.exponents[pick(random, mask)]++;
        add_term(&p, &term);
    }
    return p;
}

polynomial polynomial_add(const polynomial *a, const polynomial *b)
{
    polynomial sum = *a;
    for (size_t i = 0; i < b->count; i++) add_term(&sum, &b->terms[i]);
    return sum;
}

polynomial polynomial_scale(const polynomial *a, long factor)
{
    polynomial p = polynomial_zero();
    for (size_t i = 0; i < a->count; i++) {
        monomial term = a->terms[i];
        term.coefficient *= factor;
        add_term(&p, &term);
    }
    return p;
}

polynomial polynomial_multiply(const polynomial *a, const polynomial *b)
{
    polynomial p = polynomial_zero();
    for (size_t i = 0; i < a->count; i++)
        for (size_t j = 0; j < b->count; j++) {
            monomial term = { .coefficient = a->terms[i].coefficient * b->terms[j].coefficient };
            for (size_t v = 0; v < VARIABLES; v++)
                term.exponents[v] = (unsigned char)(a->terms[i].exponents[v] + b->terms[j].exponents[v]);
            add_term(&p, &term);
        }
    return p;
}

polynomial polynomial_derivative(const polynomial *a, size_t variable)
{
    polynomial p = polynomial_zero();
    for (size_t i = 0; i < a->count; i++) {
        monomial term = a->terms[i];
        term.coefficient *= term.exponents[variable];
        if (term.exponents[variable] > 0) term.exponents[variable]--;
        add_term(&p, &term);
    }
    return p;
}

bool polynomial_is_zero(const polynomial *a) { return a->count == 0; }

bool polynomial_is_number(const polynomial *a)
{
    static const unsigned char none[VARIABLES] = { 0 };
    return a->count == 0 || (a->count == 1 && memcmp(a->terms[0].exponents, none, sizeof none) == 0);
}

void polynomial_print(FILE *out, const polynomial *a, const char *const *names)
{
    fputc('(', out);
    if (a->count == 0) fputc('0', out);
    for (size_t i = 0; i < a->count; i++) {
        fprintf(out, "%s%ld", a->terms[i].coefficient < 0 ? " - " : i > 0 ? " + " : "", labs(a->terms[i].coefficient));
        for (size_t v = 0; v < VARIABLES; v++) {
            if (a->terms[i].exponents[v] == 0) continue;
            fprintf(out, "*%s", names[v]);
            if (a->terms[i].exponents[v] > 1) fprintf(out, "^%u", (unsigned)a->terms[i].exponents[v]);
        }
    }
    fputc(')', out);
}
