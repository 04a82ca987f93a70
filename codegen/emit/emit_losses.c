/* Describes where a kernel loses digits: first the divisors and roots that can vanish, then the sums. */
#include "emit/emit.h"
#include "fields/survey.h"

/* Whether no term of a sum is ever negative. */
static bool has_nonnegative_terms(ttc_field *field, ttc_id sum)
{
    const ttc_graph *graph = field->graph;
    if (ttc_kind_of(graph, sum) != TTC_SUM || fmpq_sgn(ttc_coefficient(graph, sum)) < 0) return false;
    for (size_t i = 0; i < ttc_part_count(graph, sum); i++) {
        ttc_part part = ttc_part_at(graph, sum, i);
        if (fmpq_sgn(part.coefficient) < 0 || !ttc_extent_is_nonnegative(ttc_field_extent(field, part.id))) return false;
    }
    return true;
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

/* Whether a value stays away from zero: by bounds, or as a sum of nonnegative terms with a positive constant. */
static bool is_bounded_below(ttc_field *field, ttc_id sum)
{
    const ttc_graph *graph = field->graph;
    if (ttc_field_extent(field, sum).low > 0) return true;
    if (!has_nonnegative_terms(field, sum)) return false;
    for (size_t i = 0; i < ttc_part_count(graph, sum); i++) {
        ttc_part part = ttc_part_at(graph, sum, i);
        if (ttc_field_is_constant(field, part.id) && ttc_extent_is_positive(ttc_field_extent(field, part.id))) return true;
    }
    return false;
}

static void separate(ttc_text *text)
{
    if (text->length > 0) ttc_text_add(text, TTC_LOSS_SEPARATOR);
}

void ttc_emit_losses(ttc_text *text, ttc_kernels *kernels, ttc_kernel_kind kind)
{
    ttc_field *field = kernels->field;
    const ttc_kernel *kernel = kernels->kernels + kind;
    ttc_survey s;
    ttc_text losses = { 0 };
    if (!ttc_survey_init(&s, field)) {
        text->failed = true;
        goto done;
    }
    for (size_t i = 0; i < kernel->count; i++) ttc_survey_add(&s, kernel->outputs[i]);
    for (ttc_id id = 1; id < s.size && ttc_emit_uses(kernel->optimized, TTC_OP_DIVIDE); id++) {
        if (!s.denominator[id] || ttc_field_is_constant(field, id)) continue;
        ttc_id sum = definition_of(field, id);
        if (is_bounded_below(field, sum)) continue;
        separate(&losses);
        ttc_text_add(&losses, "divides by ");
        ttc_emit_formula(&losses, field->graph, id, ttc_emit_symbol_name, field);
        if (has_nonnegative_terms(field, sum)) {
            ttc_text_add(&losses, ", small only where all of ");
            describe_terms(&losses, field, sum);
            ttc_text_add(&losses, " are");
        } else {
            ttc_text_add(&losses, ": values and rounding errors grow without bound where it vanishes");
        }
    }
    for (ttc_id id = 1; id < s.size && ttc_emit_uses(kernel->optimized, TTC_OP_ROOT); id++) {
        if (!s.root[id] || ttc_field_is_constant(field, id)) continue;
        separate(&losses);
        ttc_text_add(&losses, "takes ");
        ttc_emit_formula(&losses, field->graph, id, ttc_emit_symbol_name, field);
        ttc_text_add(&losses, " = sqrt(");
        ttc_emit_formula(&losses, field->graph, field->symbols[ttc_symbol_of(field->graph, id)].definition, ttc_emit_symbol_name,
                         field);
        ttc_text_add(&losses, "): rounding errors of the states grow without bound where it vanishes");
    }
    ttc_emit_cancellations(&losses, kernels, kind);
    ttc_text_add(text, ttc_text_string(&losses));
    text->failed |= losses.failed;
done:
    ttc_text_clear(&losses);
    ttc_survey_clear(&s);
}
