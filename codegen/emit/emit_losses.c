/* Where a kernel loses digits: what it divides by and takes roots of, and whether that can vanish. */
#include "emit/emit.h"

#include <stdlib.h>

typedef enum { UNKNOWN, NONNEGATIVE, POSITIVE } sign;

/* A lower bound on what is known of the sign, from the sign conditions of parameters, even powers, and roots. */
static sign sign_of(const ttc_field *field, ttc_id id)
{
    const ttc_graph *graph = field->graph;
    sign result = POSITIVE;
    switch (ttc_kind_of(graph, id)) {
    case TTC_NUMBER:
        return fmpq_sgn(ttc_coefficient(graph, id)) > 0 ? POSITIVE : fmpq_is_zero(ttc_coefficient(graph, id)) ? NONNEGATIVE
                                                                                                              : UNKNOWN;
    case TTC_SYMBOL: {
        const ttc_field_symbol *s = field->symbols + ttc_symbol_of(graph, id);
        if (s->role == TTC_ROLE_PARAM) return s->sign == TTC_POSITIVE ? POSITIVE : s->sign == TTC_NONNEGATIVE ? NONNEGATIVE : UNKNOWN;
        if (s->role == TTC_ROLE_UNIT) return sign_of(field, s->definition);
        if (s->role == TTC_ROLE_EXP || s->role == TTC_ROLE_PI) return POSITIVE;
        return s->role == TTC_ROLE_ROOT ? NONNEGATIVE : UNKNOWN;
    }
    case TTC_PRODUCT:
        if (fmpq_sgn(ttc_coefficient(graph, id)) < 0) return UNKNOWN;
        for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
            ttc_part part = ttc_part_at(graph, id, i);
            sign base = sign_of(field, part.id);
            if (part.exponent % 2 == 0 && base == UNKNOWN) base = NONNEGATIVE;
            if (base < result) result = base;
        }
        return result;
    default:
        result = fmpq_sgn(ttc_coefficient(graph, id)) > 0 ? POSITIVE : NONNEGATIVE;
        if (fmpq_sgn(ttc_coefficient(graph, id)) < 0) return UNKNOWN;
        for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
            ttc_part part = ttc_part_at(graph, id, i);
            sign term = fmpq_sgn(part.coefficient) > 0 ? sign_of(field, part.id) : UNKNOWN;
            if (term == UNKNOWN) return UNKNOWN;
            if (term == POSITIVE) result = POSITIVE;
        }
        return result;
    }
}

typedef struct {
    ttc_field *field;
    unsigned char *seen;        /* by id */
    unsigned char *denominator; /* by id */
    unsigned char *radicand;
} survey;

static void visit(survey *s, ttc_id id)
{
    const ttc_graph *graph = s->field->graph;
    if (s->seen[id]) return;
    s->seen[id] = 1;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) {
        const ttc_field_symbol *symbol = s->field->symbols + ttc_symbol_of(graph, id);
        if (symbol->role == TTC_ROLE_ROOT) s->radicand[id] = 1;
        if (symbol->role >= TTC_ROLE_UNIT) visit(s, symbol->definition);
    }
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        if (ttc_kind_of(graph, id) == TTC_PRODUCT && part.exponent < 0) s->denominator[part.id] = 1;
        visit(s, part.id);
    }
}

static void describe_terms(ttc_text *text, ttc_field *field, ttc_id sum)
{
    for (size_t i = 0; i < ttc_part_count(field->graph, sum); i++) {
        ttc_part part = ttc_part_at(field->graph, sum, i);
        if (i > 0) ttc_text_add(text, i + 1 == ttc_part_count(field->graph, sum) ? " and " : ", ");
        ttc_emit_formula(text, field->graph, ttc_scale(field->graph, part.id, part.coefficient), ttc_emit_symbol_name, field);
    }
}

static ttc_id definition_of(const ttc_field *field, ttc_id id)
{
    if (ttc_kind_of(field->graph, id) != TTC_SYMBOL) return id;
    const ttc_field_symbol *s = field->symbols + ttc_symbol_of(field->graph, id);
    return s->role == TTC_ROLE_UNIT ? s->definition : id;
}

/* A sum of non-negative terms one of which is a positive constant stays away from zero. */
static bool is_bounded_below(const ttc_field *field, ttc_id sum)
{
    const ttc_graph *graph = field->graph;
    if (ttc_kind_of(graph, sum) != TTC_SUM || sign_of(field, sum) != POSITIVE) return false;
    if (fmpq_sgn(ttc_coefficient(graph, sum)) > 0) return true;
    for (size_t i = 0; i < ttc_part_count(graph, sum); i++) {
        ttc_id term = ttc_part_at(graph, sum, i).id;
        if (ttc_field_is_constant(field, term) && sign_of(field, term) == POSITIVE) return true;
    }
    return false;
}

static void separate(ttc_text *text)
{
    if (text->length > 0) ttc_text_add(text, TTC_LOSS_SEPARATOR);
}

void ttc_emit_losses(ttc_text *text, ttc_field *field, const ttc_kernel *kernel)
{
    size_t n = ttc_graph_size(field->graph) + 1;
    survey s = { field, calloc(n, 1), calloc(n, 1), calloc(n, 1) };
    ttc_text losses = { 0 };
    if (s.seen == NULL || s.denominator == NULL || s.radicand == NULL) {
        text->failed = true;
        goto done;
    }
    for (size_t i = 0; i < kernel->count; i++) visit(&s, kernel->outputs[i]);
    for (ttc_id id = 1; id < n; id++) {
        if (!s.denominator[id] || ttc_field_is_constant(field, id)) continue;
        ttc_id sum = definition_of(field, id);
        if (is_bounded_below(field, sum)) continue;
        separate(&losses);
        ttc_text_add(&losses, "divides by ");
        ttc_emit_formula(&losses, field->graph, id, ttc_emit_symbol_name, field);
        if (ttc_kind_of(field->graph, sum) == TTC_SUM && sign_of(field, sum) != UNKNOWN) {
            ttc_text_add(&losses, ", small only where all of ");
            describe_terms(&losses, field, sum);
            ttc_text_add(&losses, " are");
        } else {
            ttc_text_add(&losses, ": values and rounding errors grow without bound where it vanishes");
        }
    }
    for (ttc_id id = 1; id < n; id++) {
        if (!s.radicand[id] || ttc_field_is_constant(field, id)) continue;
        separate(&losses);
        ttc_text_add(&losses, "takes ");
        ttc_emit_formula(&losses, field->graph, id, ttc_emit_symbol_name, field);
        ttc_text_add(&losses, " = sqrt(");
        ttc_emit_formula(&losses, field->graph, field->symbols[ttc_symbol_of(field->graph, id)].definition, ttc_emit_symbol_name, field);
        ttc_text_add(&losses, "): rounding errors of the states grow without bound where it vanishes");
    }
    ttc_text_add(text, ttc_text_string(&losses));
    text->failed |= losses.failed;
done:
    ttc_text_clear(&losses);
    free(s.seen);
    free(s.denominator);
    free(s.radicand);
}
