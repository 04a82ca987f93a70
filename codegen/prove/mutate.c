#include "prove/mutate.h"

#include "base/array.h"
#include "read/token.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    ttc_token *tokens;
    ttc_mutation_report *report;
} mutation;

static bool is_mark(const ttc_token *token, char mark) { return token->kind == TTC_TOKEN_MARK && *token->text == mark; }
static bool is_sign(const ttc_token *token) { return is_mark(token, '+') || is_mark(token, '-'); }

/* Add both mutants of the term that consists of tokens first to last, its sign included if it has one; none of the term 0, which
 * would be the same table. */
static bool add_mutants(mutation *m, size_t first, size_t last)
{
    const ttc_token *tokens = m->tokens;
    if (last == first + is_sign(&tokens[first]) && tokens[last].length == 1 && *tokens[last].text == '0') return true;
    const char *start = tokens[first].text, *end = tokens[last].text + tokens[last].length;
    for (int dropped = 0; dropped < 2; dropped++) {
        if (!TTC_ARRAY_GROW(m->report->mutants, m->report->count)) return false;
        m->report->mutants[m->report->count++] = (ttc_mutant){ .place = { tokens[first].line, tokens[first].column },
                                                               .term = start, .term_length = (size_t)(end - start),
                                                               .dropped = dropped == 1 };
    }
    return true;
}

/* Add mutants of the terms of the sum that begins at token *at, up to the token that closes it, and of sums in parentheses within;
 * not of exponents. grouped: this sum is in parentheses. */
static bool sum_terms(mutation *m, size_t *at, bool grouped)
{
    const ttc_token *tokens = m->tokens;
    size_t first = *at, start = *at;
    for (;;) {
        const ttc_token *token = &tokens[*at];
        bool opens = is_mark(token, '(');
        bool exponent = *at > 0 && is_mark(&tokens[*at - 1], '^');
        bool closes = token->kind == TTC_TOKEN_END || token->kind == TTC_TOKEN_RECORD || token->kind == TTC_TOKEN_KEYWORD
                      || is_mark(token, ')') || is_mark(token, ',');
        if (closes || (is_sign(token) && !exponent && *at > first)) {
            bool whole = grouped && closes && first == start; /* a group of one term is no sum */
            if (*at > first && !whole && !add_mutants(m, first, *at - 1)) return false;
            if (closes) return true;
            first = *at;
        }
        ++*at;
        if (opens && exponent) {
            while (!is_mark(&tokens[*at], ')') && tokens[*at].kind != TTC_TOKEN_END) ++*at;
        } else if (opens && !sum_terms(m, at, true)) {
            return false;
        }
        if (opens && is_mark(&tokens[*at], ')')) ++*at;
    }
}

/* Add mutants of the expression of an equation, let or root: that after '=', for a root that within sqrt(). */
static bool record_terms(mutation *m, size_t record)
{
    size_t at = record + 1;
    while (m->tokens[at].kind == TTC_TOKEN_NAME || m->tokens[at].kind == TTC_TOKEN_UNIT) at++;
    if (!is_mark(&m->tokens[at], '=')) return true;
    at++;
    if (m->tokens[record].keyword == TTC_KEYWORD_ROOT) at += 2;
    return sum_terms(m, &at, false);
}

static bool find_terms(mutation *m)
{
    for (size_t i = 0; m->tokens[i].kind != TTC_TOKEN_END; i++) {
        ttc_keyword keyword = m->tokens[i].keyword;
        if (m->tokens[i].kind != TTC_TOKEN_RECORD) continue;
        if (keyword != TTC_KEYWORD_EQ && keyword != TTC_KEYWORD_LET && keyword != TTC_KEYWORD_ROOT) continue;
        if (!record_terms(m, i)) return false;
    }
    return true;
}

/* The text of the table with the term replaced by its opposite or by 0, for free(); NULL when memory is out. */
static char *mutant_text(const ttc_model *model, const ttc_mutant *mutant)
{
    size_t before = (size_t)(mutant->term - model->text);
    const char *rest = mutant->term + mutant->term_length, *body = mutant->term;
    char sign = *body == '-' ? '+' : '-';
    if (*body == '+' || *body == '-') body++;
    if (mutant->dropped) sign = '+';
    char *text = malloc(strlen(model->text) + 3);
    if (text == NULL) return NULL;
    memcpy(text, model->text, before);
    char *at = text + before;
    *at++ = sign;
    if (mutant->dropped) {
        *at++ = '0';
    } else {
        memcpy(at, body, (size_t)(rest - body));
        at += rest - body;
    }
    strcpy(at, rest);
    return text;
}

/* Context of a resolver that gives the mutant for the file name of its table, and leaves other files to another resolver. */
typedef struct {
    const ttc_model *mutated;
    ttc_resolver resolver;
    void *context;
} substitute;

