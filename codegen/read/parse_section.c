/* Records about sections: `pole` and `section` in a model's table; `lift`, `start` and `turns` in that of coordinates. */
#include "read/parser.h"

#include <stdlib.h>

/* Read the name of a symbol, and mark the symbol as used. */
static bool parse_symbol(ttc_parser *parser, const char *expected, const ttc_token **name, uint32_t *symbol)
{
    *name = ttc_parse_name(parser, expected);
    if (*name == NULL || !ttc_parse_known(parser, *name, symbol)) return false;
    parser->used[*symbol] = 1;
    return true;
}

static bool is_number(const ttc_model *model, ttc_id id)
{
    return id != TTC_NONE && ttc_kind_of(model->graph, id) == TTC_NUMBER;
}

bool ttc_parse_meaning(ttc_parser *parser, char **meaning)
{
    const ttc_token *token = ttc_parse_peek(parser);
    if (token->kind != TTC_TOKEN_STRING) return true;
    parser->at++;
    return (*meaning = ttc_parse_copy(parser, token->text, token->length)) != NULL;
}

/* STATE "meaning" */
bool ttc_parse_pole(ttc_parser *parser)
{
    ttc_model *model = parser->model;
    const ttc_token *name;
    ttc_pole pole = { .meaning = NULL };
    if (!parse_symbol(parser, "a state", &name, &pole.state)) return false;
    const ttc_symbol_entry *entry = model->symbols + pole.state;
    pole.place = ttc_token_place(name);
    if (entry->kind != TTC_STATE) return ttc_parse_error(parser, pole.place, "'%s' is not a state (expected one)", entry->name);
    for (size_t i = 0; i < model->pole_count; i++)
        if (model->poles[i].state == pole.state)
            return ttc_parse_error(parser, pole.place, "'%s' has its poles twice (first in line %u)", entry->name,
                                   (unsigned)model->poles[i].place.line);
    if (!is_number(model, entry->low) || !is_number(model, entry->high))
        return ttc_parse_error(parser, pole.place, "'%s' has no interval with rational ends, and no poles (expected 'state %s in "
                               "(LO, HI)')", entry->name, entry->name);
    if (!TTC_ARRAY_GROW(model->poles, model->pole_count)) return ttc_parse_no_memory(parser);
    model->poles[model->pole_count] = pole;
    return ttc_parse_meaning(parser, &model->poles[model->pole_count++].meaning);
}

/* QUANTITY, ... */
static bool parse_shown(ttc_parser *parser, uint32_t **list, size_t *count)
{
    do {
        uint32_t symbol;
        const ttc_token *name;
        if (!parse_symbol(parser, "a let, a root or a state", &name, &symbol)) return false;
        const ttc_symbol_entry *entry = parser->model->symbols + symbol;
        if (entry->kind != TTC_LET && entry->kind != TTC_ROOT && entry->kind != TTC_STATE)
            return ttc_parse_error(parser, ttc_token_place(name), "'%s' cannot be shown (expected a let, a root or a state)",
                                   entry->name);
        for (size_t i = 0; i < *count; i++)
            if ((*list)[i] == symbol) return ttc_parse_error(parser, ttc_token_place(name), "'%s' is shown twice", entry->name);
        if (!ttc_parse_uses(parser, symbol) || !ttc_parse_append(parser, list, count, symbol)) return false;
    } while (ttc_parse_accept_mark(parser, ','));
    return true;
}

/* by FILE.tt at STATE = number with ... [beside ...] [ending ...] */
bool ttc_parse_section(ttc_parser *parser, ttc_claim *claim)
{
    ttc_model *model = parser->model;
    if (!TTC_ARRAY_GROW(model->sections, model->section_count)) return ttc_parse_no_memory(parser);
    ttc_section *section = model->sections + model->section_count++;
    *section = (ttc_section){ .claim = (uint32_t)model->claim_count };
    if (!ttc_parse_expect_keyword(parser, TTC_KEYWORD_BY, "':'") ||
        !ttc_parse_target_file(parser, &claim->target) || !ttc_parse_expect_keyword(parser, TTC_KEYWORD_AT, "the table"))
        return false;
    const ttc_place place = ttc_token_place(ttc_parse_peek(parser));
    if (!ttc_parse_bindings(parser, &claim->when, 1u << TTC_STATE, "a state")) return false;
    if (claim->when.count > 1 || !is_number(model, claim->when.items[0].expression))
        return ttc_parse_error(parser, place, "not a section (expected one state, which is a number there)");
    if (!ttc_parse_expect_keyword(parser, TTC_KEYWORD_WITH, "the number") ||
        !ttc_parse_image(parser, &section->image, claim, 1u << TTC_GIVEN_PLAIN | 1u << TTC_GIVEN_ANGLE,
                         "a coordinate, or a parameter of the table of coordinates"))
        return false;
    section->shown_uses = parser->use_count;
    if (ttc_parse_accept_keyword(parser, TTC_KEYWORD_BESIDE) && !parse_shown(parser, &section->beside, &section->beside_count))
        return false;
    return !ttc_parse_accept_keyword(parser, TTC_KEYWORD_ENDING) || parse_shown(parser, &section->ending, &section->ending_count);
}

