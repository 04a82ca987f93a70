/* Exponentials of a valuation: a basis whose exponents are, together with the logarithms, linearly independent over the rationals;
 * the others are products of integer powers of it: exp(2 e_1) is exp(e_1)^2, and the exponential of a logarithm is its argument. */
#include "algebra/angle.h"
#include "algebra/valuation_state.h"
#include "base/array.h"

#include <stdlib.h>

#define NO_SYMBOL UINT32_MAX

/* The ratio that represents a symbol in linear relations: the definition of an exponential or cosine, a logarithm itself. */
static void column(ttc_valuation *v, ttc_ratio *out, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &v->model->symbols[symbol];
    if (entry->kind == TTC_LOG) ttc_ratio_set_variable(v->ring, out, v->variable[symbol]);
    else ttc_evaluate(v, out, entry->definition);
}

/* Array of column() of each symbol, shape (count,), to be freed by free_columns; NULL, with the ring failed, when memory is out. */
static ttc_ratio *columns_of(ttc_valuation *v, const uint32_t *symbols, size_t count)
{
    ttc_ratio *columns = malloc((count + 1) * sizeof *columns);
    if (columns == NULL) ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
    for (size_t i = 0; columns != NULL && i < count; i++) {
        ttc_ratio_init(v->ring, &columns[i]);
        column(v, &columns[i], symbols[i]);
    }
    return columns;
}

static void free_columns(ttc_valuation *v, ttc_ratio *columns, size_t count)
{
    for (size_t i = 0; columns != NULL && i < count; i++) ttc_ratio_clear(v->ring, &columns[i]);
    free(columns);
}

ttc_trust ttc_valuation_trust(ttc_valuation *v, const ttc_ratio *angle, const uint32_t *basis, size_t count)
{
    ttc_trust trust = TTC_TRUST_NONE;
    uint32_t *free_symbols = malloc((count + 1) * sizeof *free_symbols);
    size_t found = 0;
    for (size_t i = 0; free_symbols != NULL && i < count; i++)
        if (v->ring->trust[v->variable[basis[i]]] == TTC_TRUST_FREE) free_symbols[found++] = basis[i];
    ttc_ratio *columns = free_symbols == NULL ? NULL : columns_of(v, free_symbols, found);
    if (columns == NULL) ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
    else if (v->ring->status == TTC_RING_OK) trust = ttc_ring_trust(v->ring, angle, columns, found, v->variable[0]);
    free_columns(v, columns, found);
    free(free_symbols);
    return trust;
}

/* All logarithms and then all exponentials of the bases; for the caller to free. NULL, with the ring failed, when memory is out. */
static uint32_t *whole_basis(ttc_valuation *v, size_t *count)
{
    uint32_t *symbols = calloc(v->logarithm_count + v->exponential_count + 1, sizeof *symbols);
    *count = 0;
    if (symbols == NULL) ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
    for (size_t i = 0; symbols != NULL && i < v->logarithm_count; i++) symbols[(*count)++] = v->logarithms[i];
    for (size_t i = 0; symbols != NULL && i < v->exponential_count; i++) symbols[(*count)++] = v->exponentials[i];
    return symbols;
}

static void join(ttc_valuation *v, uint32_t symbol, const ttc_ratio *exponent)
{
    size_t count;
    uint32_t *symbols = whole_basis(v, &count);
    if (symbols != NULL)
        v->ring->trust[v->variable[symbol]] = (unsigned char)ttc_valuation_trust(v, exponent, symbols, count);
    v->exponentials[v->exponential_count++] = symbol;
    free(symbols);
}

/* The table's exponentials whose exponents contain no exponentials and logarithms; others join the basis when evaluated. */
static size_t plain_exponentials(ttc_valuation *v, uint32_t *symbols)
{
    const ttc_model *model = v->model;
    size_t count = 0;
    for (uint32_t i = 0; i < model->symbol_count && v->ring->status == TTC_RING_OK; i++) {
        const ttc_symbol_entry *entry = &model->symbols[i];
        if (entry->kind != TTC_EXP) continue;
        unsigned char *support = ttc_model_support(model, &entry->definition, 1);
        bool plain = support != NULL;
        if (support == NULL) ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
        for (uint32_t k = 0; plain && k < model->symbol_count; k++)
            plain = !support[k] || (model->symbols[k].kind != TTC_EXP && model->symbols[k].kind != TTC_LOG);
        free(support);
        if (plain && ttc_valuation_may_join(v, i)) symbols[count++] = i;
        if (count + v->logarithm_count + v->exponential_count >= TTC_ANGLE_LIMIT) ttc_ring_fail(v->ring, TTC_RING_MANY_FUNCTIONS);
    }
    return count;
}

/* Choose the basis among all plain exponentials at once, so that of exp(a) and exp(2 a) it gets the one of which the other is a
 * power. Exponentials in it at this point were used by the expression of a bound state, and stay. exp(0) = 1 is left out. */
