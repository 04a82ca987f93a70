/* Records that define the model: title, source, param, state, root, angle, exp, log, let, eq, default, domain. */
#include "read/parser.h"

#include <stdlib.h>
#include <string.h>

/* "text" ...: several texts are joined by blanks. */
bool ttc_parse_title(ttc_parser *parser, const ttc_token *keyword)
{
    bool is_title = keyword->keyword == TTC_KEYWORD_TITLE;
    char **field = is_title ? &parser->model->title : &parser->model->source;
    if (*field != NULL)
        return ttc_parse_error(parser, ttc_token_place(keyword), "a second %s (expected one)", ttc_keyword_text(keyword->keyword));
    const ttc_token *token = ttc_parse_peek(parser);
    if (token->kind != TTC_TOKEN_STRING) return ttc_parse_unexpected(parser, "a text in quotes");
    size_t length = 0, count = 0;
    for (; token[count].kind == TTC_TOKEN_STRING; count++) length += token[count].length + 1;
    char *text = malloc(length);
    if (text == NULL) return ttc_parse_no_memory(parser);
    char *at = text;
    for (size_t i = 0; i < count; i++) {
        memcpy(at, token[i].text, token[i].length);
        at += token[i].length;
        *at++ = i + 1 < count ? ' ' : '\0';
    }
    *field = text;
    parser->at += count;
    return true;
}

bool ttc_parse_unit_and_meaning(ttc_parser *parser, char **unit, char **meaning)
{
    const ttc_token *token = ttc_parse_peek(parser);
    if (token->kind == TTC_TOKEN_UNIT) {
        if ((*unit = ttc_parse_copy(parser, token->text, token->length)) == NULL) return false;
        token = parser->tokens + ++parser->at;
    }
    if (token->kind != TTC_TOKEN_STRING) return true;
    parser->at++;
    return (*meaning = ttc_parse_copy(parser, token->text, token->length)) != NULL;
}

static bool parse_unit_and_meaning(ttc_parser *parser, uint32_t symbol)
{
    ttc_symbol_entry *entry = parser->model->symbols + symbol;
    return ttc_parse_unit_and_meaning(parser, &entry->unit, &entry->meaning);
}

static bool parse_param(ttc_parser *parser)
{
    uint32_t symbol;
    const ttc_token *name = ttc_parse_name(parser, "the parameter's name");
    if (name == NULL || !ttc_parse_define(parser, name, TTC_PARAM, TTC_NONE, &symbol) ||
        !ttc_parse_append(parser, &parser->model->params, &parser->model->param_count, symbol))
        return false;
    ttc_sign sign = TTC_ANY_SIGN;
    const ttc_token *relation = ttc_parse_peek(parser);
    if (ttc_parse_at_mark(parser, '>')) sign = TTC_POSITIVE;
    else if (relation->kind == TTC_TOKEN_AT_LEAST) sign = TTC_NONNEGATIVE;
    else if (relation->kind == TTC_TOKEN_NOT_EQUAL) sign = TTC_NONZERO;
    parser->model->symbols[symbol].sign = sign;
    if (sign != TTC_ANY_SIGN) {
        parser->at++;
        const ttc_token *zero = ttc_parse_peek(parser);
        if (zero->kind != TTC_TOKEN_NUMBER || zero->length != 1 || *zero->text != '0')
            return ttc_parse_unexpected(parser, "0: a parameter is > 0, >= 0 or != 0");
        parser->at++;
    }
    return parse_unit_and_meaning(parser, symbol);
}

/* An end of an interval: an expression, or inf with the sign of this end, which leaves *end as it is. */
static bool parse_interval_end(ttc_parser *parser, ttc_id *end, bool is_lower)
{
    const ttc_token *token = ttc_parse_peek(parser);
    const bool is_negative = ttc_parse_at_mark(parser, '-'), has_sign = is_negative || ttc_parse_at_mark(parser, '+');
    const ttc_token *word = token + (has_sign ? 1 : 0);
    uint32_t symbol;
    if (ttc_token_is(word, "inf") && !ttc_parse_find(parser, word, &symbol)) {
        if (is_negative != is_lower)
            return ttc_parse_error(parser, ttc_token_place(token), "no number is %s (expected '%s' as the %s end)",
                                   is_lower ? "above it" : "below it", is_lower ? "-inf" : "inf", is_lower ? "lower" : "upper");
        parser->at += has_sign ? 2 : 1;
        return true;
    }
    *end = ttc_parse_expression(parser);
    return *end != TTC_NONE;
}

