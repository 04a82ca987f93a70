/* Lists of substitutions: NAME = expr, ... */
#include "read/parser.h"

#include <stdlib.h>

/* NAME = expr, ... with names of the given kinds (a mask of 1 << kind), each bound once. */
bool ttc_parse_bindings(ttc_parser *parser, ttc_bindings *bindings, unsigned kinds, const char *expected)
{
    do {
        uint32_t symbol;
        const ttc_token *name = ttc_parse_name(parser, expected);
        if (name == NULL || !ttc_parse_known(parser, name, &symbol)) return false;
        const ttc_symbol_entry *entry = parser->model->symbols + symbol;
        if ((kinds & 1u << entry->kind) == 0)
            return ttc_parse_error(parser, ttc_token_place(name), "'%s' cannot be set here (expected %s)", entry->name, expected);
        for (size_t i = 0; i < bindings->count; i++)
            if (bindings->items[i].symbol == symbol)
                return ttc_parse_error(parser, ttc_token_place(name), "'%s' is set twice", entry->name);
        if (!ttc_parse_expect_mark(parser, '=', "the name")) return false;
        ttc_id expression = ttc_parse_expression(parser);
        if (expression == TTC_NONE) return false;
        if (!TTC_ARRAY_GROW(bindings->items, bindings->count)) return ttc_parse_no_memory(parser);
        bindings->items[bindings->count++] = (ttc_binding){ symbol, expression, ttc_token_place(name) };
    } while (ttc_parse_accept_mark(parser, ','));
    return true;
}

void ttc_parse_check_constants(ttc_parser *parser, const ttc_bindings *bindings)
{
    for (size_t i = 0; i < bindings->count; i++) {
        const ttc_binding *b = bindings->items + i;
        const ttc_symbol_entry *entry = parser->model->symbols + b->symbol;
        if (ttc_kind_of(parser->model->graph, b->expression) != TTC_NUMBER) continue;
        int sign = fmpq_sgn(ttc_coefficient(parser->model->graph, b->expression));
        bool excluded = (entry->sign == TTC_POSITIVE && sign <= 0) || (entry->sign == TTC_NONNEGATIVE && sign < 0) ||
                        (entry->sign == TTC_NONZERO && sign == 0);
        if (excluded)
            ttc_report(parser->diagnostics, TTC_WARNING, b->place.line, b->place.column,
                       "this value of '%s' lies outside the condition that its record states", entry->name);
    }
}

bool ttc_parse_check_circle(ttc_parser *parser, const ttc_bindings *bound, const ttc_bindings *in, const ttc_bindings *first)
{
    const ttc_model *model = parser->model;
    size_t count = 0, most = in->count + (first == NULL ? 0 : first->count);
    if (bound->count == 0 || most == 0) return true;
    ttc_id *ids = malloc(most * sizeof *ids);
    if (ids == NULL) return ttc_parse_no_memory(parser);
    for (size_t i = 0; i < in->count; i++) ids[count++] = in->items[i].expression;
    unsigned char *support = ttc_model_support(model, ids, count);
    if (support != NULL && first != NULL) {
        for (size_t i = 0; i < first->count; i++)
            if (support[first->items[i].symbol]) ids[count++] = first->items[i].expression;
        unsigned char *after = ttc_model_support(model, ids, count);
        for (size_t i = 0; after != NULL && i < first->count; i++) after[first->items[i].symbol] = 0;
        free(support);
        support = after;
    }
    free(ids);
    if (support == NULL) return ttc_parse_no_memory(parser);
    bool ok = true;
    for (size_t i = 0; ok && i < bound->count; i++)
        if (support[bound->items[i].symbol])
            ok = ttc_parse_error(parser, bound->items[i].place, "'%s' is set here and stands in a right-hand side, directly or "
                                 "through definitions: a circle", model->symbols[bound->items[i].symbol].name);
    free(support);
    return ok;
}
