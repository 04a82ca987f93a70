#include "fields/coefficients.h"

#include <stdlib.h>

/* Polynomials in `symbol` are arrays of degree + 1 coefficients, lowest power first. */
typedef struct {
    ttc_graph *graph;
    size_t degree;
    uint32_t symbol;
} ring;

static bool polynomial(const ring *r, ttc_id *out, ttc_id id);

static ttc_id *zero_polynomial(const ring *r)
{
    ttc_id *p = malloc((r->degree + 1) * sizeof *p);
    for (size_t i = 0; p != NULL && i <= r->degree; i++) p[i] = ttc_integer(r->graph, 0);
    return p;
}

static bool multiply_by(const ring *r, ttc_id *p, const ttc_id *q)
{
    ttc_id *product = zero_polynomial(r);
    bool ok = product != NULL;
    for (size_t i = 0; ok && i <= r->degree; i++)
        for (size_t j = 0; ok && j <= r->degree; j++) {
            ttc_id term = ttc_multiply(r->graph, p[i], q[j]);
            ok = term != TTC_NONE;
            if (!ok || ttc_is_number(r->graph, term, 0)) continue;
            ok = i + j <= r->degree;
            if (ok) product[i + j] = ttc_add(r->graph, product[i + j], term);
        }
    for (size_t i = 0; ok && i <= r->degree; i++) p[i] = product[i];
    free(product);
    return ok;
}

static bool product_polynomial(const ring *r, ttc_id *out, ttc_id id)
{
    out[0] = ttc_number(r->graph, ttc_coefficient(r->graph, id));
    ttc_id *base = zero_polynomial(r);
    bool ok = base != NULL;
    for (size_t k = 0; ok && k < ttc_part_count(r->graph, id); k++) {
        ttc_part part = ttc_part_at(r->graph, id, k);
        for (size_t i = 0; i <= r->degree; i++) base[i] = ttc_integer(r->graph, 0);
        if (!ttc_depends(r->graph, part.id, r->symbol)) {
            base[0] = ttc_power(r->graph, part.id, part.exponent);
            ok = multiply_by(r, out, base);
            continue;
        }
        ok = part.exponent > 0 && polynomial(r, base, part.id);
        for (int32_t e = 0; ok && e < part.exponent; e++) ok = multiply_by(r, out, base);
    }
    free(base);
    return ok;
}

static bool sum_polynomial(const ring *r, ttc_id *out, ttc_id id)
{
    out[0] = ttc_number(r->graph, ttc_coefficient(r->graph, id));
    ttc_id *term = zero_polynomial(r);
    bool ok = term != NULL;
    for (size_t k = 0; ok && k < ttc_part_count(r->graph, id); k++) {
        ttc_part part = ttc_part_at(r->graph, id, k);
        for (size_t i = 0; i <= r->degree; i++) term[i] = ttc_integer(r->graph, 0);
        ok = polynomial(r, term, part.id);
        for (size_t i = 0; ok && i <= r->degree; i++)
            out[i] = ttc_add(r->graph, out[i], ttc_scale(r->graph, term[i], part.coefficient));
    }
    free(term);
    return ok;
}

static bool polynomial(const ring *r, ttc_id *out, ttc_id id)
{
    if (!ttc_depends(r->graph, id, r->symbol)) {
        out[0] = id;
        return true;
    }
    switch (ttc_kind_of(r->graph, id)) {
    case TTC_PRODUCT: return product_polynomial(r, out, id);
    case TTC_SUM: return sum_polynomial(r, out, id);
    default:
        if (r->degree == 0) return false;
        out[1] = ttc_integer(r->graph, 1);
        return true;
    }
}

bool ttc_polynomial_coefficients(ttc_graph *graph, ttc_id *coefficients, size_t degree, ttc_id expression, uint32_t symbol)
{
    ring r = { graph, degree, symbol };
    ttc_id *p = zero_polynomial(&r);
    bool ok = p != NULL && polynomial(&r, p, expression);
    for (size_t i = 0; ok && i <= degree; i++) {
        coefficients[i] = p[degree - i];
        ok = coefficients[i] != TTC_NONE;
    }
    free(p);
    return ok;
}
