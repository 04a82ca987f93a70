/* Gathering of fractions: n_1/d + n_2/d + rest = (n_1 + n_2)/d + rest. The derivative n'/d - (n/d) d'/d of the first term on the
 * right then uses the fraction n/d itself, where derivatives of the single fractions would use each of them. */
#include "fields/field.h"

#include "base/text.h"

/* Returns true if d to the power -1 is a factor of the term. */
static bool is_over(const ttc_graph *graph, ttc_id term, ttc_id d)
{
    if (ttc_kind_of(graph, term) != TTC_PRODUCT) return false;
    for (size_t k = 0; k < ttc_part_count(graph, term); k++) {
        ttc_part part = ttc_part_at(graph, term, k);
        if (part.id == d) return part.exponent == -1;
    }
    return false;
}

static ttc_id gather_over(ttc_field *field, ttc_id sum, ttc_id d, const char *name)
{
    ttc_graph *graph = field->graph;
    ttc_id numerator = ttc_integer(graph, 0), rest = sum;
    size_t gathered = 0;
    if (sum == TTC_NONE || ttc_kind_of(graph, sum) != TTC_SUM) return sum;
    for (size_t i = 0; i < ttc_part_count(graph, sum); i++) {
        ttc_part part = ttc_part_at(graph, sum, i);
        if (!is_over(graph, part.id, d)) continue;
        ttc_id term = ttc_scale(graph, part.id, part.coefficient);
        rest = ttc_subtract(graph, rest, term);
        numerator = ttc_add(graph, numerator, ttc_multiply(graph, term, d));
        gathered++;
    }
    if (gathered < 2 || rest == TTC_NONE || numerator == TTC_NONE) return gathered < 2 ? sum : TTC_NONE;
    ttc_id unit = ttc_field_add_unit(field, name, numerator);
    return unit == TTC_NONE ? TTC_NONE : ttc_add(graph, rest, ttc_divide(graph, unit, d));
}

bool ttc_field_gather(ttc_field *field, ttc_id *rhs)
{
    size_t symbols = field->symbol_count;
    for (size_t i = 0; i < field->state_count; i++) {
        rhs[i] = field->rhs[i];
        for (size_t k = 0; k < symbols; k++) {
            if (field->symbols[k].role != TTC_ROLE_UNIT || field->symbols[k].is_constant) continue;
            ttc_text name = { 0 };
            ttc_text_format(&name, "numerator of d(%s)/dt over %s", field->symbols[field->states[i]].name, field->symbols[k].name);
            rhs[i] = name.failed ? TTC_NONE : gather_over(field, rhs[i], field->symbols[k].node, ttc_text_string(&name));
            ttc_text_clear(&name);
            if (rhs[i] == TTC_NONE) return false;
        }
    }
    return true;
}
