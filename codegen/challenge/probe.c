#include "challenge/probe.h"

#include <stdlib.h>
#include <string.h>

typedef enum { UNKNOWN, GOOD, BAD } knowledge;

struct ttc_probe {
    const ttc_model *model;
    size_t width;
    long precision;
    arb_ptr leaves;       /* by symbol, shape (symbol_count, width) */
    unsigned char *known; /* by symbol */
    ttc_id zeros[TTC_PROBE_SPARE]; /* expressions known to be zero */
    size_t zero_count;
    arb_ptr *jets;        /* by node; allocated when first needed, and kept */
    unsigned char *state; /* knowledge, by node */
    size_t node_count;
    ttc_id *stack;
    size_t stack_size;
    arb_ptr power; /* room for one factor of a product, and for the product before it */
    arb_ptr partial;
};

ttc_probe *ttc_probe_create(const ttc_model *model)
{
    ttc_probe *probe = calloc(1, sizeof *probe);
    if (probe == NULL) return NULL;
    probe->model = model;
    probe->width = 1 + model->state_count + TTC_PROBE_SPARE;
    probe->precision = 128;
    probe->known = calloc(model->symbol_count + 1, 1);
    if (probe->known == NULL) {
        free(probe);
        return NULL;
    }
    probe->leaves = _arb_vec_init((long)(model->symbol_count * probe->width));
    probe->power = _arb_vec_init((long)probe->width);
    probe->partial = _arb_vec_init((long)probe->width);
    return probe;
}

void ttc_probe_destroy(ttc_probe *probe)
{
    if (probe == NULL) return;
    for (size_t i = 0; i < probe->node_count; i++)
        if (probe->jets[i] != NULL) _arb_vec_clear(probe->jets[i], (long)probe->width);
    _arb_vec_clear(probe->leaves, (long)(probe->model->symbol_count * probe->width));
    _arb_vec_clear(probe->power, (long)probe->width);
    _arb_vec_clear(probe->partial, (long)probe->width);
    free(probe->stack);
    free(probe->state);
    free(probe->jets);
    free(probe->known);
    free(probe);
}

size_t ttc_probe_width(const ttc_probe *probe) { return probe->width; }
long ttc_probe_precision(const ttc_probe *probe) { return probe->precision; }

static void forget(ttc_probe *probe)
{
    if (probe->state != NULL) memset(probe->state, UNKNOWN, probe->node_count);
}

/* A symbol gets another value, or all do. */
static void move(ttc_probe *probe)
{
    probe->zero_count = 0;
    forget(probe);
}

void ttc_probe_begin(ttc_probe *probe, long precision)
{
    probe->precision = precision;
    memset(probe->known, 0, probe->model->symbol_count);
    move(probe);
}

static arb_ptr leaf(const ttc_probe *probe, uint32_t symbol) { return probe->leaves + symbol * probe->width; }

void ttc_probe_set_jet(ttc_probe *probe, uint32_t symbol, arb_srcptr jet)
{
    _arb_vec_set(leaf(probe, symbol), jet, (long)probe->width);
    probe->known[symbol] = 1;
    move(probe);
}

void ttc_probe_set(ttc_probe *probe, uint32_t symbol, const arb_t value)
{
    arb_set(leaf(probe, symbol), value);
    _arb_vec_zero(leaf(probe, symbol) + 1, (long)probe->width - 1);
    probe->known[symbol] = 1;
    move(probe);
}

void ttc_probe_seed(ttc_probe *probe, uint32_t symbol, size_t slot)
{
    _arb_vec_zero(leaf(probe, symbol) + 1, (long)probe->width - 1);
    arb_one(leaf(probe, symbol) + 1 + slot);
    forget(probe);
}

void ttc_probe_seed_states(ttc_probe *probe)
{
    for (uint32_t i = 0; i < probe->model->symbol_count; i++) _arb_vec_zero(leaf(probe, i) + 1, (long)probe->width - 1);
    for (size_t k = 0; k < probe->model->state_count; k++) arb_one(leaf(probe, probe->model->states[k]) + 1 + k);
    forget(probe);
}

void ttc_probe_set_zero(ttc_probe *probe, ttc_id id)
{
    probe->zeros[probe->zero_count++] = id;
    forget(probe);
}

bool ttc_probe_is_set(const ttc_probe *probe, uint32_t symbol) { return probe->known[symbol] != 0; }
arb_srcptr ttc_probe_value(const ttc_probe *probe, uint32_t symbol) { return leaf(probe, symbol); }

