/* Records that ask for kernels of their own: variant, time, eliminate. */
#include "read/parser.h"

#include <stdlib.h>
#include <string.h>

/* Report an error if a right-hand side of a variant depends on a state. */
static bool check_fixed(ttc_parser *parser, const ttc_bindings *bindings)
{
    const ttc_model *model = parser->model;
    ttc_id *ids = malloc(bindings->count * sizeof *ids);
    if (ids == NULL) return ttc_parse_no_memory(parser);
    for (size_t i = 0; i < bindings->count; i++) ids[i] = bindings->items[i].expression;
    unsigned char *support = ttc_model_support(model, ids, bindings->count);
    free(ids);
    if (support == NULL) return ttc_parse_no_memory(parser);
    const char *moving = NULL;
    for (size_t s = 0; s < model->symbol_count; s++)
        if (support[s] && model->symbols[s].kind == TTC_STATE) moving = model->symbols[s].name;
    free(support);
    if (moving == NULL) return true;
    return ttc_parse_error(parser, bindings->items->place, "the state '%s' stands in a variant (expected parameters and "
                           "numbers)", moving);
}

static bool check_new(ttc_parser *parser, const ttc_token *name, const char *what, size_t count, const char *taken)
{
    if (taken != NULL)
        return ttc_parse_error(parser, ttc_token_place(name), "a second %s of the name '%s'", what, taken);
    if (count >= TTC_KERNEL_LIMIT)
        return ttc_parse_error(parser, ttc_token_place(name), "too many records '%s' (expected at most %d)", what,
                               TTC_KERNEL_LIMIT);
    return true;
}

static bool parse_variant(ttc_parser *parser, const ttc_token *name)
{
    ttc_model *model = parser->model;
    const char *taken = NULL;
    for (size_t i = 0; i < model->variant_count; i++)
        if (ttc_token_is(name, model->variants[i].name)) taken = model->variants[i].name;
    if (!check_new(parser, name, "variant", model->variant_count, taken)) return false;
    if (!TTC_ARRAY_GROW(model->variants, model->variant_count)) return ttc_parse_no_memory(parser);
    ttc_variant *variant = model->variants + model->variant_count;
    memset(variant, 0, sizeof *variant);
    variant->place = ttc_token_place(name);
    if ((variant->name = ttc_parse_copy(parser, name->text, name->length)) == NULL) return false;
    model->variant_count++;
    if (!ttc_parse_bindings(parser, &variant->bindings, 1u << TTC_PARAM, "a parameter")) return false;
    ttc_parse_check_constants(parser, &variant->bindings);
    return check_fixed(parser, &variant->bindings) && ttc_parse_check_circle(parser, &variant->bindings, &variant->bindings, NULL);
}

static bool parse_lifted(ttc_parser *parser, ttc_time *time)
{
    do {
        uint32_t symbol;
        const ttc_token *name = ttc_parse_name(parser, "a root");
        if (name == NULL || !ttc_parse_known(parser, name, &symbol)) return false;
        parser->used[symbol] = 1;
        if (parser->model->symbols[symbol].kind != TTC_ROOT)
            return ttc_parse_error(parser, ttc_token_place(name), "'%s' is not a root (expected one)",
                                   parser->model->symbols[symbol].name);
        if (ttc_array_has(time->lifted, time->lifted_count, symbol))
            return ttc_parse_error(parser, ttc_token_place(name), "'%s' is lifted twice", parser->model->symbols[symbol].name);
        if (!ttc_parse_append(parser, &time->lifted, &time->lifted_count, symbol)) return false;
    } while (ttc_parse_accept_mark(parser, ','));
    return true;
}

