/* Maps of this table's points to those of another table: lists of that table's names, each with an expression in this one's. */
#include "read/parser.h"

static bool add_name(ttc_parser *parser, char ***names, size_t *count, const ttc_token *name)
{
    if (!TTC_ARRAY_GROW(*names, *count)) return ttc_parse_no_memory(parser);
    (*names)[*count] = ttc_parse_copy(parser, name->text, name->length);
    if ((*names)[*count] == NULL) return false;
    ++*count;
    return true;
}

static bool is_given(const ttc_image *image, const ttc_token *name)
{
    for (size_t i = 0; i < image->count + image->level_count; i++)
        if (ttc_token_is(name, i < image->count ? image->names[i] : image->levels[i - image->count])) return true;
    return false;
}

/* Returns true if the current token is a name that stands alone and is that of no quantity: it then means an integral. */
static bool at_integral(const ttc_parser *parser)
{
    const ttc_token *name = ttc_parse_peek(parser), *next = name + 1;
    uint32_t symbol;
    const bool alone = next->kind == TTC_TOKEN_END || next->kind == TTC_TOKEN_RECORD || next->kind == TTC_TOKEN_NAME ||
                       next->kind == TTC_TOKEN_KEYWORD || (next->kind == TTC_TOKEN_MARK && *next->text == ',');
    return name->kind == TTC_TOKEN_NAME && alone && !ttc_parse_find(parser, name, &symbol);
}

/* Determine the form that comes next, and read the word, atan2 or sqrt, that opens it. */
static ttc_given_form parse_form(ttc_parser *parser, unsigned forms)
{
    const ttc_token *token = ttc_parse_peek(parser);
    uint32_t symbol;
    ttc_given_form form = TTC_GIVEN_PLAIN;
    if (ttc_parse_at_keyword(parser, TTC_KEYWORD_ATAN2) && !ttc_parse_find(parser, token, &symbol)) form = TTC_GIVEN_ANGLE;
    else if (ttc_parse_at_keyword(parser, TTC_KEYWORD_SQRT)) form = TTC_GIVEN_ROOT;
    if ((forms & 1u << form) == 0) return TTC_GIVEN_PLAIN; /* parsing it as an expression reports the error */
    parser->at += form != TTC_GIVEN_PLAIN;
    return form;
}

/* expr, atan2(expr, expr) or sqrt(expr). Adds two entries to the claim. */
static bool parse_entries(ttc_parser *parser, ttc_claim *claim, unsigned forms, ttc_given_form *form)
{
    ttc_id pair[2] = { TTC_NONE, ttc_integer(parser->model->graph, 1) };
    *form = parse_form(parser, forms);
    const char *word = *form == TTC_GIVEN_ANGLE ? "atan2" : "sqrt";
    if (*form != TTC_GIVEN_PLAIN && !ttc_parse_expect_mark(parser, '(', word)) return false;
    pair[0] = ttc_parse_expression(parser);
    if (pair[0] == TTC_NONE) return false;
    if (*form == TTC_GIVEN_ANGLE) {
        if (!ttc_parse_expect_mark(parser, ',', "what is in proportion to the sine")) return false;
        pair[1] = ttc_parse_expression(parser);
        if (pair[1] == TTC_NONE || !ttc_parse_expect_mark(parser, ')', "what is in proportion to the cosine")) return false;
    }
    if (*form == TTC_GIVEN_ROOT && !ttc_parse_expect_mark(parser, ')', "the argument")) return false;
    if (pair[1] == TTC_NONE) return ttc_parse_no_memory(parser);
    return ttc_parse_append(parser, &claim->entries, &claim->entry_count, pair[0]) &&
           ttc_parse_append(parser, &claim->entries, &claim->entry_count, pair[1]);
}

bool ttc_parse_image(ttc_parser *parser, ttc_image *image, ttc_claim *claim, unsigned forms, const char *expected)
{
    const bool has_levels = forms != 1u << TTC_GIVEN_PLAIN;
    do {
        const ttc_token *name = ttc_parse_name(parser, expected);
        ttc_given_form form;
        if (name == NULL || !ttc_parse_expect_mark(parser, '=', "the name")) return false;
        if (is_given(image, name))
            return ttc_parse_error(parser, ttc_token_place(name), "'%.*s' is set twice", (int)name->length, name->text);
        if (has_levels && at_integral(parser)) {
            const ttc_token *integral = parser->tokens + parser->at++;
            if (!add_name(parser, &image->levels, &image->level_count, name) ||
                !ttc_parse_refer(parser, TTC_REFER_MEMBER, parser->model->claim_count, integral))
                return false;
            continue;
        }
        if (image->count >= TTC_STATE_LIMIT)
            return ttc_parse_error(parser, ttc_token_place(name), "too many coordinates (expected at most %d)",
                                   TTC_STATE_LIMIT);
        if (!TTC_ARRAY_GROW(image->forms, image->count)) return ttc_parse_no_memory(parser);
        if (!parse_entries(parser, claim, forms, &form)) return false;
        image->forms[image->count] = form;
        if (!add_name(parser, &image->names, &image->count, name)) return false;
    } while (ttc_parse_accept_mark(parser, ','));
    return true;
}