/* Report an error if an end depends on a state or a function, or if both are numbers in the wrong order. */
static bool check_interval(ttc_parser *parser, const ttc_id ends[2], ttc_place place)
{
    const ttc_graph *graph = parser->model->graph;
    for (int i = 0; i < 2; i++) {
        if (ends[i] == TTC_NONE) continue;
        unsigned char *support = ttc_model_support(parser->model, ends + i, 1);
        if (support == NULL) return ttc_parse_no_memory(parser);
        bool moves = false;
        for (size_t s = 0; s < parser->model->symbol_count; s++)
            moves |= support[s] && (parser->model->symbols[s].kind == TTC_STATE ||
                                    ttc_symbol_is_function(parser->model->symbols[s].kind));
        free(support);
        if (moves) return ttc_parse_error(parser, place, "the interval depends on a state (expected numbers and parameters)");
    }
    if (ends[0] == TTC_NONE || ends[1] == TTC_NONE) return true;
    if (ttc_kind_of(graph, ends[0]) != TTC_NUMBER || ttc_kind_of(graph, ends[1]) != TTC_NUMBER) return true;
    if (fmpq_cmp(ttc_coefficient(graph, ends[0]), ttc_coefficient(graph, ends[1])) < 0) return true;
    return ttc_parse_error(parser, place, "the interval is empty (expected its lower end first)");
}

static bool parse_state(ttc_parser *parser)
{
    uint32_t symbol;
    const ttc_token *name = ttc_parse_name(parser, "the state's name");
    if (name == NULL) return false;
    if (parser->model->state_count >= TTC_STATE_LIMIT)
        return ttc_parse_error(parser, ttc_token_place(name), "too many states (expected at most %d)", TTC_STATE_LIMIT);
    if (parser->model->start_count > 0)
        return ttc_parse_error(parser, ttc_token_place(name), "a state below the start '%s' (expected above it)",
                               parser->model->starts[0].name);
    if (!ttc_parse_define(parser, name, TTC_STATE, TTC_NONE, &symbol) ||
        !ttc_parse_append(parser, &parser->model->states, &parser->model->state_count, symbol))
        return false;
    if (ttc_parse_accept_keyword(parser, TTC_KEYWORD_IN)) {
        ttc_id ends[2] = { TTC_NONE, TTC_NONE };
        ttc_place place = ttc_token_place(ttc_parse_peek(parser));
        if (!ttc_parse_expect_mark(parser, '(', "'in'") || !parse_interval_end(parser, ends, true) ||
            !ttc_parse_expect_mark(parser, ',', "the lower end") || !parse_interval_end(parser, ends + 1, false) ||
            !ttc_parse_expect_mark(parser, ')', "the upper end") || !check_interval(parser, ends, place))
            return false;
        parser->model->symbols[symbol].low = ends[0];
        parser->model->symbols[symbol].high = ends[1];
    } else if (ttc_parse_at_mark(parser, '>') || ttc_parse_peek(parser)->kind == TTC_TOKEN_AT_LEAST) {
        return ttc_parse_unexpected(parser, "the interval of a state, as in 'in (0, inf)'");
    }
    return parse_unit_and_meaning(parser, symbol);
}

/* FUNCTION ( expr ). Returns the argument. */
static ttc_id parse_function(ttc_parser *parser, ttc_keyword function, const char *after)
{
    if (!ttc_parse_expect_keyword(parser, function, after)) return TTC_NONE;
    if (!ttc_parse_expect_mark(parser, '(', ttc_keyword_text(function))) return TTC_NONE;
    ttc_id id = ttc_parse_expression(parser);
    return id != TTC_NONE && ttc_parse_expect_mark(parser, ')', "the argument") ? id : TTC_NONE;
}