static bool make_room(ttc_probe *probe)
{
    size_t count = ttc_graph_size(probe->model->graph) + 1;
    if (count <= probe->node_count) return true;
    arb_ptr *jets = realloc(probe->jets, count * sizeof *jets);
    if (jets == NULL) return false;
    probe->jets = jets;
    unsigned char *state = realloc(probe->state, count);
    if (state == NULL) return false;
    probe->state = state;
    for (size_t i = probe->node_count; i < count; i++) {
        jets[i] = NULL;
        state[i] = UNKNOWN;
    }
    probe->node_count = count;
    return true;
}

/* derivative of out = factor * derivative of `of`, along every tangent */
static void chain(ttc_probe *probe, arb_ptr out, const arb_t factor, arb_srcptr of)
{
    for (size_t k = 1; k < probe->width; k++) arb_mul(out + k, of + k, factor, probe->precision);
}

/* out = sqrt(of): sqrt' = 1/(2 sqrt) */
static bool take_root(ttc_probe *probe, arb_ptr out, arb_srcptr of)
{
    arb_t factor;
    if (!arb_is_positive(of)) return false;
    arb_init(factor);
    arb_sqrt(out, of, probe->precision);
    arb_mul_2exp_si(factor, out, 1);
    arb_inv(factor, factor, probe->precision);
    chain(probe, out, factor, of);
    arb_clear(factor);
    return true;
}

static void take_angle(ttc_probe *probe, arb_ptr out, arb_srcptr of, bool cosine)
{
    arb_t factor;
    arb_init(factor);
    if (cosine) {
        arb_sin_cos(factor, out, of, probe->precision);
        arb_neg(factor, factor);
    } else {
        arb_sin_cos(out, factor, of, probe->precision);
    }
    chain(probe, out, factor, of);
    arb_clear(factor);
}

/* out = log(of), log' = 1/of */
static bool take_logarithm(ttc_probe *probe, arb_ptr out, arb_srcptr of)
{
    arb_t factor;
    if (!arb_is_positive(of)) return false;
    arb_init(factor);
    arb_log(out, of, probe->precision);
    arb_inv(factor, of, probe->precision);
    chain(probe, out, factor, of);
    arb_clear(factor);
    return true;
}

static void take_exponential(ttc_probe *probe, arb_ptr out, arb_srcptr of)
{
    arb_exp(out, of, probe->precision);
    chain(probe, out, out, of);
}

static void take_pi(ttc_probe *probe, arb_ptr out)
{
    arb_const_pi(out, probe->precision);
    _arb_vec_zero(out + 1, (long)probe->width - 1);
}

static bool evaluate_symbol(ttc_probe *probe, arb_ptr out, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &probe->model->symbols[symbol];
    if (probe->known[symbol]) {
        _arb_vec_set(out, leaf(probe, symbol), (long)probe->width);
        return true;
    }
    if (entry->kind == TTC_PI) {
        take_pi(probe, out);
        return true;
    }
    if (entry->definition == TTC_NONE || probe->state[entry->definition] != GOOD) return false;
    arb_srcptr of = probe->jets[entry->definition];
    switch (entry->kind) {
    case TTC_ROOT: return take_root(probe, out, of);
    case TTC_COSINE:
    case TTC_SINE: take_angle(probe, out, of, entry->kind == TTC_COSINE); return true;
    case TTC_EXP: take_exponential(probe, out, of); return true;
    case TTC_LOG: return take_logarithm(probe, out, of);
    default: _arb_vec_set(out, of, (long)probe->width); return true;
    }
}

/* out = base^exponent, derivative exponent * base^(exponent - 1) * base' */
static bool take_power(ttc_probe *probe, arb_ptr out, arb_srcptr base, long exponent)
{
    fmpz_t e;
    arb_t factor;
    if (exponent < 0 && arb_contains_zero(base)) return false;
    arb_init(factor);
    fmpz_init_set_si(e, exponent - 1);
    arb_pow_fmpz(factor, base, e, probe->precision);
    arb_mul(out, factor, base, probe->precision);
    arb_mul_si(factor, factor, exponent, probe->precision);
    chain(probe, out, factor, base);
    fmpz_clear(e);
    arb_clear(factor);
    return true;
}

