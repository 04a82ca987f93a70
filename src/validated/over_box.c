#include "validated/over_box.h"

#include <stdlib.h>
#include <string.h>

typedef enum { UNKNOWN, GOOD, BAD } knowledge;

struct jlt_over_box {
    const ttc_model *model;
    slong bits;
    jlt_range *values;    /* by symbol, like `given` and `bound` */
    unsigned char *given;
    ttc_id *bound;        /* TTC_NONE: the symbol has its own definition */
    size_t size;
    jlt_range *ranges;    /* by node, like `state` */
    unsigned char *state;
};

static jlt_range *make_ranges(size_t count)
{
    jlt_range *ranges = malloc(count * sizeof *ranges);

    for (size_t i = 0; ranges != NULL && i < count; i++) jlt_range_init(&ranges[i]);
    return ranges;
}

static void clear_ranges(jlt_range *ranges, size_t count)
{
    for (size_t i = 0; ranges != NULL && i < count; i++) jlt_range_clear(&ranges[i]);
    free(ranges);
}

jlt_status jlt_over_box_create(jlt_over_box **over, const ttc_model *model, slong bits)
{
    jlt_over_box *self = calloc(1, sizeof *self);

    *over = NULL;
    if (self == NULL) return JLT_ERR_NOMEM;
    self->model = model;
    self->bits = bits;
    self->size = ttc_graph_size(model->graph) + 1;
    self->values = make_ranges(model->symbol_count + 1);
    self->given = calloc(model->symbol_count + 1, 1);
    self->bound = calloc(model->symbol_count + 1, sizeof *self->bound);
    self->ranges = make_ranges(self->size);
    self->state = calloc(self->size, 1);
    if (self->values == NULL || self->given == NULL || self->bound == NULL || self->ranges == NULL || self->state == NULL) {
        jlt_over_box_destroy(self);
        return JLT_ERR_NOMEM;
    }
    *over = self;
    return JLT_OK;
}

void jlt_over_box_destroy(jlt_over_box *over)
{
    if (over == NULL) return;
    clear_ranges(over->values, over->model->symbol_count + 1);
    clear_ranges(over->ranges, over->size);
    free(over->given);
    free(over->bound);
    free(over->state);
    free(over);
}

void jlt_over_box_bind(jlt_over_box *over, uint32_t symbol, ttc_id id)
{
    over->bound[symbol] = id;
    memset(over->state, UNKNOWN, over->size);
}

void jlt_over_box_set(jlt_over_box *over, uint32_t symbol, const fmpq_t low, const fmpq_t high)
{
    jlt_range_set_fractions(&over->values[symbol], low, high, over->bits);
    over->given[symbol] = 1;
    memset(over->state, UNKNOWN, over->size);
}

static bool evaluate(jlt_over_box *self, ttc_id id);

static bool evaluate_symbol(jlt_range *out, jlt_over_box *self, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &self->model->symbols[symbol];
    const ttc_id meaning = self->bound[symbol] != TTC_NONE ? self->bound[symbol] : entry->definition;

    if (self->bound[symbol] == TTC_NONE && self->given[symbol]) {
        jlt_range_set(out, &self->values[symbol]);
        return true;
    }
    if (entry->kind == TTC_PI) {
        JLT_SCOPED(arb, pi);
        arb_const_pi(pi, self->bits);
        arb_get_interval_arf(out->low, out->high, pi, self->bits);
        return true;
    }
    if (meaning == TTC_NONE || !evaluate(self, meaning)) return false;
    const jlt_range *of = &self->ranges[meaning];
    switch (entry->kind) {
    case TTC_ROOT: return jlt_range_root(out, of, self->bits);
    case TTC_COSINE: return jlt_range_apply(out, of, arb_cos, self->bits);
    case TTC_SINE: return jlt_range_apply(out, of, arb_sin, self->bits);
    case TTC_EXP: return jlt_range_apply(out, of, arb_exp, self->bits);
    case TTC_LOG: return jlt_range_apply(out, of, arb_log, self->bits);
    default: jlt_range_set(out, of); return true;
    }
}

static void set_coefficient(jlt_range *out, const fmpq *value, slong bits)
{
    jlt_range_set_fractions(out, value, value, bits);
}

static bool evaluate_parts(jlt_range *out, jlt_over_box *self, ttc_id id)
{
    const ttc_graph *graph = self->model->graph;
    const bool product = ttc_kind_of(graph, id) == TTC_PRODUCT;
    bool good = true;
    JLT_SCOPED(jlt_range, term);

    set_coefficient(out, ttc_coefficient(graph, id), self->bits);
    for (size_t i = 0; good && i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        good = evaluate(self, part.id);
        if (!good) break;
        if (product) {
            jlt_range_power(term, &self->ranges[part.id], (unsigned)abs(part.exponent), self->bits);
            good = part.exponent >= 0 || jlt_range_invert(term, term, self->bits);
            jlt_range_multiply(out, out, term, self->bits);
        } else {
            set_coefficient(term, part.coefficient, self->bits);
            jlt_range_multiply(term, term, &self->ranges[part.id], self->bits);
            jlt_range_add(out, out, term, self->bits);
        }
    }
    return good;
}

static bool evaluate(jlt_over_box *self, ttc_id id)
{
    const ttc_graph *graph = self->model->graph;
    jlt_range *out = &self->ranges[id];
    bool good = true;

    if (self->state[id] != UNKNOWN) return self->state[id] == GOOD;
    self->state[id] = BAD; /* a definition that contains itself has no value */
    switch (ttc_kind_of(graph, id)) {
    case TTC_NUMBER: set_coefficient(out, ttc_coefficient(graph, id), self->bits); break;
    case TTC_SYMBOL: good = evaluate_symbol(out, self, ttc_symbol_of(graph, id)); break;
    default: good = evaluate_parts(out, self, id);
    }
    self->state[id] = good ? GOOD : BAD;
    return good;
}

const jlt_range *jlt_over_box_enclose(jlt_over_box *over, ttc_id id)
{
    return id != TTC_NONE && evaluate(over, id) ? &over->ranges[id] : NULL;
}
