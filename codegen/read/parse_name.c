/* Names: finding and defining symbols, references to claims, and error messages about unknown names. */
#include "read/parser.h"

#include <stdlib.h>
#include <string.h>

static uint32_t hash_name(const char *text, size_t length)
{
    uint32_t hash = 2166136261u; /* FNV-1a */
    for (size_t i = 0; i < length; i++) hash = (hash ^ (unsigned char)text[i]) * 16777619u;
    return hash;
}

bool ttc_token_is(const ttc_token *token, const char *name)
{
    return strlen(name) == token->length && memcmp(name, token->text, token->length) == 0;
}

bool ttc_parse_find(const ttc_parser *parser, const ttc_token *name, uint32_t *symbol)
{
    uint32_t hash = hash_name(name->text, name->length);
    for (size_t i = 1; i < parser->model->symbol_count; i++)
        if (parser->hashes[i] == hash && ttc_token_is(name, parser->model->symbols[i].name)) {
            *symbol = (uint32_t)i;
            return true;
        }
    return false;
}

static bool append_symbol(ttc_parser *parser, ttc_symbol_entry entry, uint32_t hash)
{
    ttc_model *model = parser->model;
    size_t count = model->symbol_count;
    if (!TTC_ARRAY_GROW(model->symbols, count) || !TTC_ARRAY_GROW(parser->hashes, count) || !TTC_ARRAY_GROW(parser->used, count))
        return ttc_parse_no_memory(parser);
    model->symbols[count] = entry;
    parser->hashes[count] = hash;
    parser->used[count] = 0;
    model->symbol_count++;
    return true;
}

/* A definition with an error is TTC_NONE; its name is defined nevertheless, as a parameter, so that its uses are no errors. */
bool ttc_parse_define(ttc_parser *parser, const ttc_token *name, ttc_symbol_kind kind, ttc_id definition, uint32_t *symbol)
{
    ttc_model *model = parser->model;
    if (kind != TTC_LAMBDA && ttc_parse_find(parser, name, symbol))
        return ttc_parse_error(parser, ttc_token_place(name), "'%.*s' is defined twice (first in line %u)", (int)name->length,
                               name->text, (unsigned)model->symbols[*symbol].place.line);
    if (model->symbol_count > TTC_SYMBOL_LIMIT) /* symbol 0 is lambda */
        return ttc_parse_error(parser, ttc_token_place(name), "too many names (expected at most %d)", TTC_SYMBOL_LIMIT);
    ttc_symbol_entry entry = { .kind = kind, .place = ttc_token_place(name), .definition = definition };
    *symbol = (uint32_t)model->symbol_count;
    if (definition == TTC_NONE && (kind == TTC_LET || kind == TTC_ROOT || kind == TTC_EXP || kind == TTC_LOG))
        entry.kind = TTC_PARAM;
    entry.node = ttc_symbol(model->graph, *symbol);
    if (entry.node == TTC_NONE) {
        ttc_parse_graph_error(parser, entry.place);
        return false;
    }
    entry.name = ttc_parse_copy(parser, name->text, name->length);
    if (entry.name == NULL) return false;
    if (append_symbol(parser, entry, hash_name(name->text, name->length))) return true;
    free(entry.name);
    return false;
}

static bool defines_quantity(ttc_keyword keyword)
{
    switch (keyword) {
    case TTC_KEYWORD_PARAM:
    case TTC_KEYWORD_STATE:
    case TTC_KEYWORD_ROOT:
    case TTC_KEYWORD_ANGLE:
    case TTC_KEYWORD_EXP:
    case TTC_KEYWORD_LOG:
    case TTC_KEYWORD_LET: return true;
    default: return false;
    }
}

