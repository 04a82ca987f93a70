#include "fields/field.h"

#include <stdlib.h>
#include <string.h>

static const ttc_binding *binding_of(const ttc_variant *variant, uint32_t symbol)
{
    if (variant == NULL) return NULL;
    for (size_t i = 0; i < variant->bindings.count; i++)
        if (variant->bindings.items[i].symbol == symbol) return variant->bindings.items + i;
    return NULL;
}

static ttc_id resolve(void *context, uint32_t symbol);

ttc_id ttc_field_specialise(ttc_field *field, ttc_id expression)
{
    ttc_id id = ttc_substitute(field->graph, expression, resolve, field);
    field->failed |= id == TTC_NONE;
    return id;
}

/* Let a symbol stand for an expression: it is a unit if this is a sum, otherwise it is replaced by the expression. */
static void name_expression(ttc_field *field, ttc_field_symbol *symbol, ttc_id expression)
{
    symbol->definition = expression;
    if (expression == TTC_NONE) return;
    symbol->is_constant = ttc_field_is_constant(field, expression);
    if (ttc_kind_of(field->graph, expression) == TTC_SUM) {
        symbol->role = TTC_ROLE_UNIT;
    } else {
        symbol->role = TTC_ROLE_ABSENT;
        symbol->node = expression;
    }
}

static ttc_role role_of(ttc_symbol_kind function)
{
    switch (function) {
    case TTC_ROOT: return TTC_ROLE_ROOT;
    case TTC_COSINE: return TTC_ROLE_COSINE;
    case TTC_SINE: return TTC_ROLE_SINE;
    case TTC_EXP: return TTC_ROLE_EXP;
    case TTC_LOG: return TTC_ROLE_LOG;
    default: return TTC_ROLE_ABSENT;
    }
}

/* A function of a number whose value is a number, as sqrt(1 + a^2) for a = 0; TTC_NONE: it is none. */
static ttc_id rational_value(ttc_graph *graph, ttc_symbol_kind function, ttc_id argument)
{
    ttc_id value = TTC_NONE;
    fmpq_t number;
    fmpq_init(number);
    if (ttc_kind_of(graph, argument) == TTC_NUMBER && ttc_symbol_rational(number, function, ttc_coefficient(graph, argument)))
        value = ttc_number(graph, number);
    fmpq_clear(number);
    return value;
}

/* The node that represents a symbol of the model in this field. Role and definition of the symbol are set at the first call. */
static ttc_id resolve(void *context, uint32_t symbol)
{
    ttc_field *field = context;
    ttc_field_symbol *s = field->symbols + symbol;
    const ttc_symbol_entry *entry = field->model->symbols + symbol;
    if (s->node != TTC_NONE) return s->node;
    const ttc_binding *bound = binding_of(field->variant, symbol);
    ttc_id definition = TTC_NONE;

    if (bound != NULL) {
        definition = ttc_field_specialise(field, bound->expression);
        field->symbols[symbol].node = definition;
        field->symbols[symbol].is_constant = true;
        return definition;
    }
    if (field->elimination != NULL && field->elimination->state == symbol) {
        /* The eliminated state is a unit even if it is a product, so that what it divides by occurs only once. */
        definition = ttc_field_specialise(field, field->elimination->solution);
        s->role = TTC_ROLE_UNIT;
        s->definition = definition;
        s->node = entry->node;
        return definition == TTC_NONE ? TTC_NONE : s->node;
    }
    switch (entry->kind) {
    case TTC_LET:
        definition = ttc_field_specialise(field, entry->definition);
        s->node = entry->node;
        name_expression(field, s, definition);
        return definition == TTC_NONE ? TTC_NONE : s->node;
    case TTC_ROOT:
    case TTC_COSINE:
    case TTC_SINE:
    case TTC_EXP:
    case TTC_LOG:
        definition = ttc_field_specialise(field, entry->definition);
        if (definition == TTC_NONE) return TTC_NONE;
        s->node = rational_value(field->graph, entry->kind, definition);
        if (s->node != TTC_NONE) {
            s->is_constant = true;
            return s->node;
        }
        s->definition = definition;
        s->partner = entry->partner;
        s->node = entry->node;
        s->role = role_of(entry->kind);
        s->is_constant = ttc_field_is_constant(field, definition);
        return s->node;
    case TTC_PI:
        s->role = TTC_ROLE_PI;
        s->is_constant = true;
        s->node = entry->node;
        return s->node;
    default:
        s->node = entry->node;
        return s->node;
    }
}

