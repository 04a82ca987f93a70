#include "algebra/derive.h"

#include <stdlib.h>

typedef struct {
    const ttc_model *model;
    ttc_id *slopes; /* by symbol */
    bool *known;
    bool failed;
} direction_slopes;

static ttc_id slope(void *context, uint32_t symbol);

static ttc_id slope_of_definition(direction_slopes *d, uint32_t symbol)
{
    ttc_graph *graph = d->model->graph;
    const ttc_symbol_entry *entry = &d->model->symbols[symbol];
    if (entry->kind == TTC_SINE || entry->kind == TTC_COSINE) {
        ttc_id rate = ttc_derivative(graph, entry->definition, slope, d);
        ttc_id other = d->model->symbols[entry->partner].node;
        ttc_id product = ttc_multiply(graph, rate, other);
        return entry->kind == TTC_SINE ? product : ttc_subtract(graph, ttc_integer(graph, 0), product);
    }
    ttc_id rate = ttc_derivative(graph, entry->definition, slope, d);
    if (entry->kind == TTC_LET) return rate;
    if (entry->kind == TTC_EXP) return ttc_multiply(graph, rate, entry->node);
    if (entry->kind == TTC_LOG) return ttc_divide(graph, rate, entry->definition);
    return ttc_divide(graph, rate, ttc_multiply(graph, ttc_integer(graph, 2), entry->node)); /* r' = (r^2)' / (2 r) */
}

static ttc_id slope(void *context, uint32_t symbol)
{
    direction_slopes *d = context;
    switch (d->model->symbols[symbol].kind) {
    case TTC_STATE:
    case TTC_PARAM:
    case TTC_LEVEL:
    case TTC_LAMBDA:
    case TTC_PI: return d->slopes[symbol];
    case TTC_ROOT:
    case TTC_COSINE:
    case TTC_SINE:
    case TTC_EXP:
    case TTC_LOG:
    case TTC_LET: break;
    }
    if (!d->known[symbol]) {
        d->slopes[symbol] = slope_of_definition(d, symbol);
        d->known[symbol] = true;
        d->failed |= d->slopes[symbol] == TTC_NONE;
    }
    return d->slopes[symbol];
}

/* Derivative of `id` along a direction, shape (state_count,), the rate of each state; TTC_NONE stands for zero. given: NULL, or
 * rates of symbols, shape (symbol_count,), TTC_NONE for those that follow. */
static ttc_id derive_along(const ttc_model *model, ttc_id id, const ttc_id *direction, const ttc_id *given)
{
    direction_slopes d = { .model = model };
    ttc_id result = TTC_NONE;
    d.slopes = calloc(model->symbol_count, sizeof *d.slopes);
    d.known = calloc(model->symbol_count, sizeof *d.known);
    if (d.slopes == NULL || d.known == NULL) goto done;
    for (size_t i = 0; i < model->state_count; i++) d.slopes[model->states[i]] = direction[i];
    for (size_t i = 0; given != NULL && i < model->symbol_count; i++)
        if (given[i] != TTC_NONE) d.slopes[i] = given[i], d.known[i] = true;
    result = ttc_derivative(model->graph, id, slope, &d);
    if (d.failed) result = TTC_NONE;
done:
    free(d.known);
    free(d.slopes);
    return result;
}

ttc_id ttc_derive_field_given(const ttc_model *model, ttc_id id, const ttc_id *rates)
{
    ttc_id *field = calloc(model->state_count + 1, sizeof *field);
    if (field == NULL) return TTC_NONE;
    for (size_t i = 0; i < model->state_count; i++) field[i] = ttc_model_field(model, i);
    ttc_id rate = derive_along(model, id, field, rates);
    free(field);
    return rate;
}

ttc_id ttc_derive_field(const ttc_model *model, ttc_id id) { return ttc_derive_field_given(model, id, NULL); }

ttc_id ttc_derive_state(const ttc_model *model, ttc_id id, size_t state)
{
    ttc_id *axis = calloc(model->state_count + 1, sizeof *axis);
    if (axis == NULL) return TTC_NONE;
    axis[state] = ttc_integer(model->graph, 1);
    ttc_id rate = derive_along(model, id, axis, NULL);
    free(axis);
    return rate;
}
