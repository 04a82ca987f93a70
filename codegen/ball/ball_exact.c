#include "ball/ball_exact.h"

#include <stdlib.h>
#include <string.h>

typedef enum { UNKNOWN, GOOD, BAD } knowledge;

void ttc_ball_exact_clear(ttc_ball_exact *exact)
{
    for (size_t i = 0; i < exact->size; i++) fmpq_clear(&exact->fractions[i]);
    free(exact->fractions);
    free(exact->state);
    *exact = (ttc_ball_exact){ 0 };
}

void ttc_ball_exact_forget(ttc_ball_exact *exact)
{
    if (exact->size > 0) memset(exact->state, UNKNOWN, exact->size);
}

/* Make room for all nodes; if the graph has grown, all is forgotten. */
static bool room(ttc_ball_exact *exact, const ttc_graph *graph)
{
    const size_t size = ttc_graph_size(graph) + 1;

    if (exact->size >= size) return true;
    ttc_ball_exact_clear(exact);
    exact->state = calloc(size, 1);
    exact->fractions = malloc(size * sizeof *exact->fractions);
    if (exact->state == NULL || exact->fractions == NULL) {
        ttc_ball_exact_clear(exact);
        return false;
    }
    exact->size = size;
    for (size_t i = 0; i < size; i++) fmpq_init(&exact->fractions[i]);
    return true;
}

static bool evaluate(ttc_ball_exact *exact, const ttc_ball_symbols *symbols, ttc_id id);

static bool evaluate_symbol(fmpq_t out, ttc_ball_exact *exact, const ttc_ball_symbols *symbols, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &symbols->model->symbols[symbol];
    const bool bound = symbols->bound[symbol] != TTC_NONE;
    const ttc_id meaning = bound ? symbols->bound[symbol] : entry->definition;

    if (symbols->known[symbol]) {
        fmpq_set(out, &symbols->values[symbol]);
        return true;
    }
    if (meaning == TTC_NONE || (!bound && entry->kind != TTC_ROOT && entry->kind != TTC_LET)) return false;
    if (!evaluate(exact, symbols, meaning)) return false;
    if (!bound && entry->kind == TTC_ROOT) return ttc_symbol_rational(out, TTC_ROOT, &exact->fractions[meaning]);
    fmpq_set(out, &exact->fractions[meaning]);
    return true;
}

static bool evaluate_parts(fmpq_t out, ttc_ball_exact *exact, const ttc_ball_symbols *symbols, ttc_id id)
{
    const ttc_graph *graph = symbols->model->graph;
    const bool product = ttc_kind_of(graph, id) == TTC_PRODUCT;
    const size_t count = ttc_part_count(graph, id);
    fmpq_t term;
    bool good = true;

    fmpq_init(term);
    fmpq_set(out, ttc_coefficient(graph, id));
    for (size_t i = 0; good && i < count; i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        const fmpq *value = &exact->fractions[part.id];
        good = evaluate(exact, symbols, part.id) && !(product && part.exponent < 0 && fmpq_is_zero(value));
        if (!good) break;
        if (product) {
            fmpq_pow_si(term, value, part.exponent);
            fmpq_mul(out, out, term);
        } else {
            fmpq_mul(term, value, part.coefficient);
            fmpq_add(out, out, term);
        }
    }
    fmpq_clear(term);
    return good;
}

static bool evaluate(ttc_ball_exact *exact, const ttc_ball_symbols *symbols, ttc_id id)
{
    const ttc_graph *graph = symbols->model->graph;
    const ttc_kind kind = ttc_kind_of(graph, id);
    fmpq *out = &exact->fractions[id];
    bool good = true;

    if (exact->state[id] != UNKNOWN) return exact->state[id] == GOOD;
    exact->state[id] = BAD; /* for a symbol that is bound to an expression in itself */
    if (kind == TTC_NUMBER) fmpq_set(out, ttc_coefficient(graph, id));
    else if (kind == TTC_SYMBOL) good = evaluate_symbol(out, exact, symbols, ttc_symbol_of(graph, id));
    else good = evaluate_parts(out, exact, symbols, id);
    exact->state[id] = good ? GOOD : BAD;
    return good;
}

const fmpq *ttc_ball_exact_value(ttc_ball_exact *exact, const ttc_ball_symbols *symbols, ttc_id id)
{
    if (id == TTC_NONE || !room(exact, symbols->model->graph) || !evaluate(exact, symbols, id)) return NULL;
    return &exact->fractions[id];
}
