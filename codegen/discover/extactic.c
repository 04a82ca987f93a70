#include "discover/extactic.h"

#include "discover/claim_text.h"

#include <flint/fmpz_mpoly_factor.h>

enum {
    ROWS_MAX = 5,       /* rows of the determinant */
    TERMS_MAX = 4000     /* of an entry */
};

typedef struct {
    const ttc_flow *flow;
    const fmpz_mpoly_ctx_struct *context;
    fmpz_mpoly_t common;                               /* denominator of all rates */
    fmpz_mpoly_struct rates[ROWS_MAX];                 /* by quantity: times the common denominator */
    fmpz_mpoly_struct entries[ROWS_MAX * ROWS_MAX];
    size_t size;
    int degree;
} extactic;

static fmpz_mpoly_struct *entry(extactic *e, size_t row, size_t column) { return &e->entries[row * e->size + column]; }

static void extactic_init(extactic *e, const ttc_flow *flow)
{
    *e = (extactic){ .flow = flow, .context = flow->ring->context };
    fmpz_mpoly_init(e->common, e->context);
    for (size_t i = 0; i < ROWS_MAX; i++) fmpz_mpoly_init(&e->rates[i], e->context);
    for (size_t i = 0; i < ROWS_MAX * ROWS_MAX; i++) fmpz_mpoly_init(&e->entries[i], e->context);
}

static void extactic_clear(extactic *e)
{
    for (size_t i = 0; i < ROWS_MAX; i++) fmpz_mpoly_clear(&e->rates[i], e->context);
    for (size_t i = 0; i < ROWS_MAX * ROWS_MAX; i++) fmpz_mpoly_clear(&e->entries[i], e->context);
    fmpz_mpoly_clear(e->common, e->context);
}

/* A change of time, which keeps invariant sets, makes the rates polynomials. Returns false if no common denominator was found. */
static bool set_rates(extactic *e)
{
    const ttc_flow *flow = e->flow;
    bool good = true;
    fmpz_mpoly_t part;
    fmpz_mpoly_init(part, e->context);
    fmpz_mpoly_one(e->common, e->context);
    for (size_t i = 0; good && i < flow->count; i++) {
        const fmpz_mpoly_struct *denominator = flow->slopes[flow->variables[i]].denominator;
        good = fmpz_mpoly_gcd(part, e->common, denominator, e->context) != 0
               && fmpz_mpoly_divides(part, denominator, part, e->context) != 0;
        fmpz_mpoly_mul(e->common, e->common, part, e->context);
    }
    for (size_t i = 0; good && i < flow->count; i++) {
        const ttc_ratio *slope = &flow->slopes[flow->variables[i]];
        good = fmpz_mpoly_divides(part, e->common, slope->denominator, e->context) != 0;
        fmpz_mpoly_mul(&e->rates[i], part, slope->numerator, e->context);
    }
    fmpz_mpoly_clear(part, e->context);
    return good;
}

/* The first row before derivatives: the monomials of degree 1 to `degree`, 1 or 2. */
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

/* out = rate of `of`, from which it must differ. Returns false if it has too many terms. */
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

/* The first column from the diagonal on with a nonzero entry in this row, or e->size. */
static size_t pivot_of(extactic *e, size_t row)
{
    size_t column = row;
    while (column < e->size && fmpz_mpoly_is_zero(entry(e, row, column), e->context)) column++;
    return column;
}

/* The determinant, up to its sign, in the last entry, by fraction-free elimination (Bareiss). Returns false if an entry gets too
 * long. */
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

/* Whether P' = K P with P not in the denominator of K: P divides `rate`, P' times the common denominator, to a higher power than
 * that denominator. */