static bool parse_time(ttc_parser *parser, const ttc_token *name)
{
    ttc_model *model = parser->model;
    const char *taken = NULL;
    for (size_t i = 0; i < model->time_count; i++)
        if (ttc_token_is(name, model->times[i].name)) taken = model->times[i].name;
    if (!check_new(parser, name, "time", model->time_count, taken)) return false;
    if (!TTC_ARRAY_GROW(model->times, model->time_count)) return ttc_parse_no_memory(parser);
    ttc_time *time = model->times + model->time_count;
    memset(time, 0, sizeof *time);
    time->place = ttc_token_place(name);
    if ((time->name = ttc_parse_copy(parser, name->text, name->length)) == NULL) return false;
    model->time_count++;
    ttc_place place = ttc_token_place(ttc_parse_peek(parser));
    time->factor = ttc_parse_expression(parser);
    if (time->factor == TTC_NONE) return false;
    if (ttc_kind_of(model->graph, time->factor) == TTC_NUMBER && fmpq_sgn(ttc_coefficient(model->graph, time->factor)) <= 0)
        return ttc_parse_error(parser, place, "the factor of a new time is not positive (expected dt = expr * dtau, expr > 0)");
    return !ttc_parse_accept_keyword(parser, TTC_KEYWORD_LIFTING) || parse_lifted(parser, time);
}

/* The level is a new name, a parameter of the table, or the level of an earlier elimination; check_levels compares integrals. */
static bool define_level(ttc_parser *parser, const ttc_token *name, uint32_t *level)
{
    if (!ttc_parse_find(parser, name, level)) return ttc_parse_define(parser, name, TTC_LEVEL, TTC_NONE, level);
    ttc_symbol_kind kind = parser->model->symbols[*level].kind;
    parser->used[*level] = 1;
    if (kind == TTC_LEVEL || kind == TTC_PARAM) return true;
    return ttc_parse_error(parser, ttc_token_place(name), "'%s' cannot be a level (expected a new name, or a parameter)",
                           parser->model->symbols[*level].name);
}

static bool parse_elimination(ttc_parser *parser, const ttc_token *name)
{
    ttc_model *model = parser->model;
    const char *taken = NULL;
    for (size_t i = 0; i < model->elimination_count; i++)
        if (ttc_token_is(name, model->eliminations[i].name)) taken = model->eliminations[i].name;
    if (!check_new(parser, name, "eliminate", model->elimination_count, taken)) return false;
    if (!TTC_ARRAY_GROW(model->eliminations, model->elimination_count)) return ttc_parse_no_memory(parser);
    ttc_elimination *elimination = model->eliminations + model->elimination_count;
    memset(elimination, 0, sizeof *elimination);
    elimination->place = ttc_token_place(name);

    const ttc_token *state = ttc_parse_name(parser, "the state to eliminate");
    if (state == NULL || !ttc_parse_known(parser, state, &elimination->state)) return false;
    if (model->symbols[elimination->state].kind != TTC_STATE)
        return ttc_parse_error(parser, ttc_token_place(state), "'%s' is not a state (expected one)",
                               model->symbols[elimination->state].name);
    if (!ttc_parse_expect_keyword(parser, TTC_KEYWORD_BY, "the state")) return false;
    const ttc_token *integral = ttc_parse_name(parser, "an integral");
    if (integral == NULL || !ttc_parse_expect_mark(parser, '=', "the integral")) return false;
    const ttc_token *level = ttc_parse_name(parser, "a name for the integral's value");
    if (level == NULL || !define_level(parser, level, &elimination->level)) return false;
    if ((elimination->name = ttc_parse_copy(parser, name->text, name->length)) == NULL) return false;
    size_t index = model->elimination_count++;
    return ttc_parse_refer(parser, TTC_REFER_ELIMINATION, index, integral);
}

bool ttc_parse_kernel(ttc_parser *parser, const ttc_token *keyword)
{
    const ttc_token *name = ttc_parse_name(parser, "a name for the kernel");
    if (name == NULL || !ttc_parse_expect_mark(parser, ':', "the name")) return false;
    switch (keyword->keyword) {
    case TTC_KEYWORD_VARIANT: return parse_variant(parser, name);
    case TTC_KEYWORD_TIME: return parse_time(parser, name);
    default: return parse_elimination(parser, name);
    }
}