static ttc_model *resolve_mutant(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics)
{
    const substitute *s = context;
    if (strcmp(target, ttc_model_base_name(s->mutated)) != 0) return s->resolver(s->context, model, target, diagnostics);
    return ttc_model_parse(s->mutated->text, strlen(s->mutated->text), s->mutated->file, diagnostics);
}

/* A mutant of a table of coordinates counts as refuted if a section of the model that it lifts into is no longer proved: many such
 * mutants leave no points at which a claim could be refuted. Returns false when memory is out. */
static bool prove_sections(const ttc_model *mutated, ttc_resolver resolver, void *context, ttc_mutant *mutant)
{
    substitute s = { mutated, resolver, context };
    ttc_diagnostics *ignored = ttc_diagnostics_create();
    ttc_model *owner = ignored == NULL || resolver == NULL ? NULL : resolver(context, mutated, mutated->lift.file, ignored);
    ttc_proof_run *run = owner == NULL ? NULL : ttc_proof_run_create(owner, resolve_mutant, &s);
    for (size_t i = 0; run != NULL && mutant->refuted == NULL && i < owner->section_count; i++) {
        const uint32_t claim = owner->sections[i].claim;
        if (strcmp(owner->claims[claim].target, ttc_model_base_name(mutated)) != 0) continue;
        ttc_proof_run_prove(run, claim);
        if (ttc_proof_run_proof(run, claim)->status == TTC_PROVED) continue;
        mutant->fate = TTC_MUTANT_REFUTED;
        mutant->refuted = strdup(owner->claims[claim].name);
    }
    const bool ok = ignored != NULL && (owner == NULL || run != NULL);
    ttc_proof_run_destroy(run);
    ttc_model_destroy(owner);
    ttc_diagnostics_destroy(ignored);
    return ok;
}

/* Prove the claims of a text, NULL when memory is out, which is freed here: a mutant of the model, or the model itself. */
static bool prove_text(const ttc_model *model, char *text, ttc_resolver resolver, void *context, ttc_mutant *mutant)
{
    bool done = false;
    ttc_proof_report *report = NULL;
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *mutated = NULL;
    if (text == NULL || diagnostics == NULL) goto done;
    mutated = ttc_model_parse(text, strlen(text), model->file, diagnostics);
    mutant->fate = TTC_MUTANT_UNREADABLE;
    done = mutated == NULL || ttc_prove(mutated, resolver, context, TTC_PROVE_UNTIL_REFUTED, &report);
    if (report == NULL) goto done;
    mutant->fate = report->refuted > 0 ? TTC_MUTANT_REFUTED : TTC_MUTANT_SURVIVED;
    if (report->refuted > 0) {
        mutant->refuted = report->proofs[report->proof_count - 1].name;
        report->proofs[report->proof_count - 1].name = NULL;
    } else if (mutated->lift.file != NULL) {
        done = prove_sections(mutated, resolver, context, mutant);
    }
done:
    ttc_proof_report_destroy(report);
    ttc_model_destroy(mutated);
    ttc_diagnostics_destroy(diagnostics);
    free(text);
    return done;
}

bool ttc_mutate(const ttc_model *model, ttc_resolver resolver, void *context, ttc_mutation_report **report)
{
    *report = NULL;
    bool ok = false;
    mutation m = { .tokens = NULL };
    ttc_mutant itself = { 0 };
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    m.report = calloc(1, sizeof *m.report);
    if (diagnostics == NULL || m.report == NULL) goto done;
    m.tokens = ttc_lex(model->text, strlen(model->text), diagnostics);
    if (m.tokens == NULL || !prove_text(model, strdup(model->text), resolver, context, &itself)) goto done;
    m.report->broken = itself.refuted;
    if (m.report->broken == NULL && !find_terms(&m)) goto done;
    for (size_t i = 0; i < m.report->count; i++) {
        ttc_mutant *mutant = &m.report->mutants[i];
        if (!prove_text(model, mutant_text(model, mutant), resolver, context, mutant)) goto done;
        m.report->refuted += mutant->fate == TTC_MUTANT_REFUTED;
        m.report->survived += mutant->fate == TTC_MUTANT_SURVIVED;
        m.report->unreadable += mutant->fate == TTC_MUTANT_UNREADABLE;
    }
    *report = m.report;
    m.report = NULL;
    ok = true;
done:
    ttc_mutation_report_destroy(m.report);
    free(m.tokens);
    ttc_diagnostics_destroy(diagnostics);
    return ok;
}

void ttc_mutation_report_destroy(ttc_mutation_report *report)
{
    if (report == NULL) return;
    for (size_t i = 0; i < report->count; i++) free(report->mutants[i].refuted);
    free(report->mutants);
    free(report->broken);
    free(report);
}
