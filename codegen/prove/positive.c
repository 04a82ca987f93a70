#include "prove/positive.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct {
    ttc_task *task;
    ttc_valuation *valuation;
    unsigned char *signs; /* by expression, 0: not yet known */
    bool may_search;
} signs_of_parts;

static unsigned signs_of(signs_of_parts *s, ttc_id id);

static unsigned signs_of_number(const fmpq_t value)
{
    const int sign = fmpq_sgn(value);
    return sign > 0 ? TTC_CAN_BE_POSITIVE : sign < 0 ? TTC_CAN_BE_NEGATIVE : TTC_CAN_BE_ZERO;
}

/* Whether a search for points of the leaf at which a ratio is of the other sign, or zero, finds that there are none. */
static bool has_no_other_sign(signs_of_parts *s, const ttc_ratio *value, int sign)
{
    ttc_ratio other;
    ttc_ratio_init(s->task->ring, &other);
    ttc_ratio_set(s->task->ring, &other, value);
    if (sign > 0) ttc_ratio_scale(s->task->ring, &other, value, s->task->ring->minus_one);
    const ttc_search_result result = ttc_task_search(s->task, &other, TTC_IS_NONNEGATIVE, NULL);
    ttc_ratio_clear(s->task->ring, &other);
    return result == TTC_POINT_IMPOSSIBLE || result == TTC_POINT_EXCLUDED;
}

static unsigned signs_of_value(signs_of_parts *s, ttc_id id, bool may_search)
{
    unsigned signs = TTC_CAN_BE_ANY;
    ttc_ratio value;
    ttc_ratio_init(s->task->ring, &value);
    ttc_evaluate(s->valuation, &value, id);
    if (ttc_task_open(s->task))
        signs = ttc_conditions_signs_of_product(ttc_conditions_signs(&s->task->domain, value.numerator),
                                                ttc_conditions_signs(&s->task->domain, value.denominator));
    if (may_search && signs == TTC_CAN_BE_ANY && has_no_other_sign(s, &value, 1)) signs = TTC_CAN_BE_POSITIVE;
    if (may_search && signs == TTC_CAN_BE_ANY && has_no_other_sign(s, &value, -1)) signs = TTC_CAN_BE_NEGATIVE;
    ttc_ratio_clear(s->task->ring, &value);
    return signs;
}

static unsigned signs_of_symbol(signs_of_parts *s, ttc_id id)
{
    const ttc_model *model = ttc_valuation_model(s->valuation);
    const uint32_t symbol = ttc_symbol_of(model->graph, id);
    if (symbol >= model->symbol_count || ttc_valuation_is_bound(s->valuation, symbol)) return signs_of_value(s, id, false);
    const ttc_symbol_entry *entry = model->symbols + symbol;
    if (entry->kind == TTC_LET) return signs_of(s, entry->definition);
    if (entry->kind == TTC_ROOT || entry->kind == TTC_EXP) return TTC_CAN_BE_POSITIVE;
    return signs_of_value(s, id, false);
}

/* Without a sum in it. */
static bool is_simple(const ttc_graph *graph, ttc_id id)
{
    const ttc_kind kind = ttc_kind_of(graph, id);
    if (kind != TTC_PRODUCT) return kind != TTC_SUM;
    for (size_t i = 0; i < ttc_part_count(graph, id); i++)
        if (ttc_kind_of(graph, ttc_part_at(graph, id, i).id) == TTC_SUM) return false;
    return true;
}

static unsigned signs_of_sum(signs_of_parts *s, ttc_id id)
{
    const ttc_graph *graph = ttc_valuation_model(s->valuation)->graph;
    unsigned signs = signs_of_number(ttc_coefficient(graph, id));
    bool simple = true;
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        const unsigned own = ttc_conditions_signs_of_product(signs_of_number(part.coefficient), signs_of(s, part.id));
        signs = ttc_conditions_signs_of_sum(signs, own);
        simple = simple && is_simple(graph, part.id);
    }
    return signs == TTC_CAN_BE_ANY && simple && s->may_search ? signs_of_value(s, id, true) : signs;
}

/* What divides is not zero. */
static unsigned signs_of_product(signs_of_parts *s, ttc_id id)
{
    const ttc_graph *graph = ttc_valuation_model(s->valuation)->graph;
    unsigned signs = signs_of_number(ttc_coefficient(graph, id));
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        const unsigned of_part = ttc_conditions_signs_of_power(signs_of(s, part.id), (unsigned long)labs(part.exponent));
        signs = ttc_conditions_signs_of_product(signs, part.exponent < 0 ? of_part & ~(unsigned)TTC_CAN_BE_ZERO : of_part);
    }
    return signs;
}

static unsigned signs_of(signs_of_parts *s, ttc_id id)
{
    if (s->signs[id] == 0) {
        const ttc_graph *graph = ttc_valuation_model(s->valuation)->graph;
        const ttc_kind kind = ttc_kind_of(graph, id);
        s->signs[id] = (unsigned char)(kind == TTC_SUM       ? signs_of_sum(s, id)
                                       : kind == TTC_PRODUCT ? signs_of_product(s, id)
                                       : kind == TTC_SYMBOL  ? signs_of_symbol(s, id)
                                                             : signs_of_number(ttc_coefficient(graph, id)));
    }
    return s->signs[id];
}

static bool is_positive(ttc_task *task, ttc_valuation *valuation, ttc_id id, bool may_search)
{
    signs_of_parts s = { task, valuation, calloc(ttc_graph_size(ttc_valuation_model(valuation)->graph) + 1, 1), may_search };
    const bool result = s.signs != NULL && signs_of(&s, id) == TTC_CAN_BE_POSITIVE;
    free(s.signs);
    return result;
}

void ttc_positive_require(ttc_task *task, ttc_valuation *valuation, ttc_id id, const char *format, ...)
{
    char what[2 * TTC_DIAGNOSTIC_LINE];
    ttc_ratio value;
    va_list arguments;
    if (!ttc_task_open(task)) return;
    if (task->tested == NULL && (is_positive(task, valuation, id, false) || is_positive(task, valuation, id, true))) return;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(valuation, &value, id);
    ttc_task_require(task, &value, TTC_IS_POSITIVE, "%s", what);
    ttc_ratio_clear(task->ring, &value);
}