static bool is_invariant(const extactic *e, const fmpz_mpoly_t polynomial, const fmpz_mpoly_t rate)
{
    fmpz_mpoly_t quotient, common;
    fmpz_mpoly_init(quotient, e->context);
    fmpz_mpoly_init(common, e->context);
    fmpz_mpoly_set(common, e->common, e->context);
    bool invariant = fmpz_mpoly_divides(quotient, rate, polynomial, e->context) != 0;
    while (invariant && fmpz_mpoly_divides(common, common, polynomial, e->context) != 0)
        invariant = fmpz_mpoly_divides(quotient, quotient, polynomial, e->context) != 0;
    fmpz_mpoly_clear(common, e->context);
    fmpz_mpoly_clear(quotient, e->context);
    return invariant;
}

/* Whether it was found before, up to its sign, with a constant cofactor. */
static bool is_known(const ttc_discovery *d, const fmpz_mpoly_t polynomial)
{
    const fmpz_mpoly_ctx_struct *context = d->flow->ring->context;
    bool known = false;
    fmpz_mpoly_t negative;
    fmpz_mpoly_init(negative, context);
    fmpz_mpoly_neg(negative, polynomial, context);
    for (size_t i = 0; i < d->factors.count; i++) {
        const fmpz_mpoly_struct *other = d->factors.items[i].value.numerator;
        known |= fmpz_mpoly_equal(other, polynomial, context) != 0 || fmpz_mpoly_equal(other, negative, context) != 0;
    }
    fmpz_mpoly_clear(negative, context);
    return known;
}

/* A remark of any length. Of degree N or less the integral would make the determinant zero. */
static void say_integral(ttc_discovery *d, const fmpz_mpoly_t polynomial)
{
    ttc_text text = { 0 };
    ttc_text_add(&text, "# factors: of a higher degree, and an integral: P = ");
    ttc_claim_text_add(&text, d->flow, polynomial);
    ttc_text_add(&text, "\n");
    d->host.remark(d->host.context, ttc_text_string(&text));
    ttc_text_clear(&text);
}

static void say(ttc_discovery *d, const fmpz_mpoly_t polynomial, const ttc_ratio *cofactor)
{
    ttc_text claim = { 0 }, text = { 0 }, rate = { 0 };
    char *name = ttc_discovery_name(d, "P");
    ttc_claim_text_add(&text, d->flow, polynomial);
    ttc_claim_text_add_ratio(&rate, d->flow, cofactor);
    const bool is_sum = fmpz_mpoly_length(polynomial, d->flow->ring->context) > 1;
    const bool moves = ttc_flow_moves(d->flow, cofactor);
    ttc_text_format(&claim, "rate %s : %s = %s%s%s*%s%s%s%s", name, ttc_text_string(&text), moves ? "(" : "",
                    ttc_text_string(&rate), moves ? ")" : "", is_sum ? "(" : "", ttc_text_string(&text), is_sum ? ")" : "",
                    d->when);
    claim.failed |= text.failed || rate.failed;
    ttc_discovery_publish(d, ttc_text_string(&claim));
    ttc_text_clear(&rate);
    ttc_text_clear(&text);
    ttc_text_clear(&claim);
    flint_free(name);
}

/* Examine a factor of the determinant; add it to `out` if it is invariant and no integral. Returns NULL, or why this failed. */
static const char *look_at(ttc_discovery *d, extactic *e, ttc_factors *out, const fmpz_mpoly_t polynomial)
{
    ttc_ring *ring = d->flow->ring;
    fmpz_mpoly_t rate;
    ttc_ratio value, cofactor;
    fmpz_mpoly_init(rate, e->context);
    ttc_ratio_init(ring, &value);
    ttc_ratio_init(ring, &cofactor);
    derive(e, rate, polynomial);
    if (ttc_flow_degree(d->flow, polynomial) > 0 && fmpz_mpoly_is_zero(rate, e->context)) {
        say_integral(d, polynomial);
    } else if (ttc_flow_degree(d->flow, polynomial) > 0 && is_invariant(e, polynomial, rate)) {
        ttc_ratio_set_polynomial(ring, &value, polynomial);
        ttc_flow_logarithmic_rate(d->flow, &cofactor, &value);
        ttc_factors_add(out, polynomial);
        if (ring->status == TTC_RING_OK && !out->is_full && !is_known(d, polynomial)) say(d, polynomial, &cofactor);
    }
    ttc_ratio_clear(ring, &cofactor);
    ttc_ratio_clear(ring, &value);
    fmpz_mpoly_clear(rate, e->context);
    if (ring->status != TTC_RING_OK) return ttc_ring_status_text(ring->status);
    return out->is_full ? "there are too many of them" : NULL;
}

