/* Expressions by recursive descent:
 *
 *      expr   := [+|-] term { (+|-) term }
 *      term   := factor { (*|/) factor }
 *      factor := base [ ^ integer ]
 *      base   := number | name | ( expr ) | rate ( expr )
 *
 * The parser recurses only at parentheses, whose depth is bounded. Sums and products are built at once from all their parts. */
#include "read/parser.h"

#include <stdlib.h>
#include <string.h>

static bool push_operand(ttc_parser *parser, ttc_id id, long exponent, ttc_place place)
{
    if (parser->operand_count == parser->operand_capacity) {
        size_t capacity = 2 * parser->operand_capacity + 64;
        ttc_id *operands = realloc(parser->operands, capacity * sizeof *operands);
        if (operands != NULL) parser->operands = operands;
        long *exponents = realloc(parser->exponents, capacity * sizeof *exponents);
        if (exponents != NULL) parser->exponents = exponents;
        fmpq *weights = realloc(parser->weights, capacity * sizeof *weights);
        if (weights != NULL) parser->weights = weights;
        ttc_place *places = realloc(parser->places, capacity * sizeof *places);
        if (places != NULL) parser->places = places;
        if (operands == NULL || exponents == NULL || weights == NULL || places == NULL) return ttc_parse_no_memory(parser);
        parser->operand_capacity = capacity;
    }
    size_t at = parser->operand_count++;
    parser->operands[at] = id;
    parser->exponents[at] = exponent;
    parser->weights[at] = (fmpq){ exponent < 0 ? -1 : 1, 1 };
    parser->places[at] = place;
    return true;
}

bool ttc_parse_uses(ttc_parser *parser, uint32_t symbol)
{
    const ttc_symbol_kind kind = parser->model->symbols[symbol].kind;
    if (kind != TTC_LET && !ttc_symbol_is_function(kind)) return true;
    return ttc_parse_append(parser, &parser->uses, &parser->use_count, symbol);
}

/* Record a divisor of the current record, unless it is a number. Returns false when memory is out. */
static bool note_divisor(ttc_parser *parser, ttc_id divisor)
{
    if (ttc_kind_of(parser->model->graph, divisor) == TTC_NUMBER) return true;
    return ttc_parse_append(parser, &parser->divisors, &parser->divisor_count, divisor);
}

static bool is_integer(const ttc_token *token)
{
    bool result = token->kind == TTC_TOKEN_NUMBER;
    for (uint32_t i = 0; result && i < token->length; i++) result = token->text[i] >= '0' && token->text[i] <= '9';
    return result;
}

/* integer, with a sign or in parentheses */
static bool parse_exponent(ttc_parser *parser, long *exponent)
{
    static const char integer_exponent[] = "an integer exponent: roots and exponentials have records of their own";
    bool enclosed = ttc_parse_accept_mark(parser, '(');
    bool negative = ttc_parse_accept_mark(parser, '-');
    if (!negative) ttc_parse_accept_mark(parser, '+');
    const ttc_token *token = ttc_parse_peek(parser);
    if (!is_integer(token)) return ttc_parse_unexpected(parser, integer_exponent);
    parser->at++;
    long value = 0;
    for (uint32_t i = 0; i < token->length && value <= TTC_EXPONENT_LIMIT; i++) value = 10 * value + (token->text[i] - '0');
    if (value > TTC_EXPONENT_LIMIT)
        return ttc_parse_error(parser, ttc_token_place(token), "the exponent is too large (expected at most %d)",
                               TTC_EXPONENT_LIMIT);
    if (enclosed && ttc_parse_at_mark(parser, '/')) return ttc_parse_unexpected(parser, integer_exponent);
    if (enclosed && !ttc_parse_expect_mark(parser, ')', "the exponent")) return false;
    if (ttc_parse_at_mark(parser, '^')) return ttc_parse_unexpected(parser, "parentheses around a power of a power");
    *exponent = negative ? -value : value;
    return true;
}

