/* The lexer: cuts the text of a table into tokens, and marks where records begin. */
#include "read/token.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

#define TTC_KEYWORD_TEXT(name, text) [TTC_KEYWORD_##name] = text,
static const char *const keyword_texts[TTC_KEYWORD_NONE + 1] = {
    TTC_RECORD_LIST(TTC_KEYWORD_TEXT) TTC_CLAUSE_LIST(TTC_KEYWORD_TEXT)
    [TTC_KEYWORD_NONE] = ""
};

typedef struct {
    const char *at, *end, *line_start;
    uint32_t line;
    ttc_diagnostics *diagnostics;
    ttc_token *tokens;
    size_t count;
    bool line_opens; /* the line has no token so far */
} lexer;

const char *ttc_keyword_text(ttc_keyword keyword) { return keyword_texts[keyword]; }

static bool is_digit(char c) { return c >= '0' && c <= '9'; }
static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
static bool is_word(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

static ttc_keyword find_keyword(const char *text, size_t length)
{
    for (int k = 0; k < TTC_KEYWORD_NONE; k++)
        if (strlen(keyword_texts[k]) == length && memcmp(keyword_texts[k], text, length) == 0) return (ttc_keyword)k;
    return TTC_KEYWORD_NONE;
}

/* Keywords that are not reserved: where they open no record or clause they are free as names. */
static const bool is_soft[TTC_KEYWORD_NONE + 1] = {
    [TTC_KEYWORD_MATRIX] = true, [TTC_KEYWORD_LEFTNULL] = true, [TTC_KEYWORD_REDUCTION] = true, [TTC_KEYWORD_RATE] = true,
    [TTC_KEYWORD_POSITIVE] = true, [TTC_KEYWORD_DOMAIN] = true, [TTC_KEYWORD_EMBEDDING] = true, [TTC_KEYWORD_INTO] = true,
    [TTC_KEYWORD_SYMMETRY] = true, [TTC_KEYWORD_EXP] = true, [TTC_KEYWORD_LOG] = true, [TTC_KEYWORD_OBSERVE] = true,
    [TTC_KEYWORD_VALID] = true, [TTC_KEYWORD_PERIODIC] = true, [TTC_KEYWORD_POLE] = true, [TTC_KEYWORD_SECTION] = true,
    [TTC_KEYWORD_LIFT] = true, [TTC_KEYWORD_START] = true, [TTC_KEYWORD_TURNS] = true, [TTC_KEYWORD_TIER] = true,
    [TTC_KEYWORD_WHERE] = true, [TTC_KEYWORD_WHILE] = true, [TTC_KEYWORD_AT] = true, [TTC_KEYWORD_BESIDE] = true,
    [TTC_KEYWORD_ENDING] = true, [TTC_KEYWORD_ATAN2] = true, [TTC_KEYWORD_MODULO] = true, [TTC_KEYWORD_ONTO] = true,
    [TTC_KEYWORD_WITH] = true,
};

static uint32_t column_of(const lexer *l, const char *at) { return (uint32_t)(at - l->line_start) + 1; }

static bool push(lexer *l, ttc_token_kind kind, ttc_keyword keyword, const char *start, const char *text, size_t length)
{
    if (!TTC_ARRAY_GROW(l->tokens, l->count)) return false;
    l->tokens[l->count++] = (ttc_token){ kind, keyword, l->line, column_of(l, start), (uint32_t)length, text };
    return true;
}

static char peek(const lexer *l, size_t ahead) { return (size_t)(l->end - l->at) > ahead ? l->at[ahead] : '\0'; }

/* Skip the rest of the line, and put a token BAD in its place. */
static bool push_bad(lexer *l, const char *start)
{
    const char *stop = memchr(l->at, '\n', (size_t)(l->end - l->at));
    l->at = stop == NULL ? l->end : stop;
    return push(l, TTC_TOKEN_BAD, TTC_KEYWORD_NONE, start, start, (size_t)(l->at - start));
}

static size_t word_length(const lexer *l)
{
    const char *stop = l->at;
    while (stop < l->end && is_word(*stop)) stop++;
    return (size_t)(stop - l->at);
}

/* Returns true if the word opens a record: a keyword of a record, first in its line. One that is not reserved must be followed by a
 * letter; within an expression an operator follows a name. */
static bool opens_record(const lexer *l, ttc_keyword keyword, size_t length)
{
    if (!l->line_opens || keyword >= TTC_RECORD_COUNT) return false;
    const char *next = l->at + length;
    while (next < l->end && (*next == ' ' || *next == '\t')) next++;
    return !is_soft[keyword] || (next < l->end && is_letter(*next));
}

static bool lex_word(lexer *l)
{
    const char *start = l->at;
    size_t length = word_length(l);
    ttc_keyword keyword = find_keyword(start, length);
    bool opens = opens_record(l, keyword, length);
    l->at += length;
    if (keyword != TTC_KEYWORD_NONE) {
        ttc_token_kind kind = opens ? TTC_TOKEN_RECORD : is_soft[keyword] ? TTC_TOKEN_NAME : TTC_TOKEN_KEYWORD;
        return push(l, kind, keyword, start, start, length);
    }
    if (length > TTC_NAME_LIMIT) {
        ttc_report(l->diagnostics, TTC_ERROR, l->line, column_of(l, start), "a name of %zu characters (expected at most %d)",
                   length, TTC_NAME_LIMIT);
        return push_bad(l, start);
    }
    return push(l, TTC_TOKEN_NAME, TTC_KEYWORD_NONE, start, start, length);
}

/* digits [. digits] [e [+-] digits] */
static bool lex_number(lexer *l)
{
    const char *start = l->at, *wrong = NULL;
    while (is_digit(peek(l, 0))) l->at++;
    if (peek(l, 0) == '.') {
        l->at++;
        if (!is_digit(peek(l, 0))) wrong = "digits after the decimal point";
        while (is_digit(peek(l, 0))) l->at++;
    }
    if (wrong == NULL && (peek(l, 0) == 'e' || peek(l, 0) == 'E')) {
        size_t sign = peek(l, 1) == '+' || peek(l, 1) == '-' ? 1 : 0;
        if (is_digit(peek(l, 1 + sign))) {
            l->at += 1 + sign;
            while (is_digit(peek(l, 0))) l->at++;
        }
    }
    if (wrong == NULL && is_word(peek(l, 0))) wrong = "an operator between a number and a name, such as 2*x";
    if (wrong != NULL) {
        ttc_report(l->diagnostics, TTC_ERROR, l->line, column_of(l, l->at), "malformed number (expected %s)", wrong);
        return push_bad(l, start);
    }
    return push(l, TTC_TOKEN_NUMBER, TTC_KEYWORD_NONE, start, start, (size_t)(l->at - start));
}

/* Free text up to `close` on the same line. */
static bool lex_enclosed(lexer *l, char close, ttc_token_kind kind, const char *what)
{
    const char *start = l->at++;
    const char *text = l->at;
    while (l->at < l->end && *l->at != close && *l->at != '\n') l->at++;
    if (l->at == l->end || *l->at == '\n') {
        ttc_report(l->diagnostics, TTC_ERROR, l->line, column_of(l, start), "%s is not closed (expected '%c' on the same line)",
                   what, close);
        return push(l, TTC_TOKEN_BAD, TTC_KEYWORD_NONE, start, start, (size_t)(l->at - start));
    }
    return push(l, kind, TTC_KEYWORD_NONE, start, text, (size_t)(l->at++ - text));
}

static bool lex_pair(lexer *l, ttc_token_kind kind)
{
    l->at += 2;
    return push(l, kind, TTC_KEYWORD_NONE, l->at - 2, l->at - 2, 2);
}

static bool lex_mark(lexer *l)
{
    static const char marks[] = "+-*/^()=,:;>.";
    const char *start = l->at;
    char c = *start, next = peek(l, 1);
    const char *hint = "";
    if (c == '-' && next == '>') return lex_pair(l, TTC_TOKEN_ARROW);
    if (c == '>' && next == '=') return lex_pair(l, TTC_TOKEN_AT_LEAST);
    if (c == '!' && next == '=') return lex_pair(l, TTC_TOKEN_NOT_EQUAL);
    if (c == '*' && next == '*') hint = " (a power is written ^)";
    else if (c == '.' && is_digit(next)) hint = " (a number opens with a digit: 0.5)";
    else if (c == '<') hint = " (a condition is written with >: 1 - x > 0)";
    else if (strchr(marks, c) != NULL) {
        l->at++;
        return push(l, TTC_TOKEN_MARK, TTC_KEYWORD_NONE, start, start, 1);
    }
    if ((unsigned char)c >= 0x80)
        ttc_report(l->diagnostics, TTC_ERROR, l->line, column_of(l, start),
                   "a character outside ASCII (expected only in comments and in \"...\")");
    else
        ttc_report(l->diagnostics, TTC_ERROR, l->line, column_of(l, start), "unexpected '%c'%s", c, hint);
    return push_bad(l, start);
}

/* Called at the first token of a line. Reports a line that neither opens a record nor is indented, and begins a RECORD of keyword
 * NONE with it. Returns false when memory is out. */
static bool open_line(lexer *l)
{
    size_t length = word_length(l);
    if (l->at > l->line_start || opens_record(l, find_keyword(l->at, length), length)) return true;
    ttc_report(l->diagnostics, TTC_ERROR, l->line, 1, "'%.*s' opens no record (expected a keyword, or an indented line that "
               "continues the record above)", length == 0 ? 1 : (int)(length > 40 ? 40 : length), l->at);
    return push(l, TTC_TOKEN_RECORD, TTC_KEYWORD_NONE, l->at, l->at, length);
}

static bool lex_token(lexer *l)
{
    char c = *l->at;
    if (l->line_opens && !open_line(l)) return false;
    bool ok = is_letter(c)   ? lex_word(l)
              : is_digit(c) ? lex_number(l)
              : c == '"'    ? lex_enclosed(l, '"', TTC_TOKEN_STRING, "a text")
              : c == '['    ? lex_enclosed(l, ']', TTC_TOKEN_UNIT, "a unit")
                            : lex_mark(l);
    l->line_opens = false;
    return ok;
}

ttc_token *ttc_lex(const char *text, size_t length, ttc_diagnostics *diagnostics)
{
    lexer l = { .at = text, .end = text + length, .line_start = text, .line = 1, .diagnostics = diagnostics,
                .line_opens = true };
    bool ok = true;
    while (ok && l.at < l.end) {
        char c = *l.at;
        if (c == '\n') {
            l.line_start = ++l.at;
            l.line++;
            l.line_opens = true;
        } else if (c == ' ' || c == '\t') {
            l.at++;
        } else if (c == '#') {
            while (l.at < l.end && *l.at != '\n') l.at++;
        } else {
            ok = lex_token(&l);
        }
    }
    ok = ok && push(&l, TTC_TOKEN_END, TTC_KEYWORD_NONE, l.at, l.at, 0);
    if (ok) return l.tokens;
    free(l.tokens);
    return NULL;
}
