#include "discover/relations.h"

#include "discover/claim_text.h"
#include "discover/gradient.h"

#include <flint/nmod_mat.h>

#include <string.h>

enum { ROWS_TO_SPARE = 6 };

typedef struct {
    ttc_discovery *d;
    ttc_factors list;
} factors;

/* Roots and divisors, which cannot vanish on the domain, come first: a density is a product of these if possible. */
static void gather(factors *f, const ttc_factors *invariant, const ttc_id *given, size_t given_count)
{
    ttc_discovery *d = f->d;
    const ttc_flow *flow = d->flow;
    fmpz_mpoly_t variable;
    ttc_ratio value;
    fmpz_mpoly_init(variable, flow->ring->context);
    ttc_ratio_init(flow->ring, &value);
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < flow->count; i++) {
            fmpz_mpoly_gen(variable, flow->variables[i], flow->ring->context);
            if (flow->is_root[i] == (pass == 0)) ttc_factors_add(&f->list, variable);
        }
        if (pass == 1) break;
        for (size_t i = 0; i < flow->count; i++) ttc_factors_add_all(&f->list, flow->slopes[flow->variables[i]].denominator);
        for (size_t i = 0; i < given_count; i++) {
            if (!ttc_discovery_value(d, &value, given[i])) continue;
            ttc_factors_add_all(&f->list, value.numerator);
            ttc_factors_add_all(&f->list, value.denominator);
        }
        for (size_t i = 0; i < invariant->count; i++) ttc_factors_add(&f->list, &invariant->items[i]);
        for (size_t i = 0; i < d->factors.count; i++) ttc_factors_add(&f->list, d->factors.items[i].value.numerator);
    }
    ttc_factors_drop_radicands(&f->list);
    ttc_ratio_clear(flow->ring, &value);
    fmpz_mpoly_clear(variable, flow->ring->context);
}

/* Each row has, at a random point with random parameters, the logarithmic rates of the factors, and the divergence. */
static bool fill(nmod_mat_t rows, const factors *f)
{
    ttc_discovery *d = f->d;
    ttc_flow *flow = d->flow;
    bool good = true;
    ttc_ratio rate, value;
    ttc_modular_ratio *columns = flint_calloc(f->list.count + 1, sizeof *columns);
    ulong *values = flint_calloc(flow->ring->variable_count, sizeof *values), *logarithmic = flint_calloc(flow->count + 1,
                                                                                                          sizeof *values);
    ttc_ratio_init(flow->ring, &rate);
    ttc_ratio_init(flow->ring, &value);
    for (size_t i = 0; i < f->list.count; i++) {
        ttc_ratio_set_polynomial(flow->ring, &value, &f->list.items[i]);
        ttc_flow_logarithmic_rate(flow, &rate, &value);
        ttc_modular_ratio_set(&columns[i], flow->ring, &rate, flow->mod);
    }
    ttc_modular_ratio_set(&columns[f->list.count], flow->ring, &flow->divergence, flow->mod);
    for (slong r = 0; good && r < rows->r; r++) {
        ttc_flow_draw_parameters(flow, values, -1, &d->source);
        good = ttc_flow_draw(flow, values, logarithmic, &d->source);
        for (size_t i = 0; good && i <= f->list.count; i++) {
            ulong entry = 0;
            good = ttc_modular_ratio_value(&entry, &columns[i], values, flow->mod);
            nmod_mat_entry(rows, r, (slong)i) = entry;
        }
    }
    for (size_t i = 0; i <= f->list.count; i++) ttc_modular_ratio_clear(&columns[i]);
    ttc_ratio_clear(flow->ring, &value);
    ttc_ratio_clear(flow->ring, &rate);
    flint_free(logarithmic);
    flint_free(values);
    flint_free(columns);
    return good && flow->ring->status == TTC_RING_OK;
}

/* The factors with exponents of this sign, in parentheses if there are several and `apart`. Returns their number. */
static size_t add_side(ttc_text *text, const factors *f, const long *exponents, long sign, bool apart)
{
    size_t count = 0, at = 0;
    for (size_t i = 0; i < f->list.count; i++) count += sign * exponents[i] > 0;
    if (count > 1 && apart) ttc_text_add(text, "(");
    for (size_t i = 0; i < f->list.count; i++) {
        const long exponent = sign * exponents[i];
        const bool is_sum = fmpz_mpoly_length(&f->list.items[i], f->d->flow->ring->context) > 1;
        if (exponent <= 0) continue;
        ttc_text_add(text, at++ > 0 ? "*" : "");
        if (is_sum) ttc_text_add(text, "(");
        ttc_claim_text_add(text, f->d->flow, &f->list.items[i]);
        if (is_sum) ttc_text_add(text, ")");
        if (exponent > 1) ttc_text_format(text, "^%ld", exponent);
    }
    if (count > 1 && apart) ttc_text_add(text, ")");
    return count;
}

static void add_product(ttc_text *text, const factors *f, const long *exponents)
{
    ttc_text below = { 0 };
    if (add_side(text, f, exponents, 1, false) == 0) ttc_text_add(text, "1");
    if (add_side(&below, f, exponents, -1, true) > 0) ttc_text_format(text, "/%s", ttc_text_string(&below));
    text->failed |= below.failed;
    ttc_text_clear(&below);
}

