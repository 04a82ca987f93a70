/* The expression graph of the equations, or of a lift, for Graphviz: an edge leads from a whole to its part. */
#include "show/show.h"

#include <stdlib.h>

static void show_rational(FILE *stream, const fmpq *q)
{
    fmpz_fprint(stream, fmpq_numref(q));
    if (fmpz_is_one(fmpq_denref(q))) return;
    fputc('/', stream);
    fmpz_fprint(stream, fmpq_denref(q));
}

static void show_node(FILE *stream, const ttc_model *model, ttc_id id)
{
    const ttc_graph *graph = model->graph;
    ttc_kind kind = ttc_kind_of(graph, id);
    fprintf(stream, "  n%u [", (unsigned)id);
    if (kind == TTC_SYMBOL) {
        const ttc_symbol_entry *entry = model->symbols + ttc_symbol_of(graph, id);
        fprintf(stream, "label=\"%s\", shape=%s", entry->name, entry->definition == TTC_NONE ? "box" : "oval");
    } else {
        const fmpq *c = ttc_coefficient(graph, id);
        fputs(kind == TTC_NUMBER ? "shape=plain, label=\"" : kind == TTC_SUM ? "label=\"+" : "label=\"*", stream);
        if (kind == TTC_NUMBER || (kind == TTC_SUM && !fmpq_is_zero(c)) || (kind == TTC_PRODUCT && !fmpq_is_one(c))) {
            if (kind != TTC_NUMBER) fputc(' ', stream);
            show_rational(stream, c);
        }
        fputc('"', stream);
    }
    fputs("];\n", stream);
}

static void show_edges(FILE *stream, const ttc_model *model, ttc_id id)
{
    const ttc_graph *graph = model->graph;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) {
        const ttc_symbol_entry *entry = model->symbols + ttc_symbol_of(graph, id);
        const char *label = ttc_symbol_is_function(entry->kind) ? ttc_symbol_function(entry->kind) : "let";
        if (entry->definition != TTC_NONE)
            fprintf(stream, "  n%u -> n%u [label=\"%s\", style=dashed];\n", (unsigned)id, (unsigned)entry->definition, label);
        return;
    }
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        fprintf(stream, "  n%u -> n%u", (unsigned)id, (unsigned)part.id);
        if (part.exponent != 1) fprintf(stream, " [label=\"^%d\"]", (int)part.exponent);
        if (!fmpq_is_one(part.coefficient)) {
            fputs(" [label=\"", stream);
            show_rational(stream, part.coefficient);
            fputs("\"]", stream);
        }
        fputs(";\n", stream);
    }
}

bool ttc_show_dot(FILE *stream, const ttc_model *model)
{
    const ttc_graph *graph = model->graph;
    size_t size = ttc_graph_size(graph);
    unsigned char *seen = calloc(size + 1, 1);
    if (seen == NULL) return false;
    fprintf(stream, "digraph \"%s\" {\n  rankdir=LR;\n", model->name);
    for (size_t i = 0; i < model->lift.bindings.count; i++) {
        const ttc_id id = model->lift.bindings.items[i].expression;
        seen[id] = 1;
        fprintf(stream, "  f%zu [label=\"%s\", shape=box, style=bold];\n  f%zu -> n%u;\n", i, model->lift.names[i], i,
                (unsigned)id);
    }
    for (size_t i = 0; i < model->equation_count; i++) {
        seen[ttc_model_field(model, i)] = 1;
        fprintf(stream, "  f%zu [label=\"d %s/dt\", shape=box, style=bold];\n  f%zu -> n%u;\n", i,
                model->symbols[model->states[i]].name, i, (unsigned)ttc_model_field(model, i));
    }
    for (ttc_id id = (ttc_id)size; id > 0; id--) {
        if (!seen[id]) continue;
        for (size_t i = 0; i < ttc_part_count(graph, id); i++) seen[ttc_part_at(graph, id, i).id] = 1;
        if (ttc_kind_of(graph, id) == TTC_SYMBOL) seen[model->symbols[ttc_symbol_of(graph, id)].definition] = 1;
        show_node(stream, model, id);
        show_edges(stream, model, id);
    }
    fputs("}\n", stream);
    free(seen);
    return true;
}