/* into FILE.tt with STATE = expr, ..., ROOT = expr, ... */
bool ttc_parse_lift(ttc_parser *parser, const ttc_token *keyword)
{
    ttc_lift *lift = &parser->model->lift;
    if (lift->file != NULL)
        return ttc_parse_error(parser, ttc_token_place(keyword), "a second lift (first in line %u)", (unsigned)lift->place.line);
    lift->place = ttc_token_place(keyword);
    return ttc_parse_expect_keyword(parser, TTC_KEYWORD_INTO, "'lift'") && ttc_parse_target_file(parser, &lift->file) &&
           ttc_parse_expect_keyword(parser, TTC_KEYWORD_WITH, "the table") &&
           ttc_parse_target_bindings(parser, &lift->bindings, &lift->names, "a state or root of the model");
}

/* COORDINATE = number, ... */
static bool parse_point(ttc_parser *parser, ttc_start *start)
{
    const ttc_model *model = parser->model;
    size_t given = 0;
    do {
        const ttc_token *name;
        uint32_t symbol;
        size_t i = 0;
        if (!parse_symbol(parser, "a coordinate", &name, &symbol)) return false;
        while (i < model->state_count && model->states[i] != symbol) i++;
        if (i == model->state_count)
            return ttc_parse_error(parser, ttc_token_place(name), "'%s' is not a state (expected one)",
                                   model->symbols[symbol].name);
        if (start->point[i] != TTC_NONE)
            return ttc_parse_error(parser, ttc_token_place(name), "'%s' is set twice", model->symbols[symbol].name);
        if (!ttc_parse_expect_mark(parser, '=', "the coordinate")) return false;
        const ttc_place place = ttc_token_place(ttc_parse_peek(parser));
        start->point[i] = ttc_parse_expression(parser);
        if (start->point[i] == TTC_NONE) return false;
        if (!is_number(model, start->point[i]))
            return ttc_parse_error(parser, place, "a start that is not a number (expected one, such as 2/5)");
        given++;
    } while (ttc_parse_accept_mark(parser, ','));
    for (size_t i = 0; given < model->state_count && i < model->state_count; i++)
        if (start->point[i] == TTC_NONE)
            return ttc_parse_error(parser, start->place, "'%s' has no '%s' (expected every state)", start->name,
                                   model->symbols[model->states[i]].name);
    return true;
}

/* NAME : COORDINATE = number, ... */
bool ttc_parse_start(ttc_parser *parser)
{
    ttc_model *model = parser->model;
    const ttc_token *name = ttc_parse_name(parser, "a name for the start");
    if (name == NULL || !ttc_parse_expect_mark(parser, ':', "the name")) return false;
    for (size_t i = 0; i < model->start_count; i++)
        if (ttc_token_is(name, model->starts[i].name))
            return ttc_parse_error(parser, ttc_token_place(name), "a second start '%s' (first in line %u)", model->starts[i].name,
                                   (unsigned)model->starts[i].place.line);
    if (model->start_count >= TTC_REGION_LIMIT)
        return ttc_parse_error(parser, ttc_token_place(name), "too many starts (expected at most %d)", TTC_REGION_LIMIT);
    if (!TTC_ARRAY_GROW(model->starts, model->start_count)) return ttc_parse_no_memory(parser);
    ttc_start *start = model->starts + model->start_count;
    *start = (ttc_start){ .place = ttc_token_place(name), .point = malloc((model->state_count + 1) * sizeof *start->point) };
    if (start->point == NULL) return ttc_parse_no_memory(parser);
    for (size_t i = 0; i < model->state_count; i++) start->point[i] = TTC_NONE;
    model->start_count++;
    start->name = ttc_parse_copy(parser, name->text, name->length);
    return start->name != NULL && parse_point(parser, start);
}

/* expr "what starts are called where it is negative" */
bool ttc_parse_turns(ttc_parser *parser, const ttc_token *keyword)
{
    ttc_model *model = parser->model;
    if (model->turn != TTC_NONE) return ttc_parse_error(parser, ttc_token_place(keyword), "a second 'turns' (expected one)");
    model->turn = ttc_parse_expression(parser);
    if (model->turn == TTC_NONE) return false;
    if (ttc_parse_peek(parser)->kind != TTC_TOKEN_STRING) return ttc_parse_unexpected(parser, "a text in quotes");
    return ttc_parse_meaning(parser, &model->turn_meaning);
}
