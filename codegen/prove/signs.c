#include "prove/signs.h"

#include "prove/one_state.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct {
    ttc_task *task;
    ttc_valuation *valuation;
    unsigned char *signs; /* by expression, 0: not yet known */
    ttc_id whole;         /* which is looked at as a ratio in the end */
    bool looks_closer, may_search;
    ttc_state_value *negative; /* NULL, or gets a place at which the whole is not positive, if one is met */
} signs_of_parts;

static unsigned signs_of(signs_of_parts *s, ttc_id id);

/* Returns true if a search shows that no point of the leaf has the ratio zero or of the opposite sign. Conditions NONZERO are left
 * out: they seldom tell a sign, and may be of a high degree. */
static bool has_no_other_sign(signs_of_parts *s, const ttc_ratio *value, int sign)
{
    ttc_task *task = s->task;
    const ttc_conditions whole = task->domain;
    ttc_ratio other;
    ttc_ratio_init(task->ring, &other);
    ttc_ratio_set(task->ring, &other, value);
    if (sign > 0) ttc_ratio_scale(task->ring, &other, value, task->ring->minus_one);
    ttc_conditions_of_signs(&task->domain, &whole);
    const ttc_search_result result = ttc_task_search(task, &other, TTC_IS_NONNEGATIVE, NULL);
    ttc_conditions_clear(&task->domain);
    task->domain = whole;
    ttc_ratio_clear(task->ring, &other);
    return result == TTC_POINT_IMPOSSIBLE || result == TTC_POINT_EXCLUDED;
}

/* Returns `sign`, or `sign` and zero, if elimination alone shows that a ratio has no other sign; else TTC_CAN_BE_ANY. */
static unsigned signs_by_elimination(signs_of_parts *s, const ttc_ratio *value, unsigned sign)
{
    ttc_task *task = s->task;
    unsigned signs = TTC_CAN_BE_ANY;
    ttc_ratio other;
    ttc_ratio_init(task->ring, &other);
    ttc_ratio_set(task->ring, &other, value);
    if (sign == TTC_CAN_BE_POSITIVE) ttc_ratio_scale(task->ring, &other, value, task->ring->minus_one);
    if (ttc_task_never_is(task, &other, TTC_IS_POSITIVE))
        signs = ttc_task_never_is(task, &other, TTC_IS_NONNEGATIVE) ? sign : sign | TTC_CAN_BE_ZERO;
    ttc_ratio_clear(task->ring, &other);
    return signs;
}

static unsigned signs_of_value(signs_of_parts *s, ttc_id id, bool may_eliminate, bool may_search)
{
    unsigned signs = TTC_CAN_BE_ANY;
    ttc_ratio value;
    ttc_ratio_init(s->task->ring, &value);
    ttc_evaluate(s->valuation, &value, id);
    if (ttc_task_open(s->task))
        signs = ttc_conditions_signs_of_product(ttc_conditions_signs(&s->task->domain, value.numerator),
                                                ttc_conditions_signs(&s->task->domain, value.denominator));
    may_eliminate = may_eliminate && signs == TTC_CAN_BE_ANY && ttc_task_open(s->task);
    const unsigned met = may_eliminate ? ttc_task_signs_met(s->task, &value) : TTC_CAN_BE_ANY;
    const bool may_be_positive = !(met & TTC_CAN_BE_NEGATIVE), may_be_negative = !(met & TTC_CAN_BE_POSITIVE);
    if (may_be_positive) signs = signs_by_elimination(s, &value, TTC_CAN_BE_POSITIVE);
    if (may_be_negative && signs == TTC_CAN_BE_ANY) signs = signs_by_elimination(s, &value, TTC_CAN_BE_NEGATIVE);
    may_search = may_search && may_eliminate && (signs & TTC_CAN_BE_ZERO);
    if (may_search && may_be_positive && (signs & TTC_CAN_BE_POSITIVE) && has_no_other_sign(s, &value, 1))
        signs = TTC_CAN_BE_POSITIVE;
    if (may_search && may_be_negative && (signs & TTC_CAN_BE_NEGATIVE) && has_no_other_sign(s, &value, -1))
        signs = TTC_CAN_BE_NEGATIVE;
    ttc_ratio_clear(s->task->ring, &value);
    return signs;
}

static unsigned signs_of_symbol(signs_of_parts *s, ttc_id id)
{
    const ttc_model *model = ttc_valuation_model(s->valuation);
    const uint32_t symbol = ttc_symbol_of(model->graph, id);
    if (symbol >= model->symbol_count || ttc_valuation_is_bound(s->valuation, symbol)) return signs_of_value(s, id, false, false);
    const ttc_symbol_entry *entry = model->symbols + symbol;
    if (entry->kind == TTC_LET) return signs_of(s, entry->definition);
    if (entry->kind == TTC_ROOT || entry->kind == TTC_EXP) return TTC_CAN_BE_POSITIVE;
    return signs_of_value(s, id, false, false);
}