/* The token at which a record of the table defines the name, also further down; NULL if none does. */
static const ttc_token *find_definition(const ttc_parser *parser, const ttc_token *name)
{
    for (const ttc_token *t = parser->tokens; t->kind != TTC_TOKEN_END; t++) {
        bool defines = t->kind == TTC_TOKEN_RECORD && defines_quantity(t->keyword);
        for (int i = 1; defines && i <= (t->keyword == TTC_KEYWORD_ANGLE ? 2 : 1); i++) {
            if (t[i].kind != TTC_TOKEN_NAME) break;
            if (t[i].length == name->length && memcmp(t[i].text, name->text, name->length) == 0) return t + i;
        }
    }
    return NULL;
}

static const ttc_token *record_of(const ttc_token *token)
{
    while (token->kind != TTC_TOKEN_RECORD) token--;
    return token;
}

static bool is_infinity(const ttc_token *name)
{
    static const char *const words[] = { "inf", "Inf", "INF", "infinity", "Infinity", "oo" };
    bool is = false;
    for (size_t i = 0; !is && i < sizeof words / sizeof *words; i++) is = ttc_token_is(name, words[i]);
    return is;
}

void ttc_parse_unknown(ttc_parser *parser, const ttc_token *name)
{
    ttc_place place = ttc_token_place(name);
    int length = (int)name->length;
    const char *text = name->text, *near = NULL;
    bool searched = ttc_error_count(parser->diagnostics) < TTC_DIAGNOSTIC_LIMIT;
    const ttc_token *definition = searched ? find_definition(parser, name) : NULL;
    if (definition != NULL && record_of(definition) == record_of(name)) {
        ttc_parse_error(parser, place, "'%.*s' stands for itself (expected names that stand above)", length, text);
    } else if (definition != NULL && definition > name) {
        ttc_parse_error(parser, place, "'%.*s' is used before line %u defines it (expected names that stand above, so that no "
                        "circle arises)", length, text, (unsigned)definition->line);
    } else if (definition != NULL) {
        ttc_parse_error(parser, place, "'%.*s' has no meaning, as its record in line %u is wrong", length, text,
                        (unsigned)definition->line);
    } else if (ttc_token_is(name, "lambda")) {
        ttc_parse_error(parser, place, "'lambda' is the indeterminate of 'charpoly' and means nothing elsewhere (expected "
                        "another name)");
    } else if (is_infinity(name)) {
        ttc_parse_error(parser, place, "unknown name '%.*s' (expected 'inf' or '-inf', alone, as an end of a state's interval)",
                        length, text);
    } else {
        for (size_t i = 1; searched && near == NULL && i < parser->model->symbol_count; i++)
            if (ttc_text_resembles(parser->model->symbols[i].name, strlen(parser->model->symbols[i].name), text, name->length))
                near = parser->model->symbols[i].name;
        ttc_parse_error(parser, place, "unknown name '%.*s' (expected a name defined above%s%s%s)", length, text,
                        near == NULL ? "" : "; did you mean '", near == NULL ? "" : near, near == NULL ? "" : "'?");
    }
}

bool ttc_parse_known(ttc_parser *parser, const ttc_token *name, uint32_t *symbol)
{
    const bool found = ttc_parse_find(parser, name, symbol);
    if (!found) ttc_parse_unknown(parser, name);
    return found;
}

bool ttc_parse_pi(ttc_parser *parser, const ttc_token *name, uint32_t *symbol)
{
    if (!ttc_token_is(name, "pi") || find_definition(parser, name) != NULL) return false;
    return ttc_parse_define(parser, name, TTC_PI, TTC_NONE, symbol);
}

bool ttc_parse_refer(ttc_parser *parser, ttc_reference_role role, size_t owner, const ttc_token *name)
{
    if (parser->reference_count >= TTC_REFERENCE_LIMIT)
        return ttc_parse_error(parser, ttc_token_place(name), "too many names of claims (expected at most %d)",
                               TTC_REFERENCE_LIMIT);
    if (!TTC_ARRAY_GROW(parser->references, parser->reference_count)) return ttc_parse_no_memory(parser);
    parser->references[parser->reference_count++] = (ttc_reference){ role, owner, name };
    return true;
}