static void find_exponentials(ttc_valuation *v)
{
    const size_t most = v->model->symbol_count;
    uint32_t *plain = calloc(most + 1, sizeof *plain), *symbols = NULL;
    ttc_ratio exponent, *columns = NULL;
    size_t chosen[TTC_ANGLE_LIMIT], fixed = 0, total = 0, count = 0, found = 0;

    v->has_exponentials = true;
    ttc_ratio_init(v->ring, &exponent);
    if (plain == NULL) ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
    else count = plain_exponentials(v, plain);
    uint32_t *basis = whole_basis(v, &fixed);
    if (basis != NULL) symbols = realloc(basis, (fixed + count + 1) * sizeof *symbols);
    if (symbols == NULL) {
        free(basis);
        ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
    }
    total = fixed;
    for (size_t i = 0; i < count && v->ring->status == TTC_RING_OK; i++) {
        ttc_evaluate(v, &exponent, v->model->symbols[plain[i]].definition);
        if (!ttc_array_has(symbols, fixed, plain[i]) && !ttc_ratio_is_zero(v->ring, &exponent)) symbols[total++] = plain[i];
    }
    if (total > TTC_ANGLE_LIMIT) ttc_ring_fail(v->ring, TTC_RING_MANY_FUNCTIONS);
    if (v->ring->status == TTC_RING_OK) columns = columns_of(v, symbols, total);
    if (columns != NULL && v->ring->status == TTC_RING_OK) found = ttc_angle_choose(v->ring, chosen, columns, total, fixed, false);
    for (size_t i = fixed; i < found && v->ring->status == TTC_RING_OK; i++) join(v, symbols[chosen[i]], &columns[chosen[i]]);
    v->has_exponentials = v->ring->status == TTC_RING_OK;
    free_columns(v, columns, total);
    ttc_ratio_clear(v->ring, &exponent);
    free(symbols);
    free(plain);
}

/* The product of these powers of the basis; the exponential of a logarithm is its argument. */
static void product(ttc_valuation *v, ttc_ratio *out, const uint32_t *symbols, const long *multiples, size_t count)
{
    ttc_ratio factor;
    ttc_ratio_init(v->ring, &factor);
    ttc_ratio_set_integer(v->ring, out, 1);
    for (size_t i = 0; i < count && v->ring->status == TTC_RING_OK; i++) {
        if (multiples[i] == 0) continue;
        const ttc_symbol_entry *entry = &v->model->symbols[symbols[i]];
        if (entry->kind == TTC_LOG) ttc_evaluate(v, &factor, entry->definition);
        else ttc_valuation_value(v, &factor, symbols[i]); /* evaluated, so that ttc_valuation_add_function_rates sees it */
        ttc_ratio_power(v->ring, &factor, &factor, multiples[i]);
        ttc_ratio_multiply(v->ring, out, out, &factor);
    }
    ttc_ratio_clear(v->ring, &factor);
}

/* The exponential in a plain valuation. symbol: the one that joins the basis if the exponent is independent of it, or NO_SYMBOL. */
static void value_at_exponent(ttc_valuation *v, ttc_ratio *out, const ttc_ratio *exponent, uint32_t symbol)
{
    size_t count;
    bool again = false;
    if (!v->has_exponentials) find_exponentials(v);
    if (ttc_array_has(v->exponentials, v->exponential_count, symbol) || v->ring->status != TTC_RING_OK) return;
    if (ttc_ratio_is_zero(v->ring, exponent)) {
        ttc_ratio_set_integer(v->ring, out, 1);
        return;
    }
    uint32_t *symbols = whole_basis(v, &count);
    long *multiples = calloc(count + 1, sizeof *multiples);
    ttc_ratio *columns = symbols == NULL || multiples == NULL ? NULL : columns_of(v, symbols, count);
    if (columns == NULL) ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
    if (v->ring->status == TTC_RING_OK) {
        ttc_angle_relation relation = ttc_angle_relate(v->ring, multiples, NULL, exponent, columns, count);
        if (v->ring->status != TTC_RING_OK) relation = TTC_ANGLE_FREE;
        else if (relation == TTC_ANGLE_WHOLE) product(v, out, symbols, multiples, count);
        else if (relation == TTC_ANGLE_FRACTION) ttc_ring_fail(v->ring, TTC_RING_EXPONENT_FRACTION);
        else if (symbol != NO_SYMBOL) join(v, symbol, exponent);
        else again = ttc_valuation_meet(v);
        if (relation == TTC_ANGLE_FREE && symbol == NO_SYMBOL && !again) ttc_ring_fail(v->ring, TTC_RING_EXPONENT);
    }
    free_columns(v, columns, count);
    free(multiples);
    free(symbols);
    if (again) value_at_exponent(v, out, exponent, NO_SYMBOL);
}

void ttc_valuation_exp(ttc_valuation *v, ttc_ratio *out, const ttc_ratio *exponent)
{
    value_at_exponent(v, out, exponent, NO_SYMBOL);
}

void ttc_valuation_exp_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol)
{
    ttc_ratio exponent;
    ttc_ratio_init(v->ring, &exponent);
    ttc_evaluate(v, &exponent, v->model->symbols[symbol].definition);
    if (v->base != NULL) ttc_valuation_exp(ttc_valuation_plain(v), out, &exponent);
    else value_at_exponent(v, out, &exponent, symbol);
    if (v->base == NULL && ttc_array_has(v->exponentials, v->exponential_count, symbol))
        ttc_ratio_set_variable(v->ring, out, v->variable[symbol]);
    ttc_ratio_clear(v->ring, &exponent);
}

void ttc_valuation_pi(ttc_valuation *v, ttc_ratio *out)
{
    for (uint32_t i = 0; i < v->model->symbol_count; i++)
        if (v->model->symbols[i].kind == TTC_PI) {
            ttc_ratio_set_variable(v->ring, out, v->variable[i]);
            return;
        }
    ttc_ring_fail(v->ring, TTC_RING_PI);
}

void ttc_valuation_pi_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol)
{
    (void)symbol;
    ttc_valuation_pi(ttc_valuation_plain(v), out);
}