/* Returns true if the expression is no sum, and no product with a sum as a factor. */
static bool is_simple(const ttc_graph *graph, ttc_id id)
{
    const ttc_kind kind = ttc_kind_of(graph, id);
    if (kind != TTC_PRODUCT) return kind != TTC_SUM;
    for (size_t i = 0; i < ttc_part_count(graph, id); i++)
        if (ttc_kind_of(graph, ttc_part_at(graph, id, i).id) == TTC_SUM) return false;
    return true;
}

/* Returns `sign`, or `sign` and zero, if a sum has no other sign, else TTC_CAN_BE_ANY. Terms that contain sums and are never of the
 * opposite sign count by their own signs; all other terms together are examined as one ratio. */
static unsigned signs_in_two_parts(signs_of_parts *s, ttc_id id, unsigned sign)
{
    ttc_graph *graph = ttc_valuation_model(s->valuation)->graph;
    const unsigned other = sign == TTC_CAN_BE_POSITIVE ? TTC_CAN_BE_NEGATIVE : TTC_CAN_BE_POSITIVE;
    ttc_id rest = ttc_number(graph, ttc_coefficient(graph, id));
    unsigned of_rest = ttc_conditions_sign_of(ttc_coefficient(graph, id)), aside = TTC_CAN_BE_ZERO, signs = TTC_CAN_BE_ANY;
    bool leaves_out = id != s->whole;
    ttc_ratio value;
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        const unsigned own = ttc_conditions_signs_of_product(ttc_conditions_sign_of(part.coefficient), signs_of(s, part.id));
        if (!(own & other) && !is_simple(graph, part.id)) {
            leaves_out = true;
            aside = ttc_conditions_signs_of_sum(aside, own);
            continue;
        }
        rest = ttc_add(graph, rest, ttc_scale(graph, part.id, part.coefficient));
        of_rest = ttc_conditions_signs_of_sum(of_rest, own);
    }
    if (!leaves_out || !(of_rest & sign) || rest == TTC_NONE) return TTC_CAN_BE_ANY;
    ttc_ratio_init(s->task->ring, &value);
    ttc_evaluate(s->valuation, &value, rest);
    if (ttc_task_open(s->task) && !(ttc_task_signs_met(s->task, &value) & other)) {
        signs = signs_by_elimination(s, &value, sign);
        if (signs != TTC_CAN_BE_ANY) signs = ttc_conditions_signs_of_sum(aside, signs);
        if (signs != sign && has_no_other_sign(s, &value, sign == TTC_CAN_BE_POSITIVE ? 1 : -1)) signs = sign;
    }
    ttc_ratio_clear(s->task->ring, &value);
    return signs;
}

static unsigned signs_of_sum(signs_of_parts *s, ttc_id id)
{
    const ttc_graph *graph = ttc_valuation_model(s->valuation)->graph;
    unsigned signs = ttc_conditions_sign_of(ttc_coefficient(graph, id));
    bool simple = true;
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        const unsigned own = ttc_conditions_signs_of_product(ttc_conditions_sign_of(part.coefficient), signs_of(s, part.id));
        signs = ttc_conditions_signs_of_sum(signs, own);
        simple = simple && is_simple(graph, part.id);
    }
    if (signs == TTC_CAN_BE_ANY && s->looks_closer)
        signs = ttc_one_state_signs(s->task, s->valuation, id, id == s->whole ? s->negative : NULL);
    if (signs != TTC_CAN_BE_ANY || !s->may_search) return signs;
    signs = signs_of_value(s, id, true, simple);
    if (simple || signs != TTC_CAN_BE_ANY) return signs;
    signs = signs_in_two_parts(s, id, TTC_CAN_BE_POSITIVE);
    return signs == TTC_CAN_BE_ANY ? signs_in_two_parts(s, id, TTC_CAN_BE_NEGATIVE) : signs;
}

/* The signs of a product, where its divisors are not zero. */
static unsigned signs_of_product(signs_of_parts *s, ttc_id id)
{
    const ttc_graph *graph = ttc_valuation_model(s->valuation)->graph;
    unsigned signs = ttc_conditions_sign_of(ttc_coefficient(graph, id));
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
                                                             : ttc_conditions_sign_of(ttc_coefficient(graph, id)));
    }
    return s->signs[id];
}

static bool follows(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_relation relation, bool may_search,
                    ttc_state_value *negative)
{
    const size_t size = ttc_graph_size(ttc_valuation_model(valuation)->graph) + 1;
    signs_of_parts s = { task, valuation, calloc(size, 1), id, !may_search, may_search, negative };
    const bool result = s.signs != NULL && (signs_of(&s, id) & ~ttc_conditions_signs_in(relation)) == 0;
    free(s.signs);
    return result;
}

