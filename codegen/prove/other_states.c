/* A quick test of what is kept, in other states. Where momenta are states, velocities are definitions that divide by the
 * determinant of the inertia, and their rates by its square. With velocities as states, momenta are sums over them, and little
 * divides by it. */
#include "prove/subcase.h"

#include <stdlib.h>

enum { MOST = 6 };

/* Definitions w = A x + c of states x, as many as these, with A and c free of x, and the inverse of A. */
typedef struct {
    size_t count;
    uint32_t definitions[MOST];
    size_t states[MOST]; /* by number */
    ttc_id a[MOST][MOST], inverse[MOST][MOST], c[MOST];
} exchange;

static ttc_id divisor_of(const ttc_model *model, const ttc_symbol_entry *entry)
{
    return entry->kind == TTC_LET ? ttc_model_dividing_sum(model, entry->definition) : TTC_NONE;
}

/* Returns true if all definitions are of first degree in a state, and some depends on it. Fills a column of A. */
static bool is_linear(const ttc_model *model, exchange *e, size_t state, size_t column)
{
    bool depends = false;
    for (size_t i = 0; i < e->count; i++) {
        e->a[i][column] = ttc_derive_state(model, model->symbols[e->definitions[i]].definition, state);
        if (e->a[i][column] == TTC_NONE || ttc_model_depends(model, e->a[i][column], model->states[state])) return false;
        depends |= !ttc_is_number(model->graph, e->a[i][column], 0);
    }
    return depends;
}

static bool find_states(const ttc_task *task, exchange *e)
{
    const ttc_model *model = task->model;
    size_t found = 0;
    for (size_t k = 0; k < model->state_count; k++) {
        if (found == e->count) {
            exchange other = *e;
            if (is_linear(model, &other, k, 0)) return false;
        } else if (!ttc_valuation_is_bound(task->field, model->states[k]) && is_linear(model, e, k, found)) {
            e->states[found++] = k;
        }
    }
    for (size_t i = 0; i < e->count; i++)
        for (size_t j = 0; j < found; j++)
            for (size_t k = 0; k < found; k++)
                if (ttc_model_depends(model, e->a[i][j], model->states[e->states[k]])) return false;
    return found == e->count;
}

typedef struct {
    const ttc_model *model;
    const exchange *e;
} at_states;

static ttc_id let_definition(void *context, uint32_t symbol)
{
    const ttc_symbol_entry *entry = ((const at_states *)context)->model->symbols + symbol;
    return entry->kind == TTC_LET ? entry->definition : TTC_NONE;
}

static ttc_id at_zero(void *context, uint32_t symbol, ttc_id definition_value)
{
    const at_states *at = context;
    for (size_t k = 0; k < at->e->count; k++)
        if (at->model->states[at->e->states[k]] == symbol) return ttc_integer(at->model->graph, 0);
    return definition_value == at->model->symbols[symbol].definition ? TTC_NONE : definition_value;
}

static void find_constants(const ttc_model *model, exchange *e)
{
    at_states at = { model, e };
    for (size_t i = 0; i < e->count; i++)
        e->c[i] = ttc_substitute_through(model->graph, model->symbols[e->definitions[i]].definition, let_definition, at_zero, &at);
}

/* Divide row `pivot` of A and its companion by the pivot, and subtract multiples from all others. */
static void eliminate(ttc_ring *ring, ttc_ratio *a, size_t count, size_t pivot)
{
    const size_t width = 2 * count;
    ttc_ratio factor;
    ttc_ratio_init(ring, &factor);
    ttc_ratio_set(ring, &factor, &a[pivot * width + pivot]);
    for (size_t k = 0; k < width; k++) ttc_ratio_divide(ring, &a[pivot * width + k], &a[pivot * width + k], &factor);
    for (size_t i = 0; i < count; i++) {
        if (i == pivot) continue;
        ttc_ratio_scale(ring, &factor, &a[i * width + pivot], ring->minus_one);
        for (size_t k = 0; k < width; k++)
            ttc_ratio_add_product(ring, &a[i * width + k], &factor, &a[pivot * width + k]);
    }
    ttc_ratio_clear(ring, &factor);
}

/* Fill e->inverse, by the algorithm of Gauss and Jordan. Returns false if a leading minor of A is zero or its inverse grows too
 * large. */
static bool invert(ttc_task *task, exchange *e)
{
    ttc_graph *graph = task->model->graph;
    const size_t count = e->count;
    ttc_ratio *a = ttc_task_ratios(task, 2 * count * count);
    for (size_t i = 0; a != NULL && i < count; i++) {
        for (size_t k = 0; k < count; k++) ttc_evaluate(task->field, &a[2 * count * i + k], e->a[i][k]);
        ttc_ratio_set_integer(task->ring, &a[2 * count * i + count + i], 1);
    }
    for (size_t i = 0; a != NULL && i < count; i++) eliminate(task->ring, a, count, i);
    const bool ok = a != NULL && task->ring->status == TTC_RING_OK && task->ring->choice_count == 0;
    for (size_t i = 0; ok && i < count; i++)
        for (size_t k = 0; k < count; k++) {
            const ttc_ratio *entry = &a[2 * count * i + count + k];
            e->inverse[i][k] = ttc_divide(graph, ttc_task_expression(task, entry->numerator),
                                          ttc_task_expression(task, entry->denominator));
        }
    ttc_task_free(task, a, 2 * count * count);
    return ok;
}

