#include "discover/extactic.h"

#include "discover/claim_text.h"

enum {
    ROWS_MAX = 5,       /* rows of the determinant */
    TERMS_MAX = 4000     /* of an entry */
};

typedef struct {
    const ttc_flow *flow;
    const fmpz_mpoly_ctx_struct *context;
    fmpz_mpoly_struct rates[ROWS_MAX];                 /* by quantity: times the common denominator of all */
    fmpz_mpoly_struct entries[ROWS_MAX * ROWS_MAX];
    size_t size;
    int degree;
} extactic;

static fmpz_mpoly_struct *entry(extactic *e, size_t row, size_t column) { return &e->entries[row * e->size + column]; }

static void extactic_init(extactic *e, const ttc_flow *flow)
{
    *e = (extactic){ .flow = flow, .context = flow->ring->context };
    for (size_t i = 0; i < ROWS_MAX; i++) fmpz_mpoly_init(&e->rates[i], e->context);
    for (size_t i = 0; i < ROWS_MAX * ROWS_MAX; i++) fmpz_mpoly_init(&e->entries[i], e->context);
}

static void extactic_clear(extactic *e)
{
    for (size_t i = 0; i < ROWS_MAX; i++) fmpz_mpoly_clear(&e->rates[i], e->context);
    for (size_t i = 0; i < ROWS_MAX * ROWS_MAX; i++) fmpz_mpoly_clear(&e->entries[i], e->context);
}

/* A change of time, which keeps what is invariant, makes polynomials of the rates. */
static void set_rates(extactic *e)
{
    const ttc_flow *flow = e->flow;
    fmpz_mpoly_t common, part;
    fmpz_mpoly_init(common, e->context);
    fmpz_mpoly_init(part, e->context);
    fmpz_mpoly_one(common, e->context);
    for (size_t i = 0; i < flow->count; i++) {
        const fmpz_mpoly_struct *denominator = flow->slopes[flow->variables[i]].denominator;
        fmpz_mpoly_gcd(part, common, denominator, e->context);
        fmpz_mpoly_divides(part, denominator, part, e->context);
        fmpz_mpoly_mul(common, common, part, e->context);
    }
    for (size_t i = 0; i < flow->count; i++) {
        const ttc_ratio *slope = &flow->slopes[flow->variables[i]];
        fmpz_mpoly_divides(part, common, slope->denominator, e->context);
        fmpz_mpoly_mul(&e->rates[i], part, slope->numerator, e->context);
    }
    fmpz_mpoly_clear(part, e->context);
    fmpz_mpoly_clear(common, e->context);
}

/* The monomials of degree 1 to `degree`, at most 2, are the first row before any derivative. */
static void set_monomials(extactic *e, int degree)
{
    const ttc_flow *flow = e->flow;
    fmpz_mpoly_t factor;
    fmpz_mpoly_init(factor, e->context);
    e->degree = degree;
    e->size = degree == 1 ? flow->count : flow->count * (flow->count + 3) / 2;
    for (size_t i = 0, at = 0; i < flow->count; i++) {
        fmpz_mpoly_gen(entry(e, 0, at), flow->variables[i], e->context);
        at++;
        for (size_t j = 0; degree == 2 && j <= i; j++, at++) {
            fmpz_mpoly_gen(factor, flow->variables[j], e->context);
            fmpz_mpoly_gen(entry(e, 0, at), flow->variables[i], e->context);
            fmpz_mpoly_mul(entry(e, 0, at), entry(e, 0, at), factor, e->context);
        }
    }
    fmpz_mpoly_clear(factor, e->context);
}

/* out may not be `of`. False: it is too long. */
static bool derive(extactic *e, fmpz_mpoly_t out, const fmpz_mpoly_t of)
{
    fmpz_mpoly_t part;
    fmpz_mpoly_init(part, e->context);
    fmpz_mpoly_zero(out, e->context);
    for (size_t i = 0; i < e->flow->count; i++) {
        fmpz_mpoly_derivative(part, of, e->flow->variables[i], e->context);
        fmpz_mpoly_mul(part, part, &e->rates[i], e->context);
        fmpz_mpoly_add(out, out, part, e->context);
    }
    fmpz_mpoly_clear(part, e->context);
    return fmpz_mpoly_length(out, e->context) <= TERMS_MAX;
}

static bool set_rows(extactic *e)
{
    bool good = true;
    for (size_t column = 0; good && column < e->size; column++) {
        fmpz_mpoly_t first;
        fmpz_mpoly_init(first, e->context);
        fmpz_mpoly_swap(first, entry(e, 0, column), e->context);
        for (size_t row = 0; good && row < e->size; row++)
            good = derive(e, entry(e, row, column), row == 0 ? first : entry(e, row - 1, column));
        fmpz_mpoly_clear(first, e->context);
    }
    return good;
}

/* Column with an entry that is not 0 in this row, or the size. */
static size_t pivot_of(extactic *e, size_t row)
{
    size_t column = row;
    while (column < e->size && fmpz_mpoly_is_zero(entry(e, row, column), e->context)) column++;
    return column;
}

