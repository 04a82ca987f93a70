#include "fields/field.h"

#include "fields/scratch.h"

#include <stdlib.h>
#include <string.h>

static char *copy_name(const char *name)
{
    size_t length = strlen(name) + 1;
    char *copy = malloc(length);
    if (copy != NULL) memcpy(copy, name, length);
    return copy;
}

static const ttc_binding *binding_of(const ttc_variant *variant, uint32_t symbol)
{
    if (variant == NULL) return NULL;
    for (size_t i = 0; i < variant->bindings.count; i++)
        if (variant->bindings.items[i].symbol == symbol) return variant->bindings.items + i;
    return NULL;
}

static ttc_id resolve(ttc_field *field, uint32_t symbol);

static ttc_id resolve_symbol(void *context, uint32_t symbol) { return resolve(context, symbol); }

ttc_id ttc_field_specialise(ttc_field *field, ttc_id expression)
{
    ttc_id id = ttc_substitute(field->graph, expression, resolve_symbol, field);
    field->failed |= id == TTC_NONE;
    return id;
}

/* A named expression: a unit when it is a sum, written out otherwise. */
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

/* What a model's symbol is written as in this field; decided on first use. */
static ttc_id resolve(ttc_field *field, uint32_t symbol)
{
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
        /* Kept as a unit even where it is a product: its denominators stay in one place. */
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
    ttc_field_symbol symbol = { .node = ttc_symbol(field->graph, number), .name = copy_name(name) };
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

static void add_symbols(ttc_field *field)
{
    const ttc_model *model = field->model;
    for (uint32_t i = 0; i < model->symbol_count && !field->failed; i++) {
        ttc_field_symbol *s = field->symbols + i;
        s->name = copy_name(model->symbols[i].name);
        field->symbol_count++;
        field->failed |= s->name == NULL;
    }
    for (size_t i = 0; i < model->param_count; i++) {
        ttc_field_symbol *s = field->symbols + model->params[i];
        s->position = (uint32_t)field->param_count;
        s->role = TTC_ROLE_PARAM;
        s->sign = model->symbols[model->params[i]].sign;
        s->is_constant = true;
        field->params[field->param_count++] = model->params[i];
    }
    if (field->elimination != NULL) {
        ttc_field_symbol *s = field->symbols + field->elimination->level;
        s->position = (uint32_t)field->param_count;
        s->role = TTC_ROLE_PARAM;
        s->is_constant = true;
        field->params[field->param_count++] = field->elimination->level;
    }
    for (size_t i = 0; i < model->state_count + (field->time == NULL ? 0 : field->time->lifted_count); i++) {
        bool is_root = i >= model->state_count;
        uint32_t symbol = is_root ? field->time->lifted[i - model->state_count] : model->states[i];
        if (field->elimination != NULL && symbol == field->elimination->state) continue;
        ttc_field_symbol *s = field->symbols + symbol;
        s->position = (uint32_t)field->state_count;
        s->role = TTC_ROLE_STATE;
        s->node = model->symbols[symbol].node;
        field->states[field->state_count++] = symbol;
    }
}

/* The chain rule for a lifted root r with radicand q: r' = sum_j dq/dx_j f_j / (2 r). */
static ttc_id lifted_rhs(ttc_field *field, uint32_t root, const ttc_id *rhs)
{
    ttc_graph *graph = field->graph;
    ttc_id radicand = ttc_field_specialise(field, field->model->symbols[root].definition);
    ttc_id half = ttc_power(graph, ttc_multiply(graph, ttc_integer(graph, 2), field->symbols[root].node), -1);
    ttc_id result = ttc_integer(graph, 0);
    for (size_t j = 0; j < field->state_count && !field->failed; j++) {
        if (rhs[j] == TTC_NONE) continue;
        ttc_id partial = ttc_field_distribute(field, ttc_field_partial(field, radicand, j), half);
        if (partial == TTC_NONE) return TTC_NONE;
        ttc_id product = ttc_kind_of(graph, partial) == TTC_SUM ? ttc_field_distribute(field, partial, rhs[j])
                                                                : ttc_field_distribute(field, rhs[j], partial);
        result = ttc_add(graph, result, product);
    }
    return result;
}

static void make_rhs(ttc_field *field)
{
    const ttc_model *model = field->model;
    for (size_t i = 0; i < model->equation_count && !field->failed; i++) {
        const ttc_field_symbol *s = field->symbols + model->states[i];
        if (s->role != TTC_ROLE_STATE) continue;
        uint32_t position = s->position;
        ttc_id sum = ttc_integer(field->graph, 0);
        for (size_t k = 0; k < model->equations[i].term_count && !field->failed; k++) {
            ttc_id term = ttc_field_specialise(field, model->equations[i].terms[k].expression);
            sum = ttc_add(field->graph, sum, ttc_field_distribute(field, term, field->factor));
            field->failed |= sum == TTC_NONE;
        }
        field->rhs[position] = sum;
    }
    for (size_t i = 0; field->time != NULL && i < field->time->lifted_count && !field->failed; i++) {
        uint32_t root = field->time->lifted[i];
        ttc_id rhs = lifted_rhs(field, root, field->rhs);
        field->rhs[field->symbols[root].position] = rhs;
        field->failed |= rhs == TTC_NONE;
    }
}

/* A definition that came out as the number zero is written out, and dividing by it fails in the graph. */
static ttc_field_status status_of(ttc_graph *graph)
{
    ttc_graph_status error = ttc_graph_error(graph);
    if (error == TTC_GRAPH_DIVISION_BY_ZERO) {
        ttc_graph_clear_error(graph);
        return TTC_FIELD_DIVIDES_BY_ZERO;
    }
    return error == TTC_GRAPH_OK || error == TTC_GRAPH_NO_MEMORY ? TTC_FIELD_NO_MEMORY : TTC_FIELD_TOO_LARGE;
}

ttc_field_status ttc_field_create(ttc_field **out, const ttc_model *model, const ttc_variant *variant,
                                  const ttc_time *time, const ttc_elimination *elimination)
{
    *out = NULL;
    ttc_field *field = calloc(1, sizeof *field);
    if (field == NULL) return TTC_FIELD_NO_MEMORY;
    size_t states = model->state_count + (time == NULL ? 0 : time->lifted_count);
    *field = (ttc_field){ .model = model, .variant = variant, .time = time, .elimination = elimination, .graph = model->graph };
    field->symbol_capacity = model->symbol_count + 64;
    field->symbols = calloc(field->symbol_capacity, sizeof *field->symbols);
    field->states = calloc(states + 1, sizeof *field->states);
    field->params = calloc(model->param_count + 1, sizeof *field->params);
    field->rhs = calloc(states + 1, sizeof *field->rhs);
    field->failed = field->symbols == NULL || field->states == NULL || field->params == NULL || field->rhs == NULL;
    ttc_graph_clear_error(field->graph);
    if (!field->failed) add_symbols(field);
    if (!field->failed) {
        field->factor = time == NULL ? ttc_integer(field->graph, 1) : ttc_field_specialise(field, time->factor);
        make_rhs(field);
    }
    if (!field->failed) {
        *out = field;
        return TTC_FIELD_OK;
    }
    ttc_field_status status = status_of(field->graph);
    ttc_field_destroy(field);
    return status;
}

bool ttc_field_place_params(ttc_field *field, const uint32_t *places, size_t count)
{
    uint32_t *params = calloc(count + 1, sizeof *params);
    if (params == NULL) return false;
    for (size_t i = 0; i < field->param_count; i++) {
        field->symbols[field->params[i]].position = places[i];
        params[places[i]] = field->params[i];
    }
    free(field->params);
    field->params = params;
    field->param_count = count;
    return true;
}

void ttc_field_destroy(ttc_field *field)
{
    if (field == NULL) return;
    for (size_t i = 0; i < field->symbol_count; i++) {
        free(field->symbols[i].name);
        free(field->symbols[i].partials);
    }
    free(field->symbols);
    free(field->states);
    free(field->params);
    free(field->rhs);
    free(field->extents);
    ttc_scratch_destroy(field->scratch);
    free(field);
}
