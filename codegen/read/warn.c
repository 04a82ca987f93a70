/* Warnings that need the whole table. */
#include "read/parser.h"

#include <string.h>

static void warn_unused(ttc_parser *parser)
{
    const ttc_model *model = parser->model;
    for (size_t i = 1; i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = model->symbols + i;
        const char *kind = entry->kind == TTC_PARAM && model->lift.file == NULL ? "parameter"
                           : entry->kind == TTC_LET  ? "let"
                           : entry->kind == TTC_ROOT ? "root"
                           : entry->kind == TTC_EXP  ? "exponential"
                           : entry->kind == TTC_LOG  ? "logarithm"
                           : entry->kind == TTC_COSINE && !parser->used[entry->partner] ? "angle"
                                                                                        : NULL;
        if (kind != NULL && !parser->used[i])
            ttc_report(parser->diagnostics, TTC_WARNING, entry->place.line, entry->place.column, "the %s '%s' is never used", kind,
                       entry->name);
    }
}

/* The definition of a let, and the default of a parameter; other symbols stay. */
static ttc_id let_definition(void *context, uint32_t symbol)
{
    const ttc_symbol_entry *entry = ((const ttc_model *)context)->symbols + symbol;
    return entry->kind == TTC_LET ? entry->definition : TTC_NONE;
}

static ttc_id by_default(void *context, uint32_t symbol, ttc_id definition_value)
{
    const ttc_symbol_entry *entry = ((const ttc_model *)context)->symbols + symbol;
    return entry->kind == TTC_PARAM ? entry->value : definition_value;
}

static bool is_of_params(const ttc_model *model, ttc_id expression)
{
    for (size_t i = 0; i < model->state_count; i++)
        if (ttc_model_depends(model, expression, model->states[i])) return false;
    return true;
}

/* Warn of conditions on parameters alone that the defaults break, or at which they divide by zero. */
static void warn_of_defaults(ttc_parser *parser)
{
    ttc_model *model = parser->model;
    ttc_graph *graph = model->graph;
    for (size_t i = 0; i < model->region_count; i++) {
        const ttc_region *region = model->regions + i;
        if (!is_of_params(model, region->expression)) continue;
        const ttc_id value = ttc_substitute_through(graph, region->expression, let_definition, by_default, model);
        const ttc_graph_status status = value == TTC_NONE ? ttc_graph_error(graph) : TTC_GRAPH_OK;
        ttc_graph_clear_error(graph);
        if (status == TTC_GRAPH_NO_MEMORY) ttc_parse_no_memory(parser);
        if (status == TTC_GRAPH_DIVISION_BY_ZERO || (value != TTC_NONE && ttc_kind_of(graph, value) == TTC_NUMBER &&
                                                     fmpq_sgn(ttc_coefficient(graph, value)) <= 0))
            ttc_report(parser->diagnostics, TTC_WARNING, region->place.line, region->place.column,
                       "the defaults lie outside the domain: %s does not hold", region->text);
    }
}

static bool has_dimension(const char *name, size_t length)
{
    static const char *const names[] = { "kg", "m", "s" };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strlen(names[i]) == length && memcmp(names[i], name, length) == 0) return true;
    return false;
}

/* Warn of names in units of parameters and states that count as numbers; rad is one by right. */
static void warn_of_units(ttc_parser *parser)
{
    for (size_t i = 1; i < parser->model->symbol_count; i++) {
        const ttc_symbol_entry *entry = parser->model->symbols + i;
        const bool counts = entry->unit != NULL && (entry->kind == TTC_PARAM || entry->kind == TTC_STATE);
        for (const char *at = counts ? entry->unit : ""; *at != '\0';) {
            const size_t length = strcspn(at, "*/ ^()");
            const bool is_name = *at >= 'A' && !(length == 3 && memcmp(at, "rad", length) == 0);
            if (is_name && !has_dimension(at, length))
                ttc_report(parser->diagnostics, TTC_WARNING, entry->place.line, entry->place.column,
                           "'%.*s' in the unit of %s counts as a number (only kg, m and s have dimensions)", (int)length, at,
                           entry->name);
            at += length + (at[length] != '\0');
        }
    }
}

void ttc_parse_warn(ttc_parser *parser)
{
    warn_unused(parser);
    warn_of_defaults(parser);
    warn_of_units(parser);
}