/* Report an error if the root is a rational number, does not exist, or has a name already. */
static bool check_radicand(ttc_parser *parser, ttc_id radicand, ttc_place place)
{
    const ttc_model *model = parser->model;
    for (size_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_ROOT && model->symbols[i].definition == radicand)
            return ttc_parse_error(parser, place, "the same root as '%s' (expected one name for it)", model->symbols[i].name);
    if (ttc_kind_of(model->graph, radicand) != TTC_NUMBER) return true;
    const fmpq *value = ttc_coefficient(model->graph, radicand);
    if (fmpq_sgn(value) <= 0) return ttc_parse_error(parser, place, "the root of a number that is not positive");
    if (fmpz_is_square(fmpq_numref(value)) && fmpz_is_square(fmpq_denref(value)))
        return ttc_parse_error(parser, place, "the root of a square number (expected the rational number it is)");
    return true;
}

static bool parse_root(ttc_parser *parser)
{
    uint32_t symbol;
    const ttc_token *name = ttc_parse_name(parser, "the root's name");
    if (name == NULL || !ttc_parse_expect_mark(parser, '=', "the root's name")) return false;
    ttc_place place = ttc_token_place(ttc_parse_peek(parser));
    ttc_id radicand = parse_function(parser, TTC_KEYWORD_SQRT, "'='");
    if (radicand != TTC_NONE && !check_radicand(parser, radicand, place)) radicand = TTC_NONE;
    return ttc_parse_define(parser, name, TTC_ROOT, radicand, &symbol) && radicand != TTC_NONE;
}

static bool parse_angle(ttc_parser *parser)
{
    uint32_t cosine, sine;
    const ttc_token *first = ttc_parse_name(parser, "the name of the cosine");
    if (first == NULL) return false;
    const ttc_token *second = ttc_parse_name(parser, "the name of the sine");
    if (second == NULL || !ttc_parse_expect_mark(parser, '=', "the two names")) return false;
    ttc_id angle = parse_function(parser, TTC_KEYWORD_COS, "'='");
    if (angle == TTC_NONE) return false;
    ttc_place place = ttc_token_place(ttc_parse_peek(parser));
    ttc_id same = parse_function(parser, TTC_KEYWORD_SIN, "the cosine");
    if (same == TTC_NONE) return false;
    if (same != angle) return ttc_parse_error(parser, place, "cosine and sine of different angles (expected the same)");
    if (!ttc_parse_define(parser, first, TTC_COSINE, angle, &cosine) ||
        !ttc_parse_define(parser, second, TTC_SINE, angle, &sine))
        return false;
    parser->model->symbols[cosine].partner = sine;
    parser->model->symbols[sine].partner = cosine;
    return true;
}

/* Report an error if the exponential or logarithm is a rational number, does not exist, or has a name already. */
static bool check_argument(ttc_parser *parser, ttc_symbol_kind kind, ttc_id argument, ttc_place place)
{
    const ttc_model *model = parser->model;
    for (size_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == kind && model->symbols[i].definition == argument)
            return ttc_parse_error(parser, place, "the same %s as '%s' (expected one name for it)",
                                   kind == TTC_EXP ? "exponential" : "logarithm", model->symbols[i].name);
    if (ttc_kind_of(model->graph, argument) != TTC_NUMBER) return true;
    const fmpq *value = ttc_coefficient(model->graph, argument);
    if (kind == TTC_EXP && fmpq_is_zero(value))
        return ttc_parse_error(parser, place, "the exponential of zero (expected the number 1)");
    if (kind == TTC_LOG && fmpq_is_one(value))
        return ttc_parse_error(parser, place, "the logarithm of one (expected the number 0)");
    if (kind == TTC_LOG && fmpq_sgn(value) <= 0)
        return ttc_parse_error(parser, place, "the logarithm of a number that is not positive");
    return true;
}

