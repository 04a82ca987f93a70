/* Records about tables that serve in place of each other: `tier`, `reduction NAME : by` and `lift NAME : into`. */
#include "read/parser.h"

/* EXPR > 0, ... */
static bool parse_inequalities(ttc_parser *parser, ttc_inequalities *list, const char *rule)
{
    do {
        const size_t first = parser->at;
        if (list->count >= TTC_REGION_LIMIT)
            return ttc_parse_error(parser, ttc_token_place(ttc_parse_peek(parser)), "too many conditions (expected at most %d)",
                                   TTC_REGION_LIMIT);
        const ttc_id expression = ttc_parse_expression(parser);
        if (expression == TTC_NONE || !ttc_parse_positive(parser, rule)) return false;
        if (!TTC_ARRAY_GROW(list->items, list->count)) return ttc_parse_no_memory(parser);
        list->items[list->count] = (ttc_inequality){ expression, ttc_parse_text_since(parser, first) };
        if (list->items[list->count++].text == NULL) return false;
    } while (ttc_parse_accept_mark(parser, ','));
    return true;
}

/* by FILE.tt with NAME = expr | atan2(expr, expr) | sqrt(expr) | INTEGRAL, ... [when PARAM = expr, ...] [where EXPR > 0,
 * ...], or into FILE.tt with NAME = expr, ... [where EXPR > 0, ...] */
bool ttc_parse_way(ttc_parser *parser, ttc_claim *claim)
{
    const bool descends = claim->kind == TTC_CLAIM_DESCENT;
    const unsigned forms = 1u << TTC_GIVEN_PLAIN | (descends ? 1u << TTC_GIVEN_ANGLE | 1u << TTC_GIVEN_ROOT : 0u);
    ttc_model *model = parser->model;
    if (!TTC_ARRAY_GROW(model->ways, model->way_count)) return ttc_parse_no_memory(parser);
    ttc_way *way = model->ways + model->way_count++;
    *way = (ttc_way){ .claim = (uint32_t)model->claim_count };
    if (!ttc_parse_expect_keyword(parser, descends ? TTC_KEYWORD_BY : TTC_KEYWORD_INTO, "':'") ||
        !ttc_parse_target_file(parser, &claim->target) || !ttc_parse_expect_keyword(parser, TTC_KEYWORD_WITH, "the table") ||
        !ttc_parse_image(parser, &way->image, claim, forms,
                         descends ? "a state or parameter of the table" : "a state, root or parameter of the table"))
        return false;
    if (descends && ttc_parse_accept_keyword(parser, TTC_KEYWORD_WHEN)) {
        if (!ttc_parse_bindings(parser, &claim->when, 1u << TTC_PARAM, "a parameter")) return false;
        ttc_parse_check_constants(parser, &claim->when);
    }
    way->where_divisors = parser->divisor_count;
    way->where_uses = parser->use_count;
    return !ttc_parse_accept_keyword(parser, TTC_KEYWORD_WHERE) ||
           parse_inequalities(parser, &way->where, "a way serves where an expression is > 0");
}

/* NAME [while EXPR > 0, ...] "meaning" */
bool ttc_parse_tier(ttc_parser *parser, const ttc_token *keyword)
{
    ttc_tier *tier = &parser->model->tier;
    if (tier->name != NULL)
        return ttc_parse_error(parser, ttc_token_place(keyword), "a second tier (first in line %u)",
                               (unsigned)tier->place.line);
    const ttc_token *name = ttc_parse_name(parser, "what the table is called among those that serve in its place");
    if (name == NULL) return false;
    tier->place = ttc_token_place(name);
    tier->name = ttc_parse_copy(parser, name->text, name->length);
    if (tier->name == NULL) return false;
    if (ttc_parse_accept_keyword(parser, TTC_KEYWORD_WHILE) &&
        !parse_inequalities(parser, &tier->conditions, "coordinates are good while an expression is > 0"))
        return false;
    if (ttc_parse_peek(parser)->kind != TTC_TOKEN_STRING) return ttc_parse_unexpected(parser, "a text in quotes");
    return ttc_parse_meaning(parser, &tier->meaning);
}
