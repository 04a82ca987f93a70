/* The records `observe`, quantities to show along the motion, and `valid`, conditions under which the model holds. */
#include "read/parser.h"

#include <stdlib.h>
#include <string.h>

/* Returns true for names that output tables give to columns of their own. */
static bool is_column(const char *name)
{
    static const char *const columns[] = { "t", "fate" };
    static const char *const beginnings[] = { "drift_", "difference_" };
    for (size_t i = 0; i < sizeof columns / sizeof *columns; i++)
        if (strcmp(name, columns[i]) == 0) return true;
    for (size_t i = 0; i < sizeof beginnings / sizeof *beginnings; i++)
        if (strncmp(name, beginnings[i], strlen(beginnings[i])) == 0) return true;
    return false;
}

static bool observe(ttc_parser *parser, uint32_t symbol, ttc_place place)
{
    ttc_model *model = parser->model;
    const char *name = model->symbols[symbol].name;
    if (model->symbols[symbol].kind != TTC_LET)
        return ttc_parse_error(parser, place, "'%s' is no let (expected one, or a name of its own: 'observe NAME = %s')", name,
                               name);
    if (is_column(name)) return ttc_parse_error(parser, place, "'%s' is a column of every table (expected another name)", name);
    if (ttc_array_has(model->observed, model->observed_count, symbol))
        return ttc_parse_error(parser, place, "'%s' is observed twice", name);
    parser->used[symbol] = 1;
    return ttc_parse_append(parser, &model->observed, &model->observed_count, symbol);
}

/* NAME [= expression] [unit] "meaning" */
bool ttc_parse_observe(ttc_parser *parser)
{
    uint32_t symbol;
    const ttc_token *name = ttc_parse_name(parser, "the name of what is observed");
    if (name == NULL) return false;
    if (ttc_parse_accept_mark(parser, '=')) {
        parser->may_rate = true;
        ttc_id definition = ttc_parse_expression(parser);
        parser->may_rate = false;
        if (!ttc_parse_define(parser, name, TTC_LET, definition, &symbol) || definition == TTC_NONE) return false;
    } else if (!ttc_parse_known(parser, name, &symbol)) {
        return false;
    }
    ttc_symbol_entry *entry = parser->model->symbols + symbol;
    return observe(parser, symbol, ttc_token_place(name)) && ttc_parse_unit_and_meaning(parser, &entry->unit, &entry->meaning);
}

/* NAME : expression > 0 [unit] "meaning" */
bool ttc_parse_valid(ttc_parser *parser)
{
    ttc_model *model = parser->model;
    const ttc_token *name = ttc_parse_name(parser, "a name for the condition");
    if (name == NULL || !ttc_parse_expect_mark(parser, ':', "the name")) return false;
    for (size_t i = 0; i < model->validity_count; i++)
        if (ttc_token_is(name, model->validities[i].name))
            return ttc_parse_error(parser, ttc_token_place(name), "a second valid record '%s' (first in line %u)",
                                   model->validities[i].name, (unsigned)model->validities[i].place.line);
    if (model->validity_count >= TTC_REGION_LIMIT)
        return ttc_parse_error(parser, ttc_token_place(name), "too many valid records (expected at most %d)", TTC_REGION_LIMIT);
    parser->may_rate = true;
    ttc_id expression = ttc_parse_expression(parser);
    parser->may_rate = false;
    if (expression == TTC_NONE || !ttc_parse_positive(parser, "the model holds where an expression is > 0")) return false;
    if (!TTC_ARRAY_GROW(model->validities, model->validity_count)) return ttc_parse_no_memory(parser);
    ttc_validity *validity = model->validities + model->validity_count;
    *validity = (ttc_validity){ .expression = expression, .place = ttc_token_place(name) };
    if ((validity->name = ttc_parse_copy(parser, name->text, name->length)) == NULL) return false;
    model->validity_count++;
    return ttc_parse_unit_and_meaning(parser, &validity->unit, &validity->meaning);
}
