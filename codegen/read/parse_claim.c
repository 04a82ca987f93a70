/* Records of claims: the syntax of each kind, and the clauses `when` and `modulo`, which several kinds share. */
#include "read/parser.h"

#include <stdlib.h>
#include <string.h>

static bool is_clause_allowed(ttc_claim_kind kind)
{
    return kind == TTC_CLAIM_INTEGRAL || kind == TTC_CLAIM_INVARIANT || kind == TTC_CLAIM_MEASURE ||
           kind == TTC_CLAIM_REVERSOR || kind == TTC_CLAIM_EQUILIBRIA || kind == TTC_CLAIM_EQUAL || kind == TTC_CLAIM_RATE ||
           kind == TTC_CLAIM_POSITIVE || kind == TTC_CLAIM_REDUCTION || kind == TTC_CLAIM_EMBEDDING ||
           kind == TTC_CLAIM_SYMMETRY;
}

static bool is_map(ttc_claim_kind kind) { return kind == TTC_CLAIM_REVERSOR || kind == TTC_CLAIM_SYMMETRY; }

static bool parse_names(ttc_parser *parser, ttc_reference_role role, size_t owner, const char *expected)
{
    do {
        const ttc_token *name = ttc_parse_name(parser, expected);
        if (name == NULL || !ttc_parse_refer(parser, role, owner, name)) return false;
    } while (ttc_parse_accept_mark(parser, ','));
    return true;
}

/* [when NAME = expr, ...] [modulo NAME, ...] in any order, each once */
static bool parse_clauses(ttc_parser *parser, ttc_claim *claim)
{
    size_t index = parser->model->claim_count;
    bool has_modulo = false;
    for (;;) {
        ttc_place place = ttc_token_place(ttc_parse_peek(parser));
        if (ttc_parse_at_keyword(parser, TTC_KEYWORD_WHEN)) {
            if (claim->when.count > 0) return ttc_parse_error(parser, place, "a second 'when' (expected one list)");
            parser->at++;
            if (!ttc_parse_bindings(parser, &claim->when, 1u << TTC_PARAM | 1u << TTC_STATE, "a parameter or a state"))
                return false;
            ttc_parse_check_constants(parser, &claim->when);
        } else if (ttc_parse_at_keyword(parser, TTC_KEYWORD_MODULO) && !is_map(claim->kind) &&
                   claim->kind != TTC_CLAIM_EQUILIBRIA) {
            if (has_modulo) return ttc_parse_error(parser, place, "a second 'modulo' (expected one list)");
            has_modulo = true;
            parser->at++;
            if (!parse_names(parser, TTC_REFER_MODULO, index, "an integral or invariant")) return false;
        } else {
            return true;
        }
    }
}

/* STATE -> expression, ...: a simultaneous map of all states; those that are not named stay the same. */
static bool parse_map(ttc_parser *parser, ttc_claim *claim)
{
    do {
        uint32_t symbol;
        const ttc_token *name = ttc_parse_name(parser, "a state");
        if (name == NULL || !ttc_parse_known(parser, name, &symbol)) return false;
        const ttc_symbol_entry *entry = parser->model->symbols + symbol;
        ttc_place place = ttc_token_place(name);
        if (entry->kind != TTC_STATE) return ttc_parse_error(parser, place, "'%s' is not a state (expected one)", entry->name);
        for (size_t i = 0; i < claim->bindings.count; i++)
            if (claim->bindings.items[i].symbol == symbol)
                return ttc_parse_error(parser, place, "'%s' is %s twice", entry->name,
                                       claim->kind == TTC_CLAIM_REVERSOR ? "reversed" : "mapped");
        if (ttc_parse_peek(parser)->kind != TTC_TOKEN_ARROW) return ttc_parse_unexpected(parser, "'->' after the state");
        parser->at++;
        ttc_id image = ttc_parse_expression(parser);
        if (image == TTC_NONE) return false;
        if (!TTC_ARRAY_GROW(claim->bindings.items, claim->bindings.count)) return ttc_parse_no_memory(parser);
        claim->bindings.items[claim->bindings.count++] = (ttc_binding){ symbol, image, place };
    } while (ttc_parse_accept_mark(parser, ','));
    return true;
}