/* The determinant, but for its sign, by elimination without fractions (Bareiss), into the last entry. False: it grows too long. */
static bool eliminate(extactic *e)
{
    bool good = true;
    fmpz_mpoly_t left, right;
    fmpz_mpoly_init(left, e->context);
    fmpz_mpoly_init(right, e->context);
    for (size_t k = 0; good && k + 1 < e->size; k++) {
        const size_t pivot = pivot_of(e, k);
        if (pivot == e->size) {
            fmpz_mpoly_zero(entry(e, e->size - 1, e->size - 1), e->context);
            break;
        }
        for (size_t i = 0; i < e->size; i++) fmpz_mpoly_swap(entry(e, i, k), entry(e, i, pivot), e->context);
        for (size_t i = k + 1; good && i < e->size; i++)
            for (size_t j = k + 1; good && j < e->size; j++) {
                fmpz_mpoly_mul(left, entry(e, i, j), entry(e, k, k), e->context);
                fmpz_mpoly_mul(right, entry(e, i, k), entry(e, k, j), e->context);
                fmpz_mpoly_sub(left, left, right, e->context);
                if (k == 0) fmpz_mpoly_swap(entry(e, i, j), left, e->context);
                else fmpz_mpoly_divides(entry(e, i, j), left, entry(e, k - 1, k - 1), e->context);
                good = fmpz_mpoly_length(entry(e, i, j), e->context) <= TERMS_MAX;
            }
    }
    fmpz_mpoly_clear(right, e->context);
    fmpz_mpoly_clear(left, e->context);
    return good;
}

/* K = P'/P where P does not divide its denominator: then P divides P'. */
static bool is_invariant(const ttc_flow *flow, ttc_ratio *cofactor, const fmpz_mpoly_t polynomial)
{
    const fmpz_mpoly_ctx_struct *context = flow->ring->context;
    bool invariant;
    ttc_ratio value;
    fmpz_mpoly_t common;
    ttc_ratio_init(flow->ring, &value);
    fmpz_mpoly_init(common, context);
    ttc_ratio_set_polynomial(flow->ring, &value, polynomial);
    ttc_flow_logarithmic_rate(flow, cofactor, &value);
    invariant = fmpz_mpoly_gcd(common, cofactor->denominator, polynomial, context) != 0 && fmpz_mpoly_is_fmpz(common, context) != 0;
    fmpz_mpoly_clear(common, context);
    ttc_ratio_clear(flow->ring, &value);
    return invariant && flow->ring->status == TTC_RING_OK;
}

static void say(ttc_discovery *d, const fmpz_mpoly_t polynomial, const ttc_ratio *cofactor)
{
    ttc_text claim = { 0 }, text = { 0 }, rate = { 0 };
    char *name = ttc_discovery_name(d, "P");
    ttc_claim_text_add(&text, d->flow, polynomial);
    ttc_claim_text_add_ratio(&rate, d->flow, cofactor);
    const bool is_sum = fmpz_mpoly_length(polynomial, d->flow->ring->context) > 1;
    ttc_text_format(&claim, "rate %s : %s = (%s)*%s%s%s%s", name, ttc_text_string(&text), ttc_text_string(&rate), is_sum ? "(" : "",
                    ttc_text_string(&text), is_sum ? ")" : "", d->when);
    claim.failed |= text.failed || rate.failed;
    ttc_discovery_publish(d, ttc_text_string(&claim));
    ttc_text_clear(&rate);
    ttc_text_clear(&text);
    ttc_text_clear(&claim);
    flint_free(name);
}

/* The invariant ones among the determinant's factors. */
static size_t collect(ttc_discovery *d, ttc_factors *out, const fmpz_mpoly_t determinant)
{
    ttc_factors *all = flint_calloc(1, sizeof *all);
    size_t count = 0;
    ttc_ratio cofactor;
    ttc_ratio_init(d->flow->ring, &cofactor);
    ttc_factors_init(all, d->flow);
    ttc_factors_add_all(all, determinant);
    for (size_t i = 0; i < all->count; i++) {
        if (!is_invariant(d->flow, &cofactor, &all->items[i])) continue;
        ttc_factors_add(out, &all->items[i]);
        count++;
        if (ttc_flow_moves(d->flow, &cofactor)) say(d, &all->items[i], &cofactor);
    }
    ttc_factors_clear(all);
    flint_free(all);
    ttc_ratio_clear(d->flow->ring, &cofactor);
    return count;
}

void ttc_extactic_find(ttc_discovery *d, ttc_factors *out)
{
    const ttc_flow *flow = d->flow;
    bool good = false;
    extactic e;
    if (flow->ring->generator_count > 0 || flow->count > ROWS_MAX) {
        ttc_discovery_remark(d, "factors with other cofactors: looked for among up to %d quantities, without roots", ROWS_MAX);
        return;
    }
    d->host.progress(d->host.context, "the extactic polynomial");
    extactic_init(&e, flow);
    for (int degree = flow->count == 2 && d->degree > 1 ? 2 : 1; !good && degree > 0; degree--) {
        set_rates(&e);
        set_monomials(&e, degree);
        good = set_rows(&e) && eliminate(&e);
    }
    const fmpz_mpoly_struct *determinant = entry(&e, e.size - 1, e.size - 1);
    if (!good)
        ttc_discovery_remark(d, "factors with other cofactors: not looked for, the extactic polynomial has too many terms");
    else if (fmpz_mpoly_is_zero(determinant, flow->ring->context))
        ttc_discovery_remark(d, "factors with other cofactors: some integral is a ratio of two P, deg P <= %d",
                             e.degree);
    else {
        const size_t count = collect(d, out, determinant);
        ttc_discovery_remark(d, "factors: no %sirreducible P with P' = K P, K a function of all, deg P <= %d",
                             count > 0 ? "other " : "", e.degree);
        ttc_discovery_remark(d, "         (they divide the extactic polynomial, of degree %d)", ttc_flow_degree(flow, determinant));
    }
    extactic_clear(&e);
}
