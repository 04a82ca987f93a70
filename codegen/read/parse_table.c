/* Parsing a whole table: its records one by one, then the checks that need all of them. */
#include "read/parser.h"

#include <stdlib.h>
#include <string.h>

#include "base/sha256.h"
#include "base/source.h"

static bool parse_model(ttc_parser *parser, const ttc_token *keyword)
{
    if (parser->model->name != NULL)
        return ttc_parse_error(parser, ttc_token_place(keyword), "a second model (expected one model a file)");
    const ttc_token *name = ttc_parse_name(parser, "the model's name");
    if (name == NULL) return false;
    parser->model->name = ttc_parse_copy(parser, name->text, name->length);
    return parser->model->name != NULL;
}

/* Returns true for `lift NAME :`, a claim about a larger model; a lift without a name belongs to a table of coordinates. */
static bool is_named(const ttc_parser *parser)
{
    const ttc_token *token = ttc_parse_peek(parser);
    return token[0].kind == TTC_TOKEN_NAME && token[1].kind == TTC_TOKEN_MARK && token[1].text[0] == ':';
}

static bool parse_record(ttc_parser *parser, const ttc_token *keyword)
{
    switch (keyword->keyword) {
    case TTC_KEYWORD_MODEL: return parse_model(parser, keyword);
    case TTC_KEYWORD_TITLE:
    case TTC_KEYWORD_SOURCE: return ttc_parse_title(parser, keyword);
    case TTC_KEYWORD_PARAM:
    case TTC_KEYWORD_STATE:
    case TTC_KEYWORD_ROOT:
    case TTC_KEYWORD_ANGLE:
    case TTC_KEYWORD_EXP:
    case TTC_KEYWORD_LOG:
    case TTC_KEYWORD_LET: return ttc_parse_quantity(parser, keyword);
    case TTC_KEYWORD_EQ: return ttc_parse_equation(parser);
    case TTC_KEYWORD_DEFAULT: return ttc_parse_default(parser);
    case TTC_KEYWORD_VARIANT:
    case TTC_KEYWORD_TIME:
    case TTC_KEYWORD_ELIMINATE: return ttc_parse_kernel(parser, keyword);
    case TTC_KEYWORD_DOMAIN: return ttc_parse_region(parser);
    case TTC_KEYWORD_OBSERVE: return ttc_parse_observe(parser);
    case TTC_KEYWORD_VALID: return ttc_parse_valid(parser);
    case TTC_KEYWORD_POLE: return ttc_parse_pole(parser);
    case TTC_KEYWORD_LIFT: return is_named(parser) ? ttc_parse_claim(parser, keyword) : ttc_parse_lift(parser, keyword);
    case TTC_KEYWORD_TIER: return ttc_parse_tier(parser, keyword);
    case TTC_KEYWORD_START: return ttc_parse_start(parser);
    case TTC_KEYWORD_TURNS: return ttc_parse_turns(parser, keyword);
    case TTC_KEYWORD_NONE:
        return false; /* reported by the lexer */
    default: return ttc_parse_claim(parser, keyword);
    }
}

typedef struct {
    size_t symbols, claims, variants, times, validities;
} record_counts;

static record_counts counts_of(const ttc_model *model)
{
    return (record_counts){ model->symbol_count, model->claim_count, model->variant_count, model->time_count,
                            model->validity_count };
}

static bool defines_by_expression(ttc_keyword keyword)
{
    return keyword == TTC_KEYWORD_LET || keyword == TTC_KEYWORD_ROOT || keyword == TTC_KEYWORD_ANGLE || keyword == TTC_KEYWORD_EXP
           || keyword == TTC_KEYWORD_LOG || keyword == TTC_KEYWORD_OBSERVE;
}

/* Store divisors and uses of the record in the model. Their owner is what it added to the model since the counts were `before`. */
static bool keep_divisors(ttc_parser *parser, ttc_keyword keyword, record_counts before)
{
    ttc_model *model = parser->model;
    const record_counts now = counts_of(model);
    ttc_divisor d = { .role = TTC_DIVIDES_FIELD };
    if (now.claims > before.claims) d = (ttc_divisor){ .role = TTC_DIVIDES_CLAIM, .owner = (uint32_t)before.claims };
    else if (now.variants > before.variants) d = (ttc_divisor){ .role = TTC_DIVIDES_VARIANT, .owner = (uint32_t)before.variants };
    else if (now.times > before.times) d = (ttc_divisor){ .role = TTC_DIVIDES_TIME, .owner = (uint32_t)before.times };
    else if (now.validities > before.validities)
        d = (ttc_divisor){ .role = TTC_DIVIDES_VALID, .owner = (uint32_t)before.validities };
    else if (now.symbols > before.symbols && defines_by_expression(keyword))
        d = (ttc_divisor){ .role = TTC_DIVIDES_SYMBOL, .owner = (uint32_t)now.symbols - 1 };
    else if (keyword == TTC_KEYWORD_TIER) d.role = TTC_DIVIDES_TIER;
    else if (keyword == TTC_KEYWORD_LIFT || keyword == TTC_KEYWORD_TURNS) d.role = TTC_DIVIDES_LIFT;
    for (size_t i = 0; i < parser->divisor_count; i++) {
        if (!TTC_ARRAY_GROW(model->divisors, model->divisor_count)) return ttc_parse_no_memory(parser);
        d.divisor = parser->divisors[i];
        model->divisors[model->divisor_count++] = d;
    }
    parser->divisor_count = 0;
    for (size_t i = 0; i < parser->use_count; i++) {
        if (!TTC_ARRAY_GROW(model->uses, model->use_count)) return ttc_parse_no_memory(parser);
        model->uses[model->use_count++] = (ttc_use){ parser->uses[i], d.role, d.owner };
    }
    parser->use_count = 0;
    return true;
}