/* Returns NULL, or why not all factors of the determinant were examined. */
static const char *collect(ttc_discovery *d, extactic *e, ttc_factors *out, const fmpz_mpoly_t determinant)
{
    const char *why = NULL;
    fmpz_mpoly_factor_t parts;
    fmpz_mpoly_t base;
    fmpz_mpoly_factor_init(parts, e->context);
    fmpz_mpoly_init(base, e->context);
    if (fmpz_mpoly_factor(parts, determinant, e->context) == 0) why = "the extactic polynomial could not be factored";
    for (slong i = 0; why == NULL && i < fmpz_mpoly_factor_length(parts, e->context); i++) {
        fmpz_mpoly_factor_get_base(base, parts, i, e->context);
        why = look_at(d, e, out, base);
    }
    fmpz_mpoly_clear(base, e->context);
    fmpz_mpoly_factor_clear(parts, e->context);
    return why;
}

/* The determinant for the greatest N, 1 or 2, for which it does not get too long. Returns false if there is none. */
static bool set_determinant(ttc_discovery *d, extactic *e)
{
    bool good = false;
    if (!set_rates(e)) return false;
    for (int degree = d->flow->count == 2 && d->degree > 1 ? 2 : 1; !good && degree > 0; degree--) {
        set_monomials(e, degree);
        good = set_rows(e) && eliminate(e);
    }
    return good;
}

void ttc_extactic_find(ttc_discovery *d, ttc_factors *out)
{
    const ttc_flow *flow = d->flow;
    const char *why = "the extactic polynomial has too many terms";
    extactic e;
    if (flow->ring->generator_count > 0 || flow->count > ROWS_MAX) {
        ttc_discovery_remark(d, "factors with other cofactors: looked for among up to %d quantities, without roots", ROWS_MAX);
        return;
    }
    d->host.progress(d->host.context, "the extactic polynomial");
    extactic_init(&e, flow);
    const fmpz_mpoly_struct *determinant = set_determinant(d, &e) ? entry(&e, e.size - 1, e.size - 1) : NULL;
    const bool is_zero = determinant != NULL && fmpz_mpoly_is_zero(determinant, e.context) != 0;
    if (determinant != NULL && !is_zero) why = collect(d, &e, out, determinant);
    if (is_zero && flow->count > 2)
        ttc_discovery_remark(d, "factors with other cofactors: some integral is a ratio of two P, of degrees not known");
    else if (is_zero)
        ttc_discovery_remark(d, "factors with other cofactors: some integral is a ratio of two P, deg P <= %d", e.degree);
    else if (why != NULL)
        ttc_discovery_remark(d, "factors with other cofactors: %snot looked for, %s", out->count > 0 ? "others " : "", why);
    else {
        ttc_discovery_remark(d, "factors: no %sirreducible P with P' = K P, K without P in its denominator, deg P <= %d,",
                             out->count > 0 ? "other " : "", e.degree);
        ttc_discovery_remark(d, "         coefficients rational in the parameters (they divide the extactic polynomial, of "
                                "degree %d)", ttc_flow_degree(flow, determinant));
    }
    if (flow->count == 2 && d->degree > 1 && e.degree == 1)
        ttc_discovery_remark(d, "factors of degree 2 are left out: the extactic polynomial has too many terms for them");
    d->host.settle(d->host.context, &(ttc_discovery_settled){ "factors", "P' = K P", e.degree, why == NULL, 0, 0 });
    extactic_clear(&e);
}
