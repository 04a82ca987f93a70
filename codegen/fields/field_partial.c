/* Partial derivatives of a field's expressions. Derivatives of a unit that are sums are units themselves, made once each. */
#include "fields/field.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Add a unit with the name d(NAME)/d(BY). */
static ttc_id add_derivative(ttc_field *field, const char *name, const char *by, ttc_id expression)
{
    size_t length = strlen(name) + strlen(by) + 8;
    char *label = malloc(length);
    if (label == NULL) return TTC_NONE;
    snprintf(label, length, "d(%s)/d(%s)", name, by);
    ttc_id unit = ttc_field_add_unit(field, label, expression);
    free(label);
    return unit;
}

typedef struct {
    ttc_field *field;
    size_t position;
} direction;

static ttc_id slope(void *context, uint32_t symbol);

/* Derivative of a unit: a new unit if it is a sum; a product is used as it is, so that its factors can be shared. */
static ttc_id unit_slope(direction *d, uint32_t symbol)
{
    ttc_field *field = d->field;
    ttc_field_symbol *s = field->symbols + symbol;
    if (s->partials == NULL) {
        s->partials = calloc(field->state_count, sizeof *s->partials);
        if (s->partials == NULL) return TTC_NONE;
    }
    if (s->partials[d->position] != TTC_NONE) return s->partials[d->position];
    ttc_id partial = ttc_derivative(field->graph, s->definition, slope, d);
    if (partial == TTC_NONE) return TTC_NONE;
    if (ttc_kind_of(field->graph, partial) == TTC_SUM)
        partial = add_derivative(field, field->symbols[symbol].name, field->symbols[field->states[d->position]].name, partial);
    field->symbols[symbol].partials[d->position] = partial;
    return partial;
}

/* The sine for a cosine, the cosine for a sine. It may be used here first, if the equations do not use it. */
static ttc_id partner_of(ttc_field *field, const ttc_field_symbol *s)
{
    return ttc_field_specialise(field, field->model->symbols[s->partner].node);
}

static ttc_id slope(void *context, uint32_t symbol)
{
    direction *d = context;
    ttc_field *field = d->field;
    ttc_graph *graph = field->graph;
    const ttc_field_symbol s = field->symbols[symbol]; /* a copy, because adding units reallocates the array */
    ttc_id inner = TTC_NONE, outer = TTC_NONE;
    if (s.is_constant) return TTC_NONE;
    switch (s.role) {
    case TTC_ROLE_STATE: return ttc_integer(graph, s.position == d->position);
    case TTC_ROLE_UNIT: inner = unit_slope(d, symbol); break;
    case TTC_ROLE_ROOT: /* r' = q'/(2 r) */
        inner = ttc_derivative(graph, s.definition, slope, d);
        outer = ttc_multiply(graph, ttc_integer(graph, 2), s.node);
        if (inner != TTC_NONE) inner = ttc_divide(graph, inner, outer);
        break;
    case TTC_ROLE_COSINE:
    case TTC_ROLE_SINE:
        inner = ttc_derivative(graph, s.definition, slope, d);
        outer = ttc_integer(graph, s.role == TTC_ROLE_COSINE ? -1 : 1);
        outer = ttc_multiply(graph, outer, partner_of(field, &s));
        inner = ttc_field_distribute(field, inner, outer);
        break;
    case TTC_ROLE_EXP:
        inner = ttc_derivative(graph, s.definition, slope, d);
        inner = ttc_field_distribute(field, inner, s.node);
        break;
    case TTC_ROLE_LOG:
        inner = ttc_derivative(graph, s.definition, slope, d);
        if (inner != TTC_NONE) inner = ttc_divide(graph, inner, s.definition);
        break;
    default: return TTC_NONE;
    }
    field->failed |= inner == TTC_NONE;
    return inner;
}

ttc_id ttc_field_partial(ttc_field *field, ttc_id expression, size_t position)
{
    direction d = { field, position };
    ttc_id id = expression == TTC_NONE ? TTC_NONE : ttc_derivative(field->graph, expression, slope, &d);
    field->failed |= id == TTC_NONE;
    return id;
}