/* sum over k of row[k] * column[k] */
static ttc_id product(ttc_graph *graph, const ttc_id *row, const ttc_id *column, size_t count)
{
    ttc_id sum = ttc_integer(graph, 0);
    for (size_t k = 0; k < count; k++) sum = ttc_add(graph, sum, ttc_multiply(graph, row[k], column[k]));
    return sum;
}

/* The rate of an expression by those of the definitions w: with y = w - c and x = A^-1 y, y' = A (x' - (A^-1)' y). */
static ttc_id rate_of(const ttc_model *model, const exchange *e, const ttc_id *y, ttc_id expression)
{
    ttc_graph *graph = model->graph;
    ttc_id rest[MOST], moving[MOST];
    ttc_id *rates = calloc(model->symbol_count, sizeof *rates), rate = TTC_NONE;
    for (size_t j = 0; j < e->count; j++) {
        for (size_t k = 0; k < e->count; k++) moving[k] = ttc_derive_field(model, e->inverse[j][k]);
        rest[j] = ttc_subtract(graph, ttc_model_field(model, e->states[j]), product(graph, moving, y, e->count));
    }
    for (size_t i = 0; rates != NULL && i < e->count; i++)
        rates[e->definitions[i]] = ttc_add(graph, ttc_derive_field(model, e->c[i]), product(graph, e->a[i], rest, e->count));
    if (rates != NULL) rate = ttc_derive_field_given(model, expression, rates);
    free(rates);
    return rate;
}

/* Returns true if expression' = rate with the definitions w as states in place of x; in_general: and with functions as variables of
 * their own. */
static bool has_rate(ttc_task *task, const exchange *e, ttc_id expression, ttc_id rate, bool in_general)
{
    ttc_graph *graph = task->model->graph;
    ttc_valuation *in_others = ttc_valuation_alike(task->field, 0);
    ttc_id y[MOST];
    ttc_ratio value;
    bool equal = in_others != NULL;
    for (size_t i = 0; i < e->count; i++) y[i] = ttc_subtract(graph, task->model->symbols[e->definitions[i]].node, e->c[i]);
    const ttc_id difference = ttc_subtract(graph, rate_of(task->model, e, y, expression), rate);
    for (size_t i = 0; equal && i < e->count; i++) {
        equal = ttc_valuation_free(in_others, e->definitions[i]);
        ttc_valuation_bind(in_others, task->model->states[e->states[i]], product(graph, e->inverse[i], y, e->count));
    }
    if (equal && in_general) ttc_free_functions(in_others);
    if (equal) {
        ttc_ring *ring = ttc_valuation_ring(in_others);
        ttc_ratio_init(ring, &value);
        ttc_evaluate(in_others, &value, difference);
        equal = ring->status == TTC_RING_OK && ring->choice_count == 0 && fmpz_mpoly_is_zero(value.numerator, ring->context);
        ttc_ratio_clear(ring, &value);
    }
    ttc_valuation_destroy(in_others);
    return equal;
}

static bool uses_definitions(const ttc_model *model, const exchange *e, ttc_id expression)
{
    for (size_t i = 0; i < e->count; i++)
        if (ttc_model_depends(model, expression, e->definitions[i])) return true;
    return false;
}

/* The definitions that divide by the same sum as this one, and the states of which they are of first degree. Returns false as well
 * if the expression uses none of them: its rate then divides once at most, and the inverse of A may be long. */
static bool find_exchange(ttc_task *task, exchange *e, uint32_t first, ttc_id expression)
{
    const ttc_model *model = task->model;
    const ttc_id divisor = divisor_of(model, &model->symbols[first]);
    *e = (exchange){ .count = 0 };
    if (divisor == TTC_NONE) return false;
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        if (divisor_of(model, &model->symbols[i]) != divisor || ttc_valuation_is_bound(task->field, i)) continue;
        if (i < first || e->count == MOST) return false;
        e->definitions[e->count++] = i;
    }
    if (!uses_definitions(model, e, expression) || !find_states(task, e)) return false;
    find_constants(model, e);
    ttc_valuation *own = ttc_valuation_create(model, 0); /* without conditions, as motion may lead away from them */
    ttc_task view = { .model = model, .field = own };
    if (own != NULL) view.ring = ttc_valuation_ring(own);
    if (own != NULL) ttc_free_functions(own);
    const bool ok = own != NULL && invert(&view, e);
    ttc_valuation_destroy(own);
    return ok;
}

bool ttc_task_has_rate_in_other_states(ttc_task *task, ttc_id expression, ttc_id rate)
{
    exchange e;
    for (uint32_t i = 0; i < task->model->symbol_count; i++)
        if (find_exchange(task, &e, i, expression)
            && (has_rate(task, &e, expression, rate, true) || has_rate(task, &e, expression, rate, false)))
            return true;
    return false;
}
