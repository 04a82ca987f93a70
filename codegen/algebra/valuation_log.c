/* Logarithms of a valuation: a basis whose arguments are, together with the exponentials, multiplicatively independent; the others
 * are rational combinations of it: log(x^2) is 2 log(x), and the logarithm of an exponential is its exponent.
 *
 * Arguments are compared as products of powers over a coprime base. An argument with roots is replaced by its square, or the square
 * of that, if this has no roots. Otherwise it is compared only with each argument of the basis: for being equal to it, its inverse,
 * or their squares, fourth powers, square or fourth roots; and of its logarithm's independence nothing is known. */
#include "algebra/coprime.h"
#include "algebra/valuation_state.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>

#define NO_SYMBOL UINT32_MAX

/* An argument whose logarithm is known: an exponential, or the argument of a logarithm of the basis. */
typedef struct {
    uint32_t symbol;   /* the exponential or the logarithm */
    ttc_ratio product; /* the argument, or a power of it that contains no roots */
    ulong power;       /* that power: 1, 2, 4 ... */
} comparand;

/* An argument compared with those of the basis. */
typedef struct {
    ttc_valuation *v;
    comparand *items; /* those of the basis, and after them the argument */
    size_t count;     /* number of those of the basis */
    ttc_coprime *base;
    fmpq_mat_t exponents; /* one row for each element of the coprime base, one column for each item */
    fmpq *weights;        /* by item of the basis: the argument is the product of the items to these powers */
} comparison;

/* One more than the index of the last generator that a ratio uses; 0 if it uses none. */
static size_t generators_of(const ttc_ring *ring, const ttc_ratio *a)
{
    size_t count = ring->generator_count;
    while (count > 0 && !ttc_ratio_uses(ring, a, ring->generators[count - 1].variable)) count--;
    return count;
}

/* Square the argument until it contains no roots. Returns false if squaring does not remove its last generator. */
static bool set_product(ttc_ring *ring, comparand *c, const ttc_ratio *argument)
{
    ttc_ratio_set(ring, &c->product, argument);
    c->power = 1;
    for (size_t used = generators_of(ring, argument), before = used + 1; used > 0 && used < before; c->power *= 2) {
        ttc_ratio_multiply(ring, &c->product, &c->product, &c->product);
        before = used;
        used = generators_of(ring, &c->product);
    }
    return generators_of(ring, &c->product) == 0;
}

static void init_comparand(ttc_ring *ring, comparand *c, uint32_t symbol)
{
    c->symbol = symbol;
    c->power = 1;
    ttc_ratio_init(ring, &c->product);
}

static void clear_comparand(ttc_ring *ring, comparand *c) { ttc_ratio_clear(ring, &c->product); }

static bool is_used(const comparison *c, slong variable)
{
    for (size_t i = 0; i <= c->count; i++)
        if (ttc_ratio_uses(c->v->ring, &c->items[i].product, variable)) return true;
    return false;
}

/* Collect the items: the logarithms of the basis, exponentials that their arguments or this one use, and the argument last. Returns
 * false if the argument contains roots that squaring does not remove. */
static bool collect(comparison *c, const ttc_ratio *argument)
{
    ttc_valuation *v = c->v;
    ttc_ratio value;
    c->items = malloc((v->logarithm_count + v->exponential_count + 1) * sizeof *c->items);
    if (c->items == NULL) {
        ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
        return false;
    }
    ttc_ratio_init(v->ring, &value);
    for (size_t i = 0; i < v->logarithm_count; i++) {
        init_comparand(v->ring, &c->items[c->count], v->logarithms[i]);
        ttc_evaluate(v, &value, v->model->symbols[v->logarithms[i]].definition);
        if (set_product(v->ring, &c->items[c->count], &value)) c->count++;
        else clear_comparand(v->ring, &c->items[c->count]);
    }
    init_comparand(v->ring, &c->items[c->count], NO_SYMBOL);
    bool comparable = set_product(v->ring, &c->items[c->count], argument);
    for (size_t i = 0; i < v->exponential_count; i++) {
        slong variable = v->variable[v->exponentials[i]];
        if (!is_used(c, variable)) continue;
        comparand last = c->items[c->count];
        init_comparand(v->ring, &c->items[c->count], v->exponentials[i]);
        ttc_ratio_set_variable(v->ring, &c->items[c->count].product, variable);
        c->items[++c->count] = last;
    }
    ttc_ratio_clear(v->ring, &value);
    return comparable;
}