static bool parse_transcendental(ttc_parser *parser, ttc_symbol_kind kind)
{
    uint32_t symbol;
    const bool is_exp = kind == TTC_EXP;
    const ttc_token *name = ttc_parse_name(parser, is_exp ? "the exponential's name" : "the logarithm's name");
    if (name == NULL || !ttc_parse_expect_mark(parser, '=', "the name")) return false;
    ttc_place place = ttc_token_place(ttc_parse_peek(parser));
    ttc_id argument = parse_function(parser, is_exp ? TTC_KEYWORD_EXP : TTC_KEYWORD_LOG, "'='");
    if (argument != TTC_NONE && !check_argument(parser, kind, argument, place)) argument = TTC_NONE;
    return ttc_parse_define(parser, name, kind, argument, &symbol) && argument != TTC_NONE;
}

static bool parse_let(ttc_parser *parser)
{
    uint32_t symbol;
    const ttc_token *name = ttc_parse_name(parser, "a name for the expression");
    if (name == NULL || !ttc_parse_expect_mark(parser, '=', "the name")) return false;
    ttc_id definition = ttc_parse_expression(parser);
    return ttc_parse_define(parser, name, TTC_LET, definition, &symbol) && definition != TTC_NONE;
}

bool ttc_parse_quantity(ttc_parser *parser, const ttc_token *keyword)
{
    switch (keyword->keyword) {
    case TTC_KEYWORD_PARAM: return parse_param(parser);
    case TTC_KEYWORD_STATE: return parse_state(parser);
    case TTC_KEYWORD_ROOT: return parse_root(parser);
    case TTC_KEYWORD_ANGLE: return parse_angle(parser);
    case TTC_KEYWORD_EXP: return parse_transcendental(parser, TTC_EXP);
    case TTC_KEYWORD_LOG: return parse_transcendental(parser, TTC_LOG);
    default: return parse_let(parser);
    }
}

/* Find the state that a record is about, and its position in the state vector. */
static bool parse_equation_state(ttc_parser *parser, const ttc_token *name, uint32_t *state, size_t *position)
{
    ttc_model *model = parser->model;
    if (!ttc_parse_known(parser, name, state)) return false;
    for (*position = 0; *position < model->state_count; (*position)++)
        if (model->states[*position] == *state) return true;
    return ttc_parse_error(parser, ttc_token_place(name), "'%s' is not a state (expected one)", model->symbols[*state].name);
}

/* The place of the equation of state number `position`: equations are stored in the order of states. */
static ttc_equation *place_for_equation(ttc_parser *parser, size_t position)
{
    ttc_model *model = parser->model;
    if (position >= model->equation_count) {
        ttc_equation *grown = realloc(model->equations, model->state_count * sizeof *grown);
        if (grown == NULL) {
            ttc_parse_no_memory(parser);
            return NULL;
        }
        memset(grown + model->equation_count, 0, (model->state_count - model->equation_count) * sizeof *grown);
        model->equations = grown;
        model->equation_count = model->state_count;
    }
    return model->equations + position;
}

bool ttc_parse_equation(ttc_parser *parser)
{
    uint32_t state;
    size_t position;
    const ttc_token *name = ttc_parse_name(parser, "the state whose rate this is");
    if (name == NULL || !parse_equation_state(parser, name, &state, &position)) return false;
    ttc_equation *equation = place_for_equation(parser, position);
    if (equation == NULL) return false;
    if (equation->place.line != 0)
        return ttc_parse_error(parser, ttc_token_place(name), "a second equation for '%s' (first in line %u)",
                               parser->model->symbols[state].name, (unsigned)equation->place.line);
    equation->state = state;
    equation->place = ttc_token_place(name);
    if (!ttc_parse_expect_mark(parser, '=', "the state")) return false;
    size_t first = ttc_parse_terms(parser);
    if (first == SIZE_MAX) return false;
    size_t count = parser->operand_count - first;
    parser->operand_count = first;
    equation->terms = malloc(count * sizeof *equation->terms);
    if (equation->terms == NULL) return ttc_parse_no_memory(parser);
    for (size_t i = 0; i < count; i++) {
        ttc_id id = ttc_scale(parser->model->graph, parser->operands[first + i], parser->weights + first + i);
        if (id == TTC_NONE) return ttc_parse_graph_error(parser, parser->places[first + i]) != TTC_NONE;
        equation->terms[i] = (ttc_term){ id, parser->places[first + i] };
        equation->term_count = i + 1;
    }
    equation->sum = ttc_sum(parser->model->graph, parser->operands + first, parser->weights + first, count);
    if (equation->sum == TTC_NONE) return ttc_parse_graph_error(parser, equation->place) != TTC_NONE;
    return ttc_parse_measure(parser, equation->sum, equation->place);
}