static bool tell(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_relation relation, ttc_state_value *negative)
{
    if (follows(task, valuation, id, relation, false, negative)) return true;
    /* Where the whole has another sign, what its parts can be, which may take long, does not matter. */
    const bool is_known = negative != NULL && negative->is_known;
    if (!is_known && valuation == task->field && (ttc_task_signs_at_points(task, id) & ~ttc_conditions_signs_in(relation)) != 0)
        return false;
    return follows(task, valuation, id, relation, true, NULL);
}

bool ttc_signs_tell(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_relation relation)
{
    return tell(task, valuation, id, relation, NULL);
}

bool ttc_signs_are_one(ttc_task *task, ttc_id id)
{
    const ttc_graph *graph = task->model->graph;
    signs_of_parts s = { task, task->field, calloc(ttc_graph_size(graph) + 1, 1), id, false, false, NULL };
    unsigned signs = 0;
    for (size_t i = 0; s.signs != NULL && ttc_kind_of(graph, id) == TTC_SUM && i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        signs |= ttc_conditions_signs_of_product(ttc_conditions_sign_of(part.coefficient), signs_of(&s, part.id));
    }
    free(s.signs);
    return signs != 0 && fmpq_is_zero(ttc_coefficient(graph, id)) &&
           (signs & (TTC_CAN_BE_POSITIVE | TTC_CAN_BE_NEGATIVE)) != (TTC_CAN_BE_POSITIVE | TTC_CAN_BE_NEGATIVE);
}

/* Refute that a product is positive at a point where the base of an even power in it is zero. What was put aside, or left to the
 * solver, in a search that found no zero of a base is taken back. */
static void refute_at_square(ttc_task *task, ttc_valuation *valuation, ttc_id id, const char *what)
{
    const ttc_graph *graph = ttc_valuation_model(valuation)->graph;
    const size_t aside = task->aside_count;
    const bool relies = task->relies_on_solver;
    ttc_ratio base;
    if (task->has_left_out || ttc_kind_of(graph, id) != TTC_PRODUCT) return;
    ttc_ratio_init(task->ring, &base);
    for (size_t i = 0; i < ttc_part_count(graph, id) && ttc_task_open(task); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        char *point = NULL;
        if (part.exponent < 0 || part.exponent % 2 != 0) continue;
        ttc_evaluate(valuation, &base, part.id);
        if (!ttc_task_open(task) || ttc_task_search_against(task, &base, TTC_IS_NONZERO, &point) != TTC_POINT_FOUND) {
            free(point);
            continue;
        }
        ttc_evaluate(valuation, &base, id);
        /* A normal form that divides by something may have no value at this point. */
        const bool has_value = task->ring->status == TTC_RING_OK && fmpz_mpoly_is_fmpz(base.denominator, task->ring->context);
        ttc_task_refute_at(task, point, has_value ? &base : NULL, has_value ? "%s" : "%s = 0", what);
    }
    task->aside_count = aside;
    task->relies_on_solver = relies;
    ttc_ratio_clear(task->ring, &base);
}

static void require_value(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_relation relation, const char *what,
                          const ttc_state_value *negative)
{
    ttc_ratio value;
    char *point = NULL;
    if (relation == TTC_IS_POSITIVE) refute_at_square(task, valuation, id, what);
    const ttc_ring_status status = task->ring->status; /* the normal form may have failed: the point does not rest on it */
    task->ring->status = TTC_RING_OK;
    if (negative->is_known && valuation == task->field && relation == TTC_IS_POSITIVE && !task->has_left_out)
        point = ttc_task_point_with(task, negative->symbol, negative->value);
    task->ring->status = status;
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(valuation, &value, id);
    const bool is_first = task->unexcluded == TTC_NONE;
    const ttc_id written = ttc_model_without_lets(ttc_valuation_model(valuation), id);
    if (point != NULL) ttc_task_refute_at(task, point, task->ring->status == TTC_RING_OK ? &value : NULL, "%s", what);
    ttc_task_require(task, &value, relation, "%s", what);
    if (is_first && task->unexcluded != TTC_NONE && valuation == task->field && ttc_signs_are_one(task, written))
        task->unexcluded = written;
    ttc_ratio_clear(task->ring, &value);
}

static void require(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_relation relation, const char *what)
{
    const ttc_graph *graph = ttc_valuation_model(valuation)->graph;
    const size_t factors = relation == TTC_IS_NONZERO && ttc_kind_of(graph, id) == TTC_PRODUCT ? ttc_part_count(graph, id) : 0;
    for (size_t i = 0; i < factors; i++) require(task, valuation, ttc_part_at(graph, id, i).id, relation, what);
    if (factors > 0 || !ttc_task_open(task)) return;
    ttc_state_value negative = { .is_known = false };
    fmpq_init(negative.value);
    if (task->tested != NULL || !tell(task, valuation, id, relation, &negative))
        require_value(task, valuation, id, relation, what, &negative);
    fmpq_clear(negative.value);
}

void ttc_signs_require(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_relation relation, const char *format, ...)
{
    char what[2 * TTC_DIAGNOSTIC_LINE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    require(task, valuation, id, relation, what);
}
