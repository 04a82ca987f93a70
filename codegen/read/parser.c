/* Functions that parse records of all kinds: reading tokens, reporting errors, copying text. */
#include "read/parser.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

ttc_place ttc_token_place(const ttc_token *token) { return (ttc_place){ token->line, token->column }; }

const ttc_token *ttc_parse_peek(const ttc_parser *parser) { return parser->tokens + parser->at; }

bool ttc_parse_at_mark(const ttc_parser *parser, char mark)
{
    const ttc_token *token = ttc_parse_peek(parser);
    return token->kind == TTC_TOKEN_MARK && token->text[0] == mark;
}

bool ttc_parse_at_keyword(const ttc_parser *parser, ttc_keyword keyword)
{
    const ttc_token *token = ttc_parse_peek(parser);
    return (token->kind == TTC_TOKEN_KEYWORD || token->kind == TTC_TOKEN_NAME) && token->keyword == keyword;
}

bool ttc_parse_accept_mark(ttc_parser *parser, char mark)
{
    if (!ttc_parse_at_mark(parser, mark)) return false;
    parser->at++;
    return true;
}

bool ttc_parse_accept_keyword(ttc_parser *parser, ttc_keyword keyword)
{
    if (!ttc_parse_at_keyword(parser, keyword)) return false;
    parser->at++;
    return true;
}

bool ttc_parse_error(ttc_parser *parser, ttc_place place, const char *format, ...)
{
    char message[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    ttc_report(parser->diagnostics, TTC_ERROR, place.line, place.column, "%s", message);
    return false;
}

bool ttc_parse_no_memory(ttc_parser *parser)
{
    parser->out_of_memory = true;
    return false;
}

bool ttc_parse_append(ttc_parser *parser, uint32_t **list, size_t *count, uint32_t index)
{
    if (!TTC_ARRAY_GROW(*list, *count)) return ttc_parse_no_memory(parser);
    (*list)[(*count)++] = index;
    return true;
}

ttc_id ttc_parse_graph_error(ttc_parser *parser, ttc_place place)
{
    ttc_graph_status status = ttc_graph_error(parser->model->graph);
    ttc_graph_clear_error(parser->model->graph);
    if (status == TTC_GRAPH_NO_MEMORY || status == TTC_GRAPH_OK) ttc_parse_no_memory(parser);
    else ttc_parse_error(parser, place, "%s", ttc_graph_status_text(status));
    return TTC_NONE;
}

static ttc_place place_after(const ttc_token *token)
{
    bool enclosed = token->kind == TTC_TOKEN_STRING || token->kind == TTC_TOKEN_UNIT;
    return (ttc_place){ token->line, token->column + token->length + (enclosed ? 2 : 0) };
}

bool ttc_parse_unexpected(ttc_parser *parser, const char *expected)
{
    const ttc_token *token = ttc_parse_peek(parser);
    ttc_place place = ttc_token_place(token);
    int length = token->length > 40 ? 40 : (int)token->length;
    switch (token->kind) {
    case TTC_TOKEN_BAD: return false;
    case TTC_TOKEN_END:
        return ttc_parse_error(parser, place_after(token - 1), "the table ends within a record (expected %s)", expected);
    case TTC_TOKEN_RECORD:
        return ttc_parse_error(parser, place_after(token - 1), "the record ends too early (expected %s)", expected);
    case TTC_TOKEN_KEYWORD:
        return ttc_parse_error(parser, place, "'%.*s' is a keyword and names nothing (expected %s)", length, token->text,
                               expected);
    case TTC_TOKEN_STRING: return ttc_parse_error(parser, place, "unexpected text in quotes (expected %s)", expected);
    case TTC_TOKEN_UNIT: return ttc_parse_error(parser, place, "unexpected unit (expected %s)", expected);
    default: return ttc_parse_error(parser, place, "unexpected '%.*s' (expected %s)", length, token->text, expected);
    }
}

bool ttc_parse_expect_mark(ttc_parser *parser, char mark, const char *after)
{
    if (ttc_parse_accept_mark(parser, mark)) return true;
    char expected[80];
    snprintf(expected, sizeof expected, "'%c' after %s", mark, after);
    return ttc_parse_unexpected(parser, expected);
}

bool ttc_parse_expect_keyword(ttc_parser *parser, ttc_keyword keyword, const char *after)
{
    if (ttc_parse_accept_keyword(parser, keyword)) return true;
    char expected[80];
    snprintf(expected, sizeof expected, "'%s' after %s", ttc_keyword_text(keyword), after);
    return ttc_parse_unexpected(parser, expected);
}

const ttc_token *ttc_parse_name(ttc_parser *parser, const char *what)
{
    const ttc_token *token = ttc_parse_peek(parser);
    if (token->kind == TTC_TOKEN_NAME) {
        parser->at++;
        return token;
    }
    ttc_parse_unexpected(parser, what);
    return NULL;
}

bool ttc_parse_record_end(ttc_parser *parser)
{
    const ttc_token *token = ttc_parse_peek(parser);
    if (token->kind == TTC_TOKEN_RECORD || token->kind == TTC_TOKEN_END) return true;
    return ttc_parse_unexpected(parser, "the end of the record");
}

char *ttc_parse_copy(ttc_parser *parser, const char *text, size_t length)
{
    char *copy = malloc(length + 1);
    if (copy == NULL) {
        ttc_parse_no_memory(parser);
        return NULL;
    }
    memcpy(copy, text, length);
    copy[length] = '\0';
    return copy;
}

char *ttc_parse_text_since(ttc_parser *parser, size_t first)
{
    const ttc_token *tokens = parser->tokens;
    size_t size = 1;
    for (size_t i = first; i < parser->at; i++) size += tokens[i].length + 1;
    char *text = malloc(size), *at = text;
    if (text == NULL) {
        ttc_parse_no_memory(parser);
        return NULL;
    }
    for (size_t i = first; i < parser->at; i++) {
        if (i > first && tokens[i].text != tokens[i - 1].text + tokens[i - 1].length) *at++ = ' ';
        memcpy(at, tokens[i].text, tokens[i].length);
        at += tokens[i].length;
    }
    *at = '\0';
    return text;
}
