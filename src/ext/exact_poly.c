#include "ext/exact_poly.h"

/* Initialize to `length` zero coefficients. FLINT ends the program if memory is out. */
static void init_length(jlt_exact_poly *p, size_t length)
{
    p->length = length;
    p->coefficients = length == 0 ? NULL : flint_malloc(length * sizeof *p->coefficients);
    for (size_t i = 0; i < length; i++) jlt_surd_init(&p->coefficients[i]);
}

void jlt_exact_poly_init(jlt_exact_poly *p)
{
    init_length(p, 0);
}

void jlt_exact_poly_clear(jlt_exact_poly *p)
{
    for (size_t i = 0; i < p->length; i++) jlt_surd_clear(&p->coefficients[i]);
    flint_free(p->coefficients);
}

static void swap(jlt_exact_poly *p, jlt_exact_poly *q)
{
    const jlt_exact_poly held = *p;

    *p = *q;
    *q = held;
}

/* Move p into out, without leading zeros; p is cleared. */
static void give(jlt_exact_poly *out, jlt_exact_poly *p)
{
    while (p->length > 0 && jlt_surd_is_zero(&p->coefficients[p->length - 1])) jlt_surd_clear(&p->coefficients[--p->length]);
    swap(out, p);
    jlt_exact_poly_clear(p);
}

void jlt_exact_poly_set(jlt_exact_poly *p, const jlt_surd *coefficients, size_t count)
{
    jlt_exact_poly same;

    init_length(&same, count);
    for (size_t i = 0; i < count; i++) jlt_surd_set(&same.coefficients[i], &coefficients[i]);
    give(p, &same);
}

void jlt_exact_poly_shift(jlt_exact_poly *out, const jlt_exact_poly *p, size_t places)
{
    const size_t kept = p->length > places ? p->length - places : 0;

    jlt_exact_poly_set(out, kept == 0 ? NULL : p->coefficients + places, kept);
}

void jlt_exact_poly_reflect(jlt_exact_poly *out, const jlt_exact_poly *p)
{
    jlt_exact_poly turned;
    JLT_SCOPED(jlt_surd, zero);

    init_length(&turned, p->length);
    for (size_t i = 0; i < p->length; i++)
        (i % 2 == 0 ? jlt_surd_add : jlt_surd_subtract)(&turned.coefficients[i], zero, &p->coefficients[i]);
    give(out, &turned);
}

void jlt_exact_poly_derive(jlt_exact_poly *out, const jlt_exact_poly *p)
{
    jlt_exact_poly slope;
    jlt_surd *c;

    init_length(&slope, p->length == 0 ? 0 : p->length - 1);
    for (size_t i = 0; i < slope.length; i++) {
        c = &slope.coefficients[i];
        jlt_surd_set(c, &p->coefficients[i + 1]);
        for (size_t k = 0; k < (size_t)1 << c->roots; k++) {
            fmpz_t factor;
            fmpz_init_set_ui(factor, i + 1);
            fmpq_mul_fmpz(c->coordinates + k, c->coordinates + k, factor);
            fmpz_clear(factor);
        }
    }
    give(out, &slope);
}

void jlt_exact_poly_subtract(jlt_exact_poly *out, const jlt_exact_poly *p, const jlt_exact_poly *q)
{
    jlt_exact_poly difference;

    init_length(&difference, p->length > q->length ? p->length : q->length);
    for (size_t i = 0; i < p->length; i++) jlt_surd_set(&difference.coefficients[i], &p->coefficients[i]);
    for (size_t i = 0; i < q->length; i++)
        jlt_surd_subtract(&difference.coefficients[i], &difference.coefficients[i], &q->coefficients[i]);
    give(out, &difference);
}

void jlt_exact_poly_divide(jlt_exact_poly *quotient, jlt_exact_poly *remainder, const jlt_exact_poly *p, const jlt_exact_poly *q,
                           const jlt_surd_field *field)
{
    jlt_exact_poly ratio, rest;
    JLT_SCOPED(jlt_surd, inverse, factor, term);

    init_length(&rest, p->length);
    for (size_t i = 0; i < p->length; i++) jlt_surd_set(&rest.coefficients[i], &p->coefficients[i]);
    init_length(&ratio, p->length < q->length ? 0 : p->length - q->length + 1);
    (void)jlt_surd_invert(inverse, &q->coefficients[q->length - 1], field);
    for (size_t at = ratio.length; at-- > 0;) {
        jlt_surd_multiply(factor, &rest.coefficients[at + q->length - 1], inverse, field);
        jlt_surd_set(&ratio.coefficients[at], factor);
        for (size_t k = 0; k < q->length; k++) {
            jlt_surd_multiply(term, factor, &q->coefficients[k], field);
            jlt_surd_subtract(&rest.coefficients[at + k], &rest.coefficients[at + k], term);
        }
    }
    if (quotient != NULL) give(quotient, &ratio);
    else jlt_exact_poly_clear(&ratio);
    if (remainder != NULL) give(remainder, &rest);
    else jlt_exact_poly_clear(&rest);
}

static void make_monic(jlt_exact_poly *p, const jlt_surd_field *field)
{

    if (p->length == 0) return;
    JLT_SCOPED(jlt_surd, inverse);
    (void)jlt_surd_invert(inverse, &p->coefficients[p->length - 1], field);
    for (size_t i = 0; i < p->length; i++) jlt_surd_multiply(&p->coefficients[i], &p->coefficients[i], inverse, field);
}

void jlt_exact_poly_gcd(jlt_exact_poly *out, const jlt_exact_poly *p, const jlt_exact_poly *q, const jlt_surd_field *field)
{
    JLT_SCOPED(jlt_exact_poly, a, b);

    jlt_exact_poly_set(a, p->coefficients, p->length);
    jlt_exact_poly_set(b, q->coefficients, q->length);
    while (b->length > 0) {
        make_monic(b, field);
        jlt_exact_poly_divide(NULL, a, a, b, field);
        swap(a, b);
    }
    make_monic(a, field);
    swap(out, a);
}

bool jlt_exact_poly_is_even(const jlt_exact_poly *p)
{
    for (size_t i = 1; i < p->length; i += 2)
        if (!jlt_surd_is_zero(&p->coefficients[i])) return false;
    return true;
}

void jlt_exact_poly_enclose(arb_poly_t out, const jlt_exact_poly *p, const jlt_surd_field *field, slong precision)
{
    JLT_SCOPED(arb, value);

    arb_poly_zero(out);
    for (size_t i = p->length; i-- > 0;) {
        jlt_surd_enclose(value, &p->coefficients[i], field, precision);
        arb_poly_set_coeff_arb(out, (slong)i, value);
    }
}
