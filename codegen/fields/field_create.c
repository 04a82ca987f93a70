/* Creation of a field: its states and parameters, and its right-hand sides. */
#include "fields/field.h"

#include "fields/scratch.h"

#include <stdlib.h>
#include <string.h>

static void add_symbols(ttc_field *field)
{
    const ttc_model *model = field->model;
    for (uint32_t i = 0; i < model->symbol_count && !field->failed; i++) {
        ttc_field_symbol *s = field->symbols + i;
        s->name = strdup(model->symbols[i].name);
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

/* The status after a failure. A definition that becomes zero is replaced by 0, so that the graph reports division by it. */
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
        if (elimination != NULL) ttc_field_specialise(field, model->symbols[elimination->state].node); /* it may divide by zero */
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
