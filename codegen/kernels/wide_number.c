#include "kernels/wide_number.h"

#include "fields/formula.h"

#include <stdlib.h>

typedef struct {
    const ttc_model *model;
    unsigned char *seen; /* by node: visited */
    ttc_place *place;
} finder;

static bool is_wide(finder *f, ttc_id id)
{
    const ttc_graph *graph = f->model->graph;
    if (id == TTC_NONE || f->seen[id] || ttc_kind_of(graph, id) == TTC_SYMBOL) return false;
    f->seen[id] = 1;
    bool wide = !ttc_constant_fits(ttc_coefficient(graph, id));
    for (size_t i = 0; i < ttc_part_count(graph, id) && !wide; i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        wide = (ttc_kind_of(graph, id) == TTC_SUM && !ttc_constant_fits(part.coefficient)) || is_wide(f, part.id);
    }
    return wide;
}

static bool found(finder *f, ttc_id id, ttc_place place)
{
    if (!is_wide(f, id)) return false;
    *f->place = place;
    return true;
}

static bool in_bindings(finder *f, const ttc_bindings *bindings)
{
    for (size_t i = 0; i < bindings->count; i++)
        if (found(f, bindings->items[i].expression, bindings->items[i].place)) return true;
    return false;
}

static bool in_symbols(finder *f)
{
    for (size_t i = 0; i < f->model->symbol_count; i++) {
        const ttc_symbol_entry *s = f->model->symbols + i;
        if (found(f, s->definition, s->place) || found(f, s->value, s->place) || found(f, s->low, s->place)
            || found(f, s->high, s->place))
            return true;
    }
    return false;
}

static bool in_claims(finder *f)
{
    for (size_t i = 0; i < f->model->claim_count; i++) {
        const ttc_claim *claim = f->model->claims + i;
        if (found(f, claim->expression, claim->place) || in_bindings(f, &claim->bindings) || in_bindings(f, &claim->when))
            return true;
        for (size_t k = 0; k < claim->entry_count; k++)
            if (found(f, claim->entries[k], claim->place)) return true;
    }
    return false;
}

static bool in_table(finder *f)
{
    const ttc_model *model = f->model;
    for (size_t i = 0; i < model->equation_count; i++)
        for (size_t k = 0; k < model->equations[i].term_count; k++)
            if (found(f, model->equations[i].terms[k].expression, model->equations[i].terms[k].place)) return true;
    for (size_t i = 0; i < model->variant_count; i++)
        if (in_bindings(f, &model->variants[i].bindings)) return true;
    for (size_t i = 0; i < model->time_count; i++)
        if (found(f, model->times[i].factor, model->times[i].place)) return true;
    return in_symbols(f) || in_claims(f);
}

static bool in_program(const ttc_program *program)
{
    for (size_t k = 0; program != NULL && k < ttc_program_size(program); k++) {
        const ttc_instruction *i = ttc_program_at(program, (ttc_value)k);
        if (i->op == TTC_OP_CONSTANT && !ttc_constant_fits(i->constant)) return true;
    }
    return false;
}

static bool in_kernels(const ttc_kernels *k)
{
    bool wide = in_program(k->jet) || in_program(k->prepare);
    for (int kind = 0; kind < TTC_KERNEL_KINDS && !wide; kind++)
        wide = in_program(k->kernels[kind].optimized) || in_program(k->kernels[kind].reference);
    return wide;
}

bool ttc_find_wide_number(const ttc_catalogue *catalogue, ttc_place *place)
{
    finder f = { catalogue->model, calloc(ttc_graph_size(catalogue->model->graph) + 1, 1), place };
    if (f.seen == NULL) return false;
    bool is_found = in_table(&f);
    free(f.seen);
    for (size_t i = 0; i < catalogue->count && !is_found; i++) {
        if (catalogue->fields[i].kernels == NULL || !in_kernels(catalogue->fields[i].kernels)) continue;
        *place = ttc_catalogue_place(catalogue->fields + i, catalogue->model);
        is_found = true;
    }
    return is_found;
}
