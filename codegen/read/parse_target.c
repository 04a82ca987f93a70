/* References to another table: the name of its file, and lists of its names with expressions in this table's names. */
#include "read/parser.h"

#include <string.h>

/* FILE.tt as names joined by dots, or as a text in quotes. */
bool ttc_parse_target_file(ttc_parser *parser, char **file)
{
    const ttc_token *first = ttc_parse_peek(parser);
    const char *end = first->text;
    if (first->kind == TTC_TOKEN_STRING) {
        parser->at++;
        end = first->text + first->length;
    } else {
        const ttc_token *token = first;
        while (token->kind == TTC_TOKEN_NAME || (token->kind == TTC_TOKEN_MARK && *token->text == '.')) {
            if (token > first && token->text != end) break;
            end = token->text + token->length;
            token = parser->tokens + ++parser->at;
        }
    }
    size_t length = (size_t)(end - first->text);
    if (length == 0) return ttc_parse_unexpected(parser, "FILE.tt, beside this one");
    bool plain = length > 3 && memcmp(end - 3, ".tt", 3) == 0 && first->text[0] != '.' &&
                 memchr(first->text, '/', length) == NULL && memchr(first->text, '\\', length) == NULL;
    if (!plain)
        return ttc_parse_error(parser, ttc_token_place(first), "not the name of a table (expected FILE.tt, beside this one)");
    *file = ttc_parse_copy(parser, first->text, length);
    return *file != NULL;
}

bool ttc_parse_target_bindings(ttc_parser *parser, ttc_bindings *bindings, char ***names, const char *expected)
{
    do {
        const ttc_token *name = ttc_parse_name(parser, expected);
        if (name == NULL || !ttc_parse_expect_mark(parser, '=', "the name")) return false;
        if (bindings->count >= TTC_SYMBOL_LIMIT)
            return ttc_parse_error(parser, ttc_token_place(name), "too many names are set (expected at most %d)",
                                   TTC_SYMBOL_LIMIT);
        for (size_t i = 0; i < bindings->count; i++)
            if (ttc_token_is(name, (*names)[i]))
                return ttc_parse_error(parser, ttc_token_place(name), "'%.*s' is set twice", (int)name->length, name->text);
        ttc_id expression = ttc_parse_expression(parser);
        if (expression == TTC_NONE) return false;
        size_t count = bindings->count;
        if (!TTC_ARRAY_GROW(bindings->items, count) || !TTC_ARRAY_GROW(*names, count)) return ttc_parse_no_memory(parser);
        (*names)[count] = ttc_parse_copy(parser, name->text, name->length);
        if ((*names)[count] == NULL) return false;
        bindings->items[count] = (ttc_binding){ 0, expression, ttc_token_place(name) };
        bindings->count++;
    } while (ttc_parse_accept_mark(parser, ','));
    return true;
}