static ttc_id parse_symbol(ttc_parser *parser, const ttc_token *name)
{
    static const char lambda[] = "lambda";
    uint32_t symbol;
    if (parser->in_charpoly && ttc_token_is(name, lambda))
        return parser->model->symbols[0].node;
    if (ttc_parse_find(parser, name, &symbol)) {
        parser->used[symbol] = 1;
        return ttc_parse_uses(parser, symbol) ? parser->model->symbols[symbol].node : TTC_NONE;
    }
    for (size_t i = 0; i < parser->model->claim_count; i++) {
        const ttc_claim *claim = parser->model->claims + i;
        bool has_value = claim->kind == TTC_CLAIM_INTEGRAL || claim->kind == TTC_CLAIM_INVARIANT ||
                         claim->kind == TTC_CLAIM_MEASURE;
        if (!has_value || strlen(claim->name) != name->length || memcmp(claim->name, name->text, name->length) != 0) continue;
        for (size_t k = 0; k < parser->model->divisor_count; k++) {
            const ttc_divisor *d = parser->model->divisors + k;
            if (d->role == TTC_DIVIDES_CLAIM && d->owner == i && !note_divisor(parser, d->divisor)) return TTC_NONE;
        }
        for (size_t k = 0; k < parser->model->use_count; k++) {
            const ttc_use *use = parser->model->uses + k;
            if (use->role == TTC_DIVIDES_CLAIM && use->owner == i && !ttc_parse_uses(parser, use->symbol)) return TTC_NONE;
        }
        return claim->expression;
    }
    if (ttc_parse_pi(parser, name, &symbol)) return parser->model->symbols[symbol].node;
    ttc_parse_unknown(parser, name);
    return TTC_NONE;
}

/* ( expr ). The current token is '('. */
static ttc_id parse_parentheses(ttc_parser *parser)
{
    if (parser->nesting >= TTC_NESTING_LIMIT) {
        ttc_parse_error(parser, ttc_token_place(ttc_parse_peek(parser)), "parentheses nest too deep (expected at most %d)",
                        TTC_NESTING_LIMIT);
        return TTC_NONE;
    }
    parser->at++;
    parser->nesting++;
    ttc_id id = ttc_parse_expression(parser);
    parser->nesting--;
    return id != TTC_NONE && ttc_parse_expect_mark(parser, ')', "the expression in parentheses") ? id : TTC_NONE;
}

/* ( expr ) after the name `rate`. Returns the rate of the expression along the flow. */
static ttc_id parse_rate(ttc_parser *parser, const ttc_token *name)
{
    const ttc_model *model = parser->model;
    const ttc_place place = ttc_token_place(name);
    size_t missing = 0;
    if (!parser->may_rate) {
        ttc_parse_error(parser, place, "rate() stands in 'observe' and 'valid' alone (expected the rate written out)");
        return TTC_NONE;
    }
    while (missing < model->equation_count && model->equations[missing].place.line != 0) missing++;
    if (missing < model->state_count) {
        ttc_parse_error(parser, place, "rate() before all equations are there (expected 'eq %s = ...' above it)",
                        model->symbols[model->states[missing]].name);
        return TTC_NONE;
    }
    ttc_id id = parse_parentheses(parser);
    if (id == TTC_NONE) return TTC_NONE;
    id = ttc_model_rate(model, id);
    return id == TTC_NONE ? ttc_parse_graph_error(parser, place) : id;
}

static ttc_id parse_base(ttc_parser *parser)
{
    const ttc_token *token = ttc_parse_peek(parser);
    if (token->kind == TTC_TOKEN_NUMBER) {
        parser->at++;
        return ttc_parse_number(parser, token);
    }
    if (token->kind == TTC_TOKEN_NAME) {
        parser->at++;
        if (ttc_parse_at_mark(parser, '(') && token->keyword == TTC_KEYWORD_RATE) return parse_rate(parser, token);
        if (ttc_parse_at_mark(parser, '(')) {
            ttc_parse_unexpected(parser, token->keyword == TTC_KEYWORD_EXP || token->keyword == TTC_KEYWORD_LOG
                                             ? "an operator: a function gets a name by its own record, such as 'exp e = exp(x)'"
                                             : "an operator: names stand for quantities, not for functions");
            return TTC_NONE;
        }
        return parse_symbol(parser, token);
    }
    if (ttc_parse_at_mark(parser, '(')) return parse_parentheses(parser);
    const bool is_function = token->kind == TTC_TOKEN_KEYWORD;
    if (is_function && token->keyword == TTC_KEYWORD_SQRT)
        ttc_parse_unexpected(parser, "a name that its own record gives to it, such as 'root s = sqrt(1 - x^2)'");
    else if (is_function && (token->keyword == TTC_KEYWORD_COS || token->keyword == TTC_KEYWORD_SIN))
        ttc_parse_unexpected(parser, "a name that its own record gives to it, such as 'angle C S = cos(x) sin(x)'");
    else ttc_parse_unexpected(parser, "a number, a name or '('");
    return TTC_NONE;
}

/* Whether a factor begins here, in the line of the factor before it, where only an operator may stand between them. */
static bool lacks_operator(ttc_parser *parser)
{
    const ttc_token *token = ttc_parse_peek(parser);
    const bool is_name = token->kind == TTC_TOKEN_NAME && token->keyword == TTC_KEYWORD_NONE;
    return (is_name || token->kind == TTC_TOKEN_NUMBER || ttc_parse_at_mark(parser, '(')) && token->line == token[-1].line;
}