static bool evaluate_product(ttc_probe *probe, arb_ptr out, ttc_id id)
{
    const ttc_graph *graph = probe->model->graph;
    arb_set_fmpq(out, ttc_coefficient(graph, id), probe->precision);
    _arb_vec_zero(out + 1, (long)probe->width - 1);
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        arb_srcptr base = probe->jets[part.id], factor = base;
        if (part.exponent != 1) {
            if (!take_power(probe, probe->power, base, part.exponent)) return false;
            factor = probe->power;
        }
        _arb_vec_set(probe->partial, out, (long)probe->width);
        arb_mul(out, probe->partial, factor, probe->precision);
        for (size_t k = 1; k < probe->width; k++) {
            arb_mul(out + k, probe->partial + k, factor, probe->precision);
            arb_addmul(out + k, probe->partial, factor + k, probe->precision);
        }
    }
    return true;
}

static void evaluate_sum(ttc_probe *probe, arb_ptr out, ttc_id id)
{
    const ttc_graph *graph = probe->model->graph;
    arb_t coefficient;
    arb_init(coefficient);
    arb_set_fmpq(out, ttc_coefficient(graph, id), probe->precision);
    _arb_vec_zero(out + 1, (long)probe->width - 1);
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        arb_set_fmpq(coefficient, part.coefficient, probe->precision);
        for (size_t k = 0; k < probe->width; k++)
            arb_addmul(out + k, probe->jets[part.id] + k, coefficient, probe->precision);
    }
    arb_clear(coefficient);
}

/* Evaluate a node whose parts are known. */
static void evaluate(ttc_probe *probe, ttc_id id)
{
    const ttc_graph *graph = probe->model->graph;
    bool good = true;
    if (probe->jets[id] == NULL) probe->jets[id] = _arb_vec_init((long)probe->width);
    arb_ptr out = probe->jets[id];
    for (size_t i = 0; good && i < ttc_part_count(graph, id); i++) good = probe->state[ttc_part_at(graph, id, i).id] == GOOD;
    if (good) {
        switch (ttc_kind_of(graph, id)) {
        case TTC_NUMBER:
            arb_set_fmpq(out, ttc_coefficient(graph, id), probe->precision);
            _arb_vec_zero(out + 1, (long)probe->width - 1);
            break;
        case TTC_SYMBOL: good = evaluate_symbol(probe, out, ttc_symbol_of(graph, id)); break;
        case TTC_PRODUCT: good = evaluate_product(probe, out, id); break;
        case TTC_SUM: evaluate_sum(probe, out, id); break;
        }
    }
    for (size_t i = 0; i < probe->zero_count; i++)
        if (probe->zeros[i] == id) arb_zero(out);
    probe->state[id] = good && arb_is_finite(out) ? GOOD : BAD;
}

static bool push(ttc_probe *probe, size_t *count, ttc_id id)
{
    if (*count == probe->stack_size) {
        size_t size = 2 * probe->stack_size + 64;
        ttc_id *stack = realloc(probe->stack, size * sizeof *stack);
        if (stack == NULL) return false;
        probe->stack = stack;
        probe->stack_size = size;
    }
    probe->stack[(*count)++] = id;
    return true;
}

/* Push what the node needs and is not yet known: parts, or the definition of a symbol without a value. */
static bool push_needs(ttc_probe *probe, size_t *count, ttc_id id)
{
    const ttc_graph *graph = probe->model->graph;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) {
        uint32_t symbol = ttc_symbol_of(graph, id);
        ttc_id definition = probe->model->symbols[symbol].definition;
        if (probe->known[symbol] || definition == TTC_NONE || probe->state[definition] != UNKNOWN) return true;
        return push(probe, count, definition);
    }
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        ttc_id part = ttc_part_at(graph, id, i).id;
        if (probe->state[part] == UNKNOWN && !push(probe, count, part)) return false;
    }
    return true;
}

arb_srcptr ttc_probe_at(ttc_probe *probe, ttc_id id)
{
    size_t count = 0;
    if (id == TTC_NONE || !make_room(probe) || !push(probe, &count, id)) return NULL;
    while (count > 0) {
        ttc_id top = probe->stack[count - 1];
        size_t before = count;
        if (probe->state[top] != UNKNOWN) {
            count--;
            continue;
        }
        if (!push_needs(probe, &count, top)) return NULL;
        if (count > before) continue;
        evaluate(probe, top);
        count--;
    }
    return probe->state[id] == GOOD ? probe->jets[id] : NULL;
}