static bool sign_allows(ttc_sign sign, const fmpq *value)
{
    switch (sign) {
    case TTC_POSITIVE: return fmpq_sgn(value) > 0;
    case TTC_NONNEGATIVE: return fmpq_sgn(value) >= 0;
    case TTC_NONZERO: return fmpq_sgn(value) != 0;
    default: return true;
    }
}

static bool uses_pi(const ttc_model *model, ttc_id id)
{
    for (uint32_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_PI) return ttc_model_depends(model, id, i);
    return false;
}

bool ttc_parse_default(ttc_parser *parser)
{
    do {
        uint32_t symbol;
        const ttc_token *name = ttc_parse_name(parser, "a parameter's name");
        if (name == NULL || !ttc_parse_known(parser, name, &symbol)) return false;
        ttc_symbol_entry *entry = parser->model->symbols + symbol;
        ttc_place place = ttc_token_place(name);
        if (entry->kind != TTC_PARAM) return ttc_parse_error(parser, place, "'%s' is not a parameter (expected one)", entry->name);
        if (entry->value != TTC_NONE) return ttc_parse_error(parser, place, "a second default of '%s'", entry->name);
        if (!ttc_parse_expect_mark(parser, '=', "the parameter")) return false;
        place = ttc_token_place(ttc_parse_peek(parser));
        ttc_id value = ttc_parse_expression(parser);
        if (value == TTC_NONE) return false;
        if (ttc_kind_of(parser->model->graph, value) != TTC_NUMBER)
            return ttc_parse_error(parser, place, "%s (expected one, such as 2/5)",
                                   uses_pi(parser->model, value) ? "a default in 'pi', which is no rational number"
                                                                 : "a default that is not a number");
        if (!sign_allows(entry->sign, ttc_coefficient(parser->model->graph, value)))
            return ttc_parse_error(parser, place, "the default of '%s' lies outside its own condition", entry->name);
        entry->value = value;
    } while (ttc_parse_accept_mark(parser, ','));
    return true;
}

bool ttc_parse_positive(ttc_parser *parser, const char *rule)
{
    char expected[80];
    if (!ttc_parse_expect_mark(parser, '>', "the expression")) return false;
    const ttc_token *zero = ttc_parse_peek(parser);
    snprintf(expected, sizeof expected, "0: %s", rule);
    if (zero->kind != TTC_TOKEN_NUMBER || zero->length != 1 || *zero->text != '0') return ttc_parse_unexpected(parser, expected);
    parser->at++;
    return true;
}

/* NAME : expr > 0 */
bool ttc_parse_region(ttc_parser *parser)
{
    ttc_model *model = parser->model;
    const ttc_token *name = ttc_parse_name(parser, "a name for the condition");
    if (name == NULL || !ttc_parse_expect_mark(parser, ':', "the name")) return false;
    for (size_t i = 0; i < model->region_count; i++)
        if (ttc_token_is(name, model->regions[i].name))
            return ttc_parse_error(parser, ttc_token_place(name), "a second domain record '%s' (first in line %u)",
                                   model->regions[i].name, (unsigned)model->regions[i].place.line);
    if (model->region_count >= TTC_REGION_LIMIT)
        return ttc_parse_error(parser, ttc_token_place(name), "too many domain records (expected at most %d)", TTC_REGION_LIMIT);
    const size_t first = parser->at;
    ttc_id expression = ttc_parse_expression(parser);
    if (expression == TTC_NONE || !ttc_parse_positive(parser, "a domain is where an expression is > 0")) return false;
    if (!TTC_ARRAY_GROW(model->regions, model->region_count)) return ttc_parse_no_memory(parser);
    ttc_region *region = model->regions + model->region_count;
    *region = (ttc_region){ ttc_parse_copy(parser, name->text, name->length), ttc_parse_text_since(parser, first), expression,
                            ttc_token_place(name) };
    model->region_count++;
    return region->name != NULL && region->text != NULL;
}