typedef struct {
    const ttc_field *field;
    unsigned char *seen;
} constancy;

static bool holds_only_parameters(constancy *c, ttc_id id)
{
    const ttc_graph *graph = c->field->graph;
    if (c->seen[id]) return true;
    c->seen[id] = 1;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) return c->field->symbols[ttc_symbol_of(graph, id)].is_constant;
    for (size_t i = 0; i < ttc_part_count(graph, id); i++)
        if (!holds_only_parameters(c, ttc_part_at(graph, id, i).id)) return false;
    return true;
}

bool ttc_field_is_general(const ttc_field *field) { return field->variant == NULL && field->elimination == NULL; }

size_t ttc_field_lifted_count(const ttc_field *field) { return field->time == NULL ? 0 : field->time->lifted_count; }

bool ttc_field_is_constant(const ttc_field *field, ttc_id expression)
{
    constancy c = { field, calloc(ttc_graph_size(field->graph) + 1, 1) };
    bool result = c.seen != NULL && holds_only_parameters(&c, expression);
    free(c.seen);
    return result;
}

ttc_id ttc_field_distribute(ttc_field *field, ttc_id sum, ttc_id factor)
{
    if (sum == TTC_NONE || factor == TTC_NONE) return TTC_NONE;
    ttc_graph *graph = field->graph;
    if (ttc_is_number(graph, factor, 1)) return sum;
    if (ttc_kind_of(graph, sum) != TTC_SUM) return ttc_multiply(graph, sum, factor);
    ttc_id result = ttc_scale(graph, factor, ttc_coefficient(graph, sum));
    for (size_t i = 0; i < ttc_part_count(graph, sum); i++) {
        ttc_part part = ttc_part_at(graph, sum, i);
        result = ttc_add(graph, result, ttc_scale(graph, ttc_multiply(graph, part.id, factor), part.coefficient));
    }
    return result;
}

ttc_id ttc_field_add_unit(ttc_field *field, const char *name, ttc_id expression)
{
    if (field->symbol_count == field->symbol_capacity) {
        size_t capacity = 2 * field->symbol_capacity + 16;
        ttc_field_symbol *symbols = realloc(field->symbols, capacity * sizeof *symbols);
        if (symbols == NULL) return TTC_NONE;
        field->symbols = symbols;
        field->symbol_capacity = capacity;
    }
    uint32_t number = (uint32_t)field->symbol_count;
    ttc_field_symbol symbol = { .node = ttc_symbol(field->graph, number), .name = strdup(name) };
    if (symbol.name == NULL || symbol.node == TTC_NONE) {
        free(symbol.name);
        return TTC_NONE;
    }
    name_expression(field, &symbol, expression);
    field->symbols[number] = symbol;
    field->symbol_count++;
    return symbol.node;
}

bool ttc_field_implies(ttc_field *field, const ttc_claim *claim)
{
    if (claim->modulo_count > 0) return false;
    for (size_t i = 0; i < claim->when.count; i++) {
        const ttc_binding *b = claim->when.items + i;
        if (field->model->symbols[b->symbol].kind != TTC_PARAM) return false;
        ttc_id value = ttc_field_specialise(field, b->expression);
        ttc_id here = ttc_field_specialise(field, field->model->symbols[b->symbol].node);
        ttc_id difference = ttc_subtract(field->graph, here, value);
        if (difference == TTC_NONE || !ttc_is_number(field->graph, difference, 0)) return false;
    }
    return true;
}