/* e11, e12, ... ; e21, ... */
static bool parse_matrix(ttc_parser *parser, ttc_claim *claim)
{
    size_t width = 0, column = 0;
    for (;;) {
        ttc_place place = ttc_token_place(ttc_parse_peek(parser));
        ttc_id id = ttc_parse_expression(parser);
        if (id == TTC_NONE || !ttc_parse_append(parser, &claim->entries, &claim->entry_count, id)) return false;
        column++;
        if (ttc_parse_accept_mark(parser, ',')) continue;
        if (width == 0) width = column;
        if (column != width) {
            claim->entry_count = 0; /* so that check_matrices does not report the matrix again */
            return ttc_parse_error(parser, place, "a row of %zu entries (expected %zu, as in the first row)", column, width);
        }
        column = 0;
        if (!ttc_parse_accept_mark(parser, ';')) return true;
    }
}

static bool parse_reduction(ttc_parser *parser, ttc_claim *claim)
{
    ttc_keyword direction = claim->kind == TTC_CLAIM_REDUCTION ? TTC_KEYWORD_ONTO : TTC_KEYWORD_INTO;
    return ttc_parse_expect_keyword(parser, direction, "':'") && ttc_parse_target_file(parser, &claim->target) &&
           ttc_parse_expect_keyword(parser, TTC_KEYWORD_WITH, "the table") &&
           ttc_parse_target_bindings(parser, &claim->bindings, &claim->target_names, "a state or root of the target");
}

/* The period as a number, in units of pi if *in_pi; TTC_NONE if it is neither a positive number nor one times pi. */
static ttc_id number_of_period(const ttc_model *model, ttc_id period, bool *in_pi)
{
    *in_pi = ttc_kind_of(model->graph, period) != TTC_NUMBER;
    for (size_t i = 0; *in_pi && i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_PI) period = ttc_divide(model->graph, period, model->symbols[i].node);
    if (period == TTC_NONE || ttc_kind_of(model->graph, period) != TTC_NUMBER) return TTC_NONE;
    return fmpq_sgn(ttc_coefficient(model->graph, period)) > 0 ? period : TTC_NONE;
}

/* The period after `periodic STATE =`. Makes the claim the symmetry STATE -> STATE + period. */
static bool parse_period(ttc_parser *parser, ttc_claim *claim)
{
    ttc_model *model = parser->model;
    const ttc_place place = ttc_token_place(ttc_parse_peek(parser));
    size_t i = 0;
    bool in_pi;
    while (i < model->state_count && strcmp(model->symbols[model->states[i]].name, claim->name) != 0) i++;
    if (i == model->state_count) return ttc_parse_error(parser, claim->place, "'%s' is not a state (expected one)", claim->name);
    const uint32_t symbol = model->states[i];
    const ttc_id period = ttc_parse_expression(parser);
    if (period == TTC_NONE) return false;
    const ttc_id number = number_of_period(model, period, &in_pi);
    ttc_symbol_entry *state = model->symbols + symbol;
    if (state->low != TTC_NONE || state->high != TTC_NONE)
        return ttc_parse_error(parser, claim->place, "'%s' has an interval, which a period leads out of", claim->name);
    if (number == TTC_NONE)
        return ttc_parse_error(parser, place, "not a period of '%s' (expected a positive number, or one times pi)", claim->name);
    state->period = number;
    state->in_pi = in_pi;
    const ttc_id image = ttc_add(model->graph, state->node, period);
    if (image == TTC_NONE || !TTC_ARRAY_GROW(claim->bindings.items, claim->bindings.count)) return ttc_parse_no_memory(parser);
    claim->bindings.items[claim->bindings.count++] = (ttc_binding){ symbol, image, place };
    return true;
}