static bool open_comparison(comparison *c, ttc_valuation *v, const ttc_ratio *argument)
{
    *c = (comparison){ .v = v };
    bool comparable = collect(c, argument);
    if (c->items != NULL && comparable) c->base = ttc_coprime_create(v->ring);
    for (size_t i = 0; c->base != NULL && i <= c->count; i++) ttc_coprime_include(c->base, &c->items[i].product);
    size_t rows = c->base == NULL ? 0 : c->base->count;
    fmpq_mat_init(c->exponents, (slong)rows, (slong)c->count + 1);
    for (size_t i = 0; c->base != NULL && i <= c->count; i++)
        ttc_coprime_exponents(c->base, c->exponents, (slong)i, &c->items[i].product, c->items[i].power);
    c->weights = _fmpq_vec_init((slong)c->count + 1);
    return comparable && v->ring->status == TTC_RING_OK;
}

static void close_comparison(comparison *c)
{
    _fmpq_vec_clear(c->weights, (slong)c->count + 1);
    fmpq_mat_clear(c->exponents);
    ttc_coprime_destroy(c->base);
    for (size_t i = 0; c->items != NULL && i <= c->count; i++) clear_comparand(c->v->ring, &c->items[i]);
    free(c->items);
}

/* Compute the weights with which the argument is a product of powers of the items that are `taken`, whose columns are independent.
 * Other items get weight 0, and rows that are `left_out`, if given, are ignored. Returns false if there are no such weights. */
static bool weigh(comparison *c, const bool *taken, const bool *left_out)
{
    slong columns = 0, rows = 0;
    fmpq_mat_t equations;
    for (size_t i = 0; i < c->count; i++) columns += taken[i];
    fmpq_mat_init(equations, (slong)c->base->count, columns + 1);
    for (size_t k = 0; k < c->base->count; k++) {
        slong column = 0;
        if (left_out != NULL && left_out[k]) continue;
        for (size_t i = 0; i <= c->count; i++)
            if (i == c->count || taken[i])
                fmpq_set(fmpq_mat_entry(equations, rows, column++), fmpq_mat_entry(c->exponents, (slong)k, (slong)i));
        rows++;
    }
    bool related = fmpq_mat_rref(equations, equations) <= columns;
    slong pivot = 0;
    for (size_t i = 0; i < c->count; i++) {
        if (taken[i] && related) fmpq_set(c->weights + i, fmpq_mat_entry(equations, pivot++, columns));
        else fmpq_zero(c->weights + i);
    }
    fmpq_mat_clear(equations);
    return related;
}

static bool is_negative(const ttc_ring *ring, const ttc_ratio *a)
{
    fmpz_t leading;
    fmpz_init(leading);
    fmpz_mpoly_get_term_coeff_fmpz(leading, a->numerator, 0, ring->context);
    bool negative = fmpz_sgn(leading) < 0;
    fmpz_clear(leading);
    return negative;
}

/* The exponent of item i's `product` in the `product` of the argument. */
static void set_power(fmpq_t power, const comparison *c, size_t i)
{
    fmpz_t factor;
    fmpz_init_set_ui(factor, c->items[c->count].power);
    fmpq_mul_fmpz(power, c->weights + i, factor);
    fmpz_set_ui(factor, c->items[i].power);
    fmpq_div_fmpz(power, power, factor);
    fmpz_clear(factor);
}

/* Exponents determine products up to sign: a^n = +- product of g_i^(n w_i). Returns true if the sign is +, as it is for a logarithm
 * to exist, since a and all g_i are positive. */
static bool signs_agree(comparison *c)
{
    bool odd;
    fmpz_t common;
    fmpq_t power;
    fmpz_init(common);
    fmpq_init(power);
    fmpz_one(common);
    for (size_t i = 0; i < c->count; i++) {
        set_power(power, c, i);
        fmpz_lcm(common, common, fmpq_denref(power));
    }
    odd = fmpz_is_odd(common) && is_negative(c->v->ring, &c->items[c->count].product);
    for (size_t i = 0; i < c->count; i++) {
        set_power(power, c, i);
        fmpq_mul_fmpz(power, power, common);
        odd ^= fmpz_is_odd(fmpq_numref(power)) && is_negative(c->v->ring, &c->items[i].product);
    }
    fmpq_clear(power);
    fmpz_clear(common);
    return !odd;
}