static void parse_table(ttc_parser *parser)
{
    const ttc_token *first = parser->tokens;
    if (first->kind == TTC_TOKEN_END)
        ttc_parse_error(parser, ttc_token_place(first), "the table is empty (expected 'model NAME')");
    else if (first->keyword != TTC_KEYWORD_MODEL)
        ttc_parse_error(parser, ttc_token_place(first), "the table opens without its model (expected 'model NAME' first)");
    while (!parser->out_of_memory && ttc_parse_peek(parser)->kind != TTC_TOKEN_END) {
        const ttc_token *keyword = parser->tokens + parser->at++;
        parser->operand_count = 0;
        parser->nesting = 0;
        parser->in_charpoly = false;
        parser->divisor_count = 0;
        parser->use_count = 0;
        const record_counts before = counts_of(parser->model);
        if (keyword->kind == TTC_TOKEN_RECORD && parse_record(parser, keyword)) ttc_parse_record_end(parser);
        if (!keep_divisors(parser, keyword->keyword, before)) return;
        while (ttc_parse_peek(parser)->kind != TTC_TOKEN_RECORD && ttc_parse_peek(parser)->kind != TTC_TOKEN_END) parser->at++;
    }
}

static ttc_model *create_model(const char *text, size_t length, const char *file)
{
    ttc_model *model = calloc(1, sizeof *model);
    if (model == NULL) return NULL;
    model->graph = ttc_graph_create();
    model->text = malloc(length + 1);
    model->file = malloc(strlen(file) + 1);
    if (model->graph == NULL || model->text == NULL || model->file == NULL) {
        ttc_model_destroy(model);
        return NULL;
    }
    if (length > 0) memcpy(model->text, text, length);
    model->text[length] = '\0';
    memcpy(model->file, file, strlen(file) + 1);
    ttc_sha256(model->sha256, text, length);
    return model;
}

static ttc_model *parse(const char *text, size_t length, const char *file, bool with_pi, ttc_diagnostics *diagnostics)
{
    static const ttc_token pi = { .kind = TTC_TOKEN_NAME, .line = 1, .column = 1, .length = 2, .text = "pi" };
    static const ttc_token lambda = { .kind = TTC_TOKEN_NAME, .length = 6, .text = "lambda" };
    ttc_diagnostics_source(diagnostics, file, text, length);
    if (!ttc_source_check(text, length, diagnostics)) return NULL;

    ttc_parser parser = { .diagnostics = diagnostics, .errors_before = ttc_error_count(diagnostics) };
    ttc_token *tokens = NULL;
    uint32_t symbol;
    parser.model = create_model(text, length, file);
    parser.out_of_memory = parser.model == NULL || (tokens = ttc_lex(text, length, diagnostics)) == NULL;
    if (!parser.out_of_memory && ttc_parse_define(&parser, &lambda, TTC_LAMBDA, TTC_NONE, &symbol)) {
        parser.tokens = tokens;
        parse_table(&parser);
        with_pi = with_pi && !parser.out_of_memory && parser.model->symbol_count <= TTC_SYMBOL_LIMIT;
        if (with_pi && !ttc_parse_find(&parser, &pi, &symbol)) ttc_parse_pi(&parser, &pi, &symbol);
        if (!parser.out_of_memory) ttc_parse_resolve(&parser);
    }
    if (parser.out_of_memory) ttc_report(diagnostics, TTC_MEMORY_ERROR, 0, 0, "out of memory");
    free(tokens);
    free(parser.hashes);
    free(parser.used);
    free(parser.references);
    free(parser.operands);
    free(parser.exponents);
    free(parser.weights);
    free(parser.places);
    free(parser.divisors);
    free(parser.uses);
    free(parser.expansions);
    if (ttc_error_count(diagnostics) == parser.errors_before) return parser.model;
    ttc_model_destroy(parser.model);
    return NULL;
}

ttc_model *ttc_model_parse(const char *text, size_t length, const char *file, ttc_diagnostics *diagnostics)
{
    return parse(text, length, file, false, diagnostics);
}

static ttc_model *parse_again(const char *text, const char *file, bool with_pi)
{
    ttc_diagnostics *ignored = ttc_diagnostics_create();
    ttc_model *model = ignored != NULL ? parse(text, strlen(text), file, with_pi, ignored) : NULL;
    ttc_diagnostics_destroy(ignored);
    return model;
}

ttc_model *ttc_model_with_pi(const ttc_model *model) { return parse_again(model->text, model->file, true); }

ttc_model *ttc_model_again(const char *text, const char *file) { return parse_again(text, file, false); }

ttc_model *ttc_model_read(const char *path, ttc_diagnostics *diagnostics)
{
    size_t length = 0;
    ttc_diagnostics_source(diagnostics, path, NULL, 0);
    char *text = ttc_source_read(path, &length, diagnostics);
    if (text == NULL) return NULL;
    ttc_model *model = ttc_model_parse(text, length, path, diagnostics);
    free(text);
    return model;
}