/* The part of the record between the name and the clauses. */
static bool parse_body(ttc_parser *parser, ttc_claim *claim)
{
    size_t index = parser->model->claim_count;
    switch (claim->kind) {
    case TTC_CLAIM_OBSTRUCTS: return true;
    case TTC_CLAIM_REVERSOR:
    case TTC_CLAIM_SYMMETRY: return parse_map(parser, claim);
    case TTC_CLAIM_PERIODIC: return ttc_parse_expect_mark(parser, '=', "the state") && parse_period(parser, claim);
    case TTC_CLAIM_EQUILIBRIA:
        return ttc_parse_expect_mark(parser, ':', "the name") &&
               ttc_parse_bindings(parser, &claim->bindings, 1u << TTC_STATE, "a state");
    case TTC_CLAIM_LEFT_NULL:
        return ttc_parse_expect_mark(parser, ':', "the family") && parse_names(parser, TTC_REFER_MEMBER, index, "an integral");
    case TTC_CLAIM_REDUCTION:
        if (!ttc_parse_expect_mark(parser, ':', "the name")) return false;
        if (!ttc_parse_at_keyword(parser, TTC_KEYWORD_BY)) return parse_reduction(parser, claim);
        claim->kind = TTC_CLAIM_DESCENT;
        return ttc_parse_way(parser, claim);
    case TTC_CLAIM_EMBEDDING: return ttc_parse_expect_mark(parser, ':', "the name") && parse_reduction(parser, claim);
    case TTC_CLAIM_LIFT: return ttc_parse_expect_mark(parser, ':', "the name") && ttc_parse_way(parser, claim);
    case TTC_CLAIM_SECTION: return ttc_parse_expect_mark(parser, ':', "the name") && ttc_parse_section(parser, claim);
    case TTC_CLAIM_MATRIX: return ttc_parse_expect_mark(parser, '=', "the family") && parse_matrix(parser, claim);
    case TTC_CLAIM_POSITIVE:
        if (!ttc_parse_expect_mark(parser, ':', "the name")) return false;
        claim->expression = ttc_parse_expression(parser);
        return claim->expression != TTC_NONE;
    case TTC_CLAIM_EQUAL:
    case TTC_CLAIM_RATE:
        if (!ttc_parse_expect_mark(parser, ':', "the name") || (claim->expression = ttc_parse_expression(parser)) == TTC_NONE ||
            !ttc_parse_expect_mark(parser, '=', "the left side"))
            return false;
        claim->other = ttc_parse_expression(parser);
        return claim->other != TTC_NONE;
    default:
        if (!ttc_parse_expect_mark(parser, '=', "the name")) return false;
        parser->in_charpoly = claim->kind == TTC_CLAIM_CHARPOLY;
        claim->expression = ttc_parse_expression(parser);
        parser->in_charpoly = false;
        return claim->expression != TTC_NONE;
    }
}

/* The kind of claim that the keyword opens; of the two that `reduction` may open, the first. */
static ttc_claim_kind kind_of(ttc_keyword keyword)
{
    ttc_claim_kind kind = TTC_CLAIM_INTEGRAL;
    while (kind < TTC_CLAIM_LIFT && strcmp(ttc_claim_kind_name(kind), ttc_keyword_text(keyword)) != 0) kind++;
    return kind;
}

/* Report an error if the record itself sets a symbol that `when` sets. */
static bool check_set_once(ttc_parser *parser, const ttc_claim *claim)
{
    unsigned char *set = calloc(parser->model->symbol_count, 1);
    if (set == NULL) return ttc_parse_no_memory(parser);
    bool ok = true;
    for (size_t i = 0; i < claim->bindings.count; i++) set[claim->bindings.items[i].symbol] = 1;
    for (size_t i = 0; ok && i < claim->when.count; i++)
        if (set[claim->when.items[i].symbol])
            ok = ttc_parse_error(parser, claim->when.items[i].place, "'%s' is set twice",
                                 parser->model->symbols[claim->when.items[i].symbol].name);
    free(set);
    return ok;
}