static ttc_id parse_term(ttc_parser *parser)
{
    size_t first = parser->operand_count;
    ttc_place place = ttc_token_place(ttc_parse_peek(parser));
    bool divides = false;
    do {
        ttc_place factor_place = ttc_token_place(ttc_parse_peek(parser));
        ttc_id id = parse_base(parser);
        long exponent = 1;
        if (id == TTC_NONE || (ttc_parse_accept_mark(parser, '^') && !parse_exponent(parser, &exponent))) return TTC_NONE;
        if (divides) exponent = -exponent;
        if (exponent < 0 && ttc_is_number(parser->model->graph, id, 0)) {
            ttc_parse_error(parser, factor_place, "division by zero");
            return TTC_NONE;
        }
        if (exponent < 0 && !note_divisor(parser, id)) return TTC_NONE;
        if (!push_operand(parser, id, exponent, factor_place)) return TTC_NONE;
        divides = ttc_parse_at_mark(parser, '/');
    } while (ttc_parse_accept_mark(parser, '*') || ttc_parse_accept_mark(parser, '/'));
    if (lacks_operator(parser)) {
        ttc_parse_unexpected(parser, "an operator before it, such as *, or the end of the record");
        return TTC_NONE;
    }
    size_t count = parser->operand_count - first;
    parser->operand_count = first;
    ttc_id id = count == 1 && parser->exponents[first] == 1
                    ? parser->operands[first]
                    : ttc_product(parser->model->graph, parser->operands + first, parser->exponents + first, count);
    return id == TTC_NONE ? ttc_parse_graph_error(parser, place) : id;
}

size_t ttc_parse_terms(ttc_parser *parser)
{
    size_t first = parser->operand_count;
    bool more = true;
    while (more) {
        ttc_place place = ttc_token_place(ttc_parse_peek(parser));
        bool negative = ttc_parse_at_mark(parser, '-');
        if (!ttc_parse_accept_mark(parser, '-')) ttc_parse_accept_mark(parser, '+');
        ttc_id id = parse_term(parser);
        if (id == TTC_NONE || !push_operand(parser, id, negative ? -1 : 1, place)) return SIZE_MAX;
        more = ttc_parse_at_mark(parser, '+') || ttc_parse_at_mark(parser, '-');
    }
    return first;
}

ttc_id ttc_parse_expression(ttc_parser *parser)
{
    ttc_place place = ttc_token_place(ttc_parse_peek(parser));
    size_t first = ttc_parse_terms(parser);
    if (first == SIZE_MAX) return TTC_NONE;
    size_t count = parser->operand_count - first;
    parser->operand_count = first;
    ttc_id id = count == 1 && parser->exponents[first] == 1
                    ? parser->operands[first]
                    : ttc_sum(parser->model->graph, parser->operands + first, parser->weights + first, count);
    if (id == TTC_NONE) return ttc_parse_graph_error(parser, place);
    if (parser->nesting > 0) return id;
    return ttc_parse_measure(parser, id, place) ? id : TTC_NONE;
}

/* Measures every node made since the last call: parts have smaller ids than their node, definitions than their symbol. */
bool ttc_parse_measure(ttc_parser *parser, ttc_id id, ttc_place place)
{
    const ttc_model *model = parser->model;
    const ttc_graph *graph = model->graph;
    if (id >= parser->measured_capacity) {
        size_t capacity = 2 * (size_t)id + 64;
        ttc_expansion *expansions = realloc(parser->expansions, capacity * sizeof *expansions);
        if (expansions == NULL) return ttc_parse_no_memory(parser);
        parser->expansions = expansions;
        parser->measured_capacity = capacity;
    }
    for (ttc_id at = (ttc_id)parser->measured + 1; at <= id; at++) {
        ttc_expansion of = { 1, 1 };
        if (ttc_kind_of(graph, at) == TTC_SYMBOL) {
            const ttc_symbol_entry *entry = model->symbols + ttc_symbol_of(graph, at);
            if (entry->kind == TTC_LET) of.with_lets = parser->expansions[entry->definition].with_lets;
        }
        for (size_t i = 0; i < ttc_part_count(graph, at); i++) {
            const ttc_part part = ttc_part_at(graph, at, i);
            of.with_lets += parser->expansions[part.id].with_lets;
            const int copies = ttc_kind_of(graph, part.id) == TTC_SYMBOL ? 1 : abs(part.exponent);
            of.with_powers += copies * parser->expansions[part.id].with_powers;
        }
        parser->expansions[at] = of;
    }
    if (id > parser->measured) parser->measured = id;
    const ttc_expansion *of = parser->expansions + id;
    if (of->with_lets <= TTC_EXPANSION_LIMIT && of->with_powers <= TTC_EXPANSION_LIMIT) return true;
    return ttc_parse_error(parser, place, "the expression written out in full is too large (expected at most %d operands)",
                           TTC_EXPANSION_LIMIT);
}