static void product_of(ttc_ratio *out, const factors *f, const long *exponents)
{
    ttc_ring *ring = f->d->flow->ring;
    ttc_ratio factor;
    ttc_ratio_init(ring, &factor);
    ttc_ratio_set_integer(ring, out, 1);
    for (size_t i = 0; i < f->list.count; i++) {
        if (exponents[i] == 0) continue;
        ttc_ratio_set_polynomial(ring, &factor, &f->list.items[i]);
        ttc_ratio_power(ring, &factor, &factor, exponents[i]);
        ttc_ratio_multiply(ring, out, out, &factor);
    }
    ttc_ratio_clear(ring, &factor);
}

static void say_integral(factors *f, const long *exponents)
{
    ttc_discovery *d = f->d;
    ttc_ratio value;
    ttc_text claim = { 0 };
    ttc_ratio_init(d->flow->ring, &value);
    product_of(&value, f, exponents);
    if (d->flow->ring->status == TTC_RING_OK && ttc_gradient_is_new(d->flow, &d->integrals, &value, d->parameters, &d->source)) {
        char *name = ttc_discovery_name(d, "F");
        ttc_text_format(&claim, "integral %s = ", name);
        add_product(&claim, f, exponents);
        ttc_text_add(&claim, d->when);
        if (ttc_discovery_publish(d, ttc_text_string(&claim))) ttc_knowns_add(&d->integrals, d->flow, name, &value, NULL, -1);
        flint_free(name);
    }
    ttc_text_clear(&claim);
    ttc_ratio_clear(d->flow->ring, &value);
}

/* exponents: those of the density, twice if `halves`. */
static void say_density(factors *f, const long *exponents, bool halves)
{
    ttc_discovery *d = f->d;
    ttc_ratio value;
    ttc_text product = { 0 };
    ttc_ratio_init(d->flow->ring, &value);
    add_product(&product, f, exponents);
    if (ttc_discovery_publish_density(d, ttc_text_string(&product), halves ? 2 : 1)) {
        product_of(&value, f, exponents);
        ttc_knowns_add(&d->densities, d->flow, "", &value, NULL, 0);
    }
    ttc_text_clear(&product);
    ttc_ratio_clear(d->flow->ring, &value);
}

/* Rational exponents, from residues, times their common denominator. Returns false if they are no small rational numbers. */
static bool whole_exponents(long *exponents, long *denominator, const ulong *residues, size_t count, nmod_t mod)
{
    bool good = true;
    fmpq_t number;
    fmpz_t common;
    fmpq_init(number);
    fmpz_init_set_si(common, 1);
    for (size_t i = 0; i < count && good; i++) {
        good = ttc_modular_rational(number, residues[i], mod);
        fmpz_lcm(common, common, fmpq_denref(number));
    }
    for (size_t i = 0; i < count && good; i++) {
        good = ttc_modular_rational(number, residues[i], mod);
        fmpq_mul_fmpz(number, number, common);
        good = good && fmpz_cmp_si(fmpq_numref(number), TTC_EXPONENT_LIMIT) <= 0
               && fmpz_cmp_si(fmpq_numref(number), -TTC_EXPONENT_LIMIT) >= 0;
        if (good) exponents[i] = fmpz_get_si(fmpq_numref(number));
    }
    *denominator = good ? fmpz_get_si(common) : 0;
    fmpz_clear(common);
    fmpq_clear(number);
    return good;
}

void ttc_relations_find(ttc_discovery *d, const ttc_factors *invariant, const ttc_id *given, size_t given_count)
{
    factors *f = flint_calloc(1, sizeof *f);
    f->d = d;
    ttc_factors_init(&f->list, d->flow);
    gather(f, invariant, given, given_count);
    const slong width = (slong)f->list.count + 1;
    nmod_mat_t rows;
    nmod_mat_init(rows, width + ROWS_TO_SPARE, width, d->flow->mod.n);
    ulong *relation = flint_calloc((size_t)width, sizeof *relation);
    long *exponents = flint_calloc((size_t)width, sizeof *exponents), denominator = 1;
    const slong rank = fill(rows, f) ? nmod_mat_rref(rows) : width;
    slong pivot = 0;
    for (slong j = 0; j < width; j++) { /* the divergence, the last column, is in the last relation alone */
        if (pivot < rank && nmod_mat_entry(rows, pivot, j) != 0) {
            pivot++;
            continue;
        }
        memset(relation, 0, (size_t)width * sizeof *relation);
        relation[j] = 1;
        for (slong i = 0, column = 0; i < pivot; i++) {
            while (nmod_mat_entry(rows, i, column) == 0) column++;
            relation[column] = nmod_neg(nmod_mat_entry(rows, i, j), d->flow->mod);
        }
        if (!whole_exponents(exponents, &denominator, relation, f->list.count, d->flow->mod)) continue;
        if (j + 1 < width) say_integral(f, exponents);
        else if (denominator <= 2 && d->densities.count == 0) say_density(f, exponents, denominator == 2);
    }
    flint_free(exponents);
    flint_free(relation);
    nmod_mat_clear(rows);
    ttc_factors_clear(&f->list);
    flint_free(f);
}