static void sum(comparison *c, ttc_ratio *out)
{
    ttc_valuation *v = c->v;
    ttc_ratio term;
    ttc_ratio_init(v->ring, &term);
    ttc_ratio_set_integer(v->ring, out, 0);
    for (size_t i = 0; i < c->count; i++) {
        if (fmpq_is_zero(c->weights + i)) continue;
        const uint32_t symbol = c->items[i].symbol;
        if (v->model->symbols[symbol].kind == TTC_EXP) ttc_evaluate(v, &term, v->model->symbols[symbol].definition);
        else ttc_ratio_set_variable(v->ring, &term, v->variable[symbol]);
        ttc_ratio_scale(v->ring, &term, &term, c->weights + i);
        ttc_ratio_add(v->ring, out, out, &term);
    }
    ttc_ratio_clear(v->ring, &term);
}

/* Returns true if the argument divided by the product of items is a product of powers of integers alone. */
static bool rest_is_rational(comparison *c)
{
    bool rational = true;
    fmpq_t rest;
    fmpq_init(rest);
    for (size_t k = 0; k < c->base->count && rational; k++) {
        if (fmpz_mpoly_is_fmpz(c->base->elements[k], c->v->ring->context)) continue;
        fmpq_set(rest, fmpq_mat_entry(c->exponents, (slong)k, (slong)c->count));
        for (size_t i = 0; i < c->count; i++)
            fmpq_submul(rest, fmpq_mat_entry(c->exponents, (slong)k, (slong)i), c->weights + i);
        rational = fmpq_is_zero(rest) != 0;
    }
    fmpq_clear(rest);
    return rational;
}

/* Returns true if the variables of the argument and of the items taken are known to be independent. */
static bool is_settled(const comparison *c, const bool *taken)
{
    size_t count = 0;
    ttc_ratio *all = malloc((c->count + 1) * sizeof *all); /* borrowed */
    if (all == NULL) return false;
    for (size_t i = 0; i <= c->count; i++)
        if (i == c->count || taken[i]) all[count++] = c->items[i].product;
    bool settled = ttc_ring_settles_all(c->v->ring, all, count);
    free(all);
    return settled;
}

/* Classify the logarithm of an argument that is no product of powers of items: it may be one times a number. constant: by element
 * of the coprime base, whether it is a number. */
static ttc_trust trust_of(comparison *c, const bool *taken, const bool *constant)
{
    if (!is_settled(c, taken)) return TTC_TRUST_NONE;
    if (!weigh(c, taken, constant)) return TTC_TRUST_FREE;
    ttc_trust trust = rest_is_rational(c) ? TTC_TRUST_SINGLE : TTC_TRUST_NONE;
    bool number = true;
    for (size_t k = 0; k < c->base->count; k++)
        number &= constant[k] || fmpq_is_zero(fmpq_mat_entry(c->exponents, (slong)k, (slong)c->count));
    return number ? trust | TTC_TRUST_CONSTANT : trust;
}

static void join(comparison *c, uint32_t symbol, bool *taken)
{
    ttc_valuation *v = c->v;
    bool constant[TTC_COPRIME_LIMIT];
    for (size_t k = 0; k < c->base->count; k++) constant[k] = ttc_ring_is_constant(v->ring, c->base->elements[k]);
    for (size_t i = 0; i < c->count; i++) taken[i] = v->ring->trust[v->variable[c->items[i].symbol]] == TTC_TRUST_FREE;
    v->ring->trust[v->variable[symbol]] = (unsigned char)trust_of(c, taken, constant);
    v->logarithms[v->logarithm_count++] = symbol;
}

/* Returns true if argument^power[0] = other^power[1]; out is their difference. */
static bool is_power(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *argument, const ttc_ratio *other, const long power[2])
{
    ttc_ratio right;
    ttc_ratio_init(ring, &right);
    ttc_ratio_power(ring, out, argument, power[0]);
    ttc_ratio_power(ring, &right, other, power[1]);
    ttc_ratio_subtract(ring, out, out, &right);
    ttc_ratio_clear(ring, &right);
    return ring->status == TTC_RING_OK && fmpz_mpoly_is_zero(out->numerator, ring->context);
}

/* The logarithm of an argument with roots that squaring does not remove: a multiple of one of the basis if a power of the argument
 * is a power of the other's; otherwise it joins the basis. */