/* Report an error if the claim's name is taken, or if a record about a family has the same kind as an earlier one about it. */
static bool check_name(ttc_parser *parser, const ttc_claim *claim, const ttc_token *name)
{
    const ttc_model *model = parser->model;
    if (model->claim_count >= TTC_SYMBOL_LIMIT)
        return ttc_parse_error(parser, claim->place, "too many claims (expected at most %d)", TTC_SYMBOL_LIMIT);
    for (size_t i = 0; i < model->claim_count; i++) {
        const ttc_claim *other = model->claims + i;
        bool rivals = ttc_claim_speaks_of_family(claim->kind)
                          ? other->kind == claim->kind
                          : !ttc_claim_speaks_of_family(other->kind) && !ttc_claim_is_unnamed(other);
        if (rivals && ttc_token_is(name, other->name))
            return ttc_parse_error(parser, ttc_token_place(name), "'%s' is claimed twice (first in line %u)", other->name,
                                   (unsigned)other->place.line);
    }
    return true;
}

/* Returns true if a name follows the keyword. That of a map is optional, with a colon after it. */
static bool has_name(const ttc_parser *parser, ttc_claim_kind kind)
{
    const ttc_token *token = ttc_parse_peek(parser);
    return !is_map(kind) || (token[0].kind == TTC_TOKEN_NAME && token[1].kind == TTC_TOKEN_MARK && token[1].text[0] == ':');
}

static bool parse_parts(ttc_parser *parser, const ttc_token *keyword, ttc_claim *claim)
{
    const ttc_token *name = has_name(parser, claim->kind) ? ttc_parse_name(parser, "the claim's name") : keyword;
    if (name == NULL) return false;
    if (name != keyword && claim->kind == TTC_CLAIM_REVERSOR)
        return ttc_parse_error(parser, ttc_token_place(name), "a reversor has no name (expected 'STATE -> expression')");
    claim->place = ttc_token_place(name);
    claim->name = ttc_parse_copy(parser, name->text, name->length);
    if (claim->name == NULL) return false;
    if (name != keyword && !check_name(parser, claim, name)) return false;
    if (name != keyword && is_map(claim->kind)) parser->at++; /* the colon */
    if (ttc_claim_speaks_of_family(claim->kind) && !ttc_parse_refer(parser, TTC_REFER_FAMILY, parser->model->claim_count, name))
        return false;
    if (!parse_body(parser, claim)) return false;
    if (is_clause_allowed(claim->kind) && !parse_clauses(parser, claim)) return false;
    if (!ttc_parse_check_circle(parser, &claim->when, &claim->when, NULL)) return false;
    if (claim->kind != TTC_CLAIM_EQUILIBRIA) return true;
    return check_set_once(parser, claim) &&
           ttc_parse_check_circle(parser, &claim->bindings, &claim->bindings, &claim->when);
}

/* A claim with an error is kept under its name, so that references to it are not reported as errors too. */
bool ttc_parse_claim(ttc_parser *parser, const ttc_token *keyword)
{
    ttc_model *model = parser->model;
    ttc_claim claim = { .kind = kind_of(keyword->keyword) };
    bool ok = parse_parts(parser, keyword, &claim);
    if (claim.name == NULL || model->claim_count >= TTC_SYMBOL_LIMIT || !TTC_ARRAY_GROW(model->claims, model->claim_count)) {
        ttc_claim_clear(&claim);
        return ok ? ttc_parse_no_memory(parser) : false;
    }
    model->claims[model->claim_count++] = claim;
    return ok;
}
