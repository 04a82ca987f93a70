#include "validated/on_family.h"

typedef struct {
    const ttc_model *model;
    const ttc_bindings *bindings;
} substitution;

static ttc_id definition_of(void *context, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &((const substitution *)context)->model->symbols[symbol];

    return entry->kind == TTC_LET ? entry->definition : TTC_NONE;
}

static ttc_id value_of(void *context, uint32_t symbol, ttc_id definition)
{
    const substitution *s = context;
    const ttc_symbol_entry *entry = &s->model->symbols[symbol];

    for (size_t i = 0; i < s->bindings->count; i++)
        if (s->bindings->items[i].symbol == symbol) return s->bindings->items[i].expression;
    return definition == TTC_NONE || definition == entry->definition ? entry->node : definition;
}

static ttc_id put(const ttc_model *model, const ttc_bindings *bindings, ttc_id id)
{
    substitution s = { model, bindings };
    const ttc_id out = ttc_substitute_through(model->graph, id, definition_of, value_of, &s);

    if (out == TTC_NONE) ttc_graph_clear_error(model->graph);
    return out;
}

/* States are substituted first, so that parameters are then substituted in their expressions too. */
ttc_id jlt_on_family(const ttc_model *model, const ttc_claim *family, ttc_id id)
{
    return put(model, &family->when, put(model, &family->bindings, id));
}