static void opaque_value(ttc_valuation *v, ttc_ratio *out, const ttc_ratio *argument, uint32_t symbol)
{
    static const long powers[][2] = { { 1, 1 }, { 1, -1 }, { 1, 2 }, { 1, -2 }, { 2, 1 }, { 2, -1 }, { 1, 4 }, { 1, -4 }, { 4, 1 },
                                      { 4, -1 } };
    bool found = false;
    ttc_ratio other;
    fmpq_t weight;
    ttc_ratio_init(v->ring, &other);
    fmpq_init(weight);
    for (size_t i = 0; i < v->logarithm_count && !found && v->ring->status == TTC_RING_OK; i++) {
        ttc_evaluate(v, &other, v->model->symbols[v->logarithms[i]].definition);
        for (size_t k = 0; k < sizeof powers / sizeof *powers && !found; k++) {
            found = is_power(v->ring, out, argument, &other, powers[k]);
            if (!found) continue;
            fmpq_set_si(weight, powers[k][1], (ulong)powers[k][0]);
            ttc_ratio_set_variable(v->ring, out, v->variable[v->logarithms[i]]);
            ttc_ratio_scale(v->ring, out, out, weight);
        }
    }
    fmpq_clear(weight);
    ttc_ratio_clear(v->ring, &other);
    if (found || v->ring->status != TTC_RING_OK) return;
    if (symbol == NO_SYMBOL) {
        if (ttc_valuation_meet(v)) ttc_valuation_log(v, out, argument);
        else ttc_ring_fail(v->ring, TTC_RING_LOGARITHM);
        return;
    }
    v->ring->trust[v->variable[symbol]] = TTC_TRUST_NONE;
    v->logarithms[v->logarithm_count++] = symbol;
}

/* The logarithm of an argument without roots. Returns true if the caller should try again, as the basis has grown. */
static bool value_of_product(comparison *c, ttc_ratio *out, uint32_t symbol)
{
    bool again = false;
    ttc_ring *ring = c->v->ring;
    bool *taken = malloc((c->count + 1) * sizeof *taken);
    if (taken == NULL) ttc_ring_fail(ring, TTC_RING_NO_MEMORY);
    for (size_t i = 0; taken != NULL && i < c->count; i++) taken[i] = true;
    if (taken == NULL) {
        /* reported */
    } else if (weigh(c, taken, NULL)) {
        if (signs_agree(c)) sum(c, out);
        else ttc_ring_fail(ring, TTC_RING_LOG_OF_NEGATIVE);
    } else if (symbol == NO_SYMBOL) {
        again = ttc_valuation_meet(c->v);
        if (!again) ttc_ring_fail(ring, TTC_RING_LOGARITHM);
    } else {
        join(c, symbol, taken);
    }
    free(taken);
    return again;
}

/* The logarithm in a plain valuation. symbol: the one that joins the basis if the argument is independent of it, or NO_SYMBOL. */
static void value_at_argument(ttc_valuation *v, ttc_ratio *out, const ttc_ratio *argument, uint32_t symbol)
{
    if (v->ring->status != TTC_RING_OK) return;
    if (ttc_ratio_is_zero(v->ring, argument)) ttc_ring_fail(v->ring, TTC_RING_LOG_OF_ZERO);
    else if (ttc_ratio_sign(v->ring, argument) < 0) ttc_ring_fail(v->ring, TTC_RING_LOG_OF_NEGATIVE);
    if (v->ring->status != TTC_RING_OK) return;
    comparison c;
    bool again = false;
    if (open_comparison(&c, v, argument)) again = value_of_product(&c, out, symbol);
    else opaque_value(v, out, argument, symbol);
    close_comparison(&c);
    if (again) value_at_argument(v, out, argument, symbol);
}

void ttc_valuation_log(ttc_valuation *v, ttc_ratio *out, const ttc_ratio *argument)
{
    value_at_argument(v, out, argument, NO_SYMBOL);
}

void ttc_valuation_log_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol)
{
    size_t before;
    ttc_ratio argument;
    ttc_ratio_init(v->ring, &argument);
    ttc_evaluate(v, &argument, v->model->symbols[symbol].definition);
    before = v->logarithm_count;
    if (v->base != NULL) ttc_valuation_log(ttc_valuation_plain(v), out, &argument);
    else value_at_argument(v, out, &argument, symbol);
    if (v->logarithm_count > before) ttc_ratio_set_variable(v->ring, out, v->variable[symbol]);
    ttc_ratio_clear(v->ring, &argument);
}
