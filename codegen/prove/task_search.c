/* Searches for points of a leaf, also where normal forms have no values. */
#include "algebra/elimination.h"
#include "prove/question.h"
#include "prove/subcase.h"

/* Add that the roots of a map that have a value are positive; not those that are bound, for which this has to be shown. */
static void add_roots_of_map(ttc_task *task, ttc_valuation *map, ttc_ratio *value)
{
    const ttc_model *model = ttc_valuation_model(map);
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        const bool is_given = ttc_valuation_is_bound(map, i);
        if (model->symbols[i].kind != TTC_ROOT || is_given || !ttc_valuation_has_value(map, i)) continue;
        ttc_evaluate(map, value, model->symbols[i].node);
        ttc_conditions_add(&task->domain, value, TTC_IS_POSITIVE);
    }
}

/* Add that roots adjoined since the domain was made are positive, and that square roots by which levels were solved are real. */
static void add_new_roots(ttc_task *task)
{
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; i < task->map_count; i++) add_roots_of_map(task, task->maps[i], &value);
    for (size_t i = 0; i < task->ring->generator_count; i++)
        if (!task->ring->generators[i].positive)
            ttc_conditions_add(&task->domain, &task->ring->generators[i].square, TTC_IS_NONNEGATIVE);
    for (uint32_t i = 0; i < task->model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &task->model->symbols[i];
        if (entry->kind != TTC_ROOT || !ttc_valuation_has_value(task->field, i)) continue;
        if (ttc_question_has(task, i)) continue; /* this is to be shown */
        ttc_evaluate(task->field, &value, entry->node);
        ttc_conditions_add(&task->domain, &value, TTC_IS_POSITIVE);
    }
    ttc_ratio_clear(task->ring, &value);
}

static bool says_none(ttc_search_result result) { return result == TTC_POINT_IMPOSSIBLE || result == TTC_POINT_EXCLUDED; }

ttc_id ttc_task_expression(ttc_task *task, const fmpz_mpoly_struct *polynomial)
{
    for (size_t v = 0; v < task->ring->variable_count; v++)
        if (fmpz_mpoly_degree_si(polynomial, (slong)v, task->ring->context) > 0 &&
            ttc_valuation_symbol(task->field, (slong)v) >= task->model->symbol_count)
            return TTC_NONE;
    return ttc_subcase_expression(task, polynomial);
}

bool ttc_task_put_aside(ttc_task *task, const fmpz_mpoly_struct *denominator)
{
    if (!(ttc_conditions_signs(&task->domain, denominator) & TTC_CAN_BE_ZERO)) return true;
    const ttc_id zero = ttc_task_expression(task, denominator);
    if (zero == TTC_NONE) return false;
    for (size_t i = task->aside_first; i < task->aside_count; i++)
        if (task->aside[i] == zero) return true;
    if (task->aside_count == sizeof task->aside / sizeof *task->aside) return false;
    task->aside[task->aside_count++] = zero;
    return true;
}

/* Returns true if conditions have no point, and remembers in the task if that rests on the solver. */
static bool has_no_point(ttc_task *task, ttc_witness *point, const ttc_conditions *conditions)
{
    const ttc_search_result result = ttc_search_point(point, conditions);
    if (result == TTC_POINT_EXCLUDED) task->relies_on_solver = true;
    return says_none(result);
}

/* Denominators of normal forms may vanish where the expressions have values: returns true if there are no points there either, or
 * if these points are put aside. */
static bool looked_everywhere(ttc_task *task, ttc_witness *point, bool may_put_aside)
{
    bool everywhere = true, again = true;
    for (size_t i = 0; everywhere && again; i++) {
        ttc_conditions there;
        const fmpz_mpoly_struct *zero = ttc_conditions_at_denominator(&there, &task->domain, i);
        again = zero != NULL;
        everywhere = !again || has_no_point(task, point, &there) || (may_put_aside && ttc_task_put_aside(task, zero));
        ttc_conditions_clear(&there);
    }
    return everywhere;
}

/* v *= d^2 for a divisor d, by its factors, as often as that takes something from the denominator of v. */
static void multiply_by_square(ttc_task *task, ttc_ratio *v, ttc_valuation *valuation, ttc_id divisor)
{
    const ttc_graph *graph = ttc_valuation_model(valuation)->graph;
    const fmpz_mpoly_ctx_struct *context = task->ring->context;
    ttc_ratio square, product;
    if (ttc_kind_of(graph, divisor) == TTC_PRODUCT) {
        for (size_t i = 0; i < ttc_part_count(graph, divisor); i++)
            multiply_by_square(task, v, valuation, ttc_part_at(graph, divisor, i).id);
        return;
    }
    if (!ttc_valuation_has_met(valuation, divisor)) return;
    ttc_ratio_init(task->ring, &square);
    ttc_ratio_init(task->ring, &product);
    ttc_evaluate(valuation, &square, divisor);
    fmpz_mpoly_one(square.denominator, context);
    ttc_ratio_multiply(task->ring, &square, &square, &square);
    for (bool again = true; again && task->ring->status == TTC_RING_OK;) {
        ttc_ratio_multiply(task->ring, &product, v, &square);
        again = fmpz_mpoly_total_degree_si(product.denominator, context) < fmpz_mpoly_total_degree_si(v->denominator, context);
        if (again) ttc_ratio_set(task->ring, v, &product);
    }
    ttc_ratio_clear(task->ring, &product);
    ttc_ratio_clear(task->ring, &square);
}

/* A value v, times squares of what it may divide by, is A/B in normal form, and A B has the sign of v or is zero: also where the
 * denominator of v itself vanishes, as x does in x/(1 + r) = (r - 1)/x with r^2 = 1 + x^2. */
static void add_sign(ttc_task *task, const ttc_ratio *ratio, bool negative)
{
    ttc_ratio value, below;
    ttc_ratio_init(task->ring, &value);
    ttc_ratio_init(task->ring, &below);
    ttc_ratio_set(task->ring, &value, ratio);
    for (size_t k = 0; k <= task->map_count; k++) {
        ttc_valuation *valuation = k < task->map_count ? task->maps[k] : task->field;
        const ttc_model *model = ttc_valuation_model(valuation);
        for (size_t i = 0; i < model->divisor_count; i++) multiply_by_square(task, &value, valuation, model->divisors[i].divisor);
    }
    ttc_ratio_set_polynomial(task->ring, &below, value.denominator);
    fmpz_mpoly_one(value.denominator, task->ring->context);
    ttc_ratio_multiply(task->ring, &value, &value, &below);
    if (negative) ttc_conditions_add_negative(&task->domain, &value, TTC_IS_NONNEGATIVE);
    else ttc_conditions_add(&task->domain, &value, TTC_IS_NONNEGATIVE);
    ttc_ratio_clear(task->ring, &below);
    ttc_ratio_clear(task->ring, &value);
}

/* Returns true if what is known of signs excludes that a ratio, or its opposite, stands in this relation to zero. */
static bool is_excluded(const ttc_task *task, const ttc_ratio *ratio, ttc_relation relation, bool negative)
{
    unsigned signs = ttc_conditions_signs_of_ratio(&task->domain, ratio);
    if (negative) signs = ttc_conditions_signs_of_product(signs, TTC_CAN_BE_NEGATIVE);
    return (signs & ttc_conditions_signs_in(relation)) == 0;
}

/* Search for a point at which a ratio, or with `negative` its opposite, stands in this relation to zero. */
static ttc_search_result search(ttc_task *task, const ttc_ratio *ratio, ttc_relation relation, bool negative, bool may_put_aside,
                                char **text)
{
    ttc_search_result result = TTC_POINT_NOT_DECIDED;
    ttc_witness point;
    const bool of_sign = ratio != NULL && (relation == TTC_IS_POSITIVE || relation == TTC_IS_NONNEGATIVE) &&
                         task->extent == TTC_DOMAIN_WHOLE;
    if (text != NULL) *text = NULL;
    add_new_roots(task);
    if (ratio != NULL && is_excluded(task, ratio, relation, negative)) return TTC_POINT_IMPOSSIBLE;
    size_t mark = ttc_conditions_mark(&task->domain);
    bool contradictory = task->domain.contradictory;
    if (ratio != NULL && negative) ttc_conditions_add_negative(&task->domain, ratio, relation);
    else if (ratio != NULL) ttc_conditions_add(&task->domain, ratio, relation);
    if (ttc_witness_init(&point, task->field)) {
        result = ttc_search_point(&point, &task->domain);
        if (says_none(result) && !looked_everywhere(task, &point, false)) {
            if (of_sign) add_sign(task, ratio, negative);
            const bool again = of_sign || may_put_aside;
            result = again && looked_everywhere(task, &point, may_put_aside) ? TTC_POINT_EXCLUDED : TTC_POINT_NOT_DECIDED;
        }
        if (result == TTC_POINT_FOUND && text != NULL) *text = ttc_witness_text(&point);
    }
    ttc_witness_clear(&point);
    ttc_conditions_rewind(&task->domain, mark, contradictory);
    if (result == TTC_POINT_EXCLUDED) task->relies_on_solver = true;
    return result;
}

ttc_search_result ttc_task_search(ttc_task *task, const ttc_ratio *ratio, ttc_relation relation, char **text)
{
    return search(task, ratio, relation, false, false, text);
}

bool ttc_task_never_is(ttc_task *task, const ttc_ratio *ratio, ttc_relation relation)
{
    ttc_conditions everywhere;
    if (ttc_conditions_signs(&task->domain, ratio->denominator) & TTC_CAN_BE_ZERO) return false;
    ttc_conditions_at_denominator(&everywhere, &task->domain, SIZE_MAX);
    ttc_conditions_add(&everywhere, ratio, relation);
    const bool never = ttc_elimination_excludes(&everywhere);
    ttc_conditions_clear(&everywhere);
    return never;
}

unsigned ttc_task_signs_met(ttc_task *task, const ttc_ratio *ratio)
{
    enum { ATTEMPTS = 6, PRECISION = 64 };
    const size_t mark = ttc_conditions_mark(&task->domain);
    const bool contradictory = task->domain.contradictory;
    unsigned signs = 0;
    ttc_witness point;
    arb_t value;
    arb_init(value);
    add_new_roots(task);
    if (ttc_witness_init(&point, task->field))
        for (unsigned i = 0; i < ATTEMPTS && signs != (TTC_CAN_BE_NEGATIVE | TTC_CAN_BE_POSITIVE); i++) {
            if (!ttc_search_attempt(&point, &task->domain, i)) continue;
            ttc_witness_enclose(value, &point, ratio, PRECISION);
            signs |= arb_is_positive(value) ? TTC_CAN_BE_POSITIVE : arb_is_negative(value) ? TTC_CAN_BE_NEGATIVE : 0;
        }
    ttc_witness_clear(&point);
    arb_clear(value);
    ttc_conditions_rewind(&task->domain, mark, contradictory);
    return signs;
}

static const ttc_relation opposite[] = { [TTC_IS_POSITIVE] = TTC_IS_NONNEGATIVE, [TTC_IS_NONNEGATIVE] = TTC_IS_POSITIVE,
                                         [TTC_IS_NONZERO] = TTC_IS_ZERO, [TTC_IS_ZERO] = TTC_IS_NONZERO };

/* Search further for a point at which a ratio does not stand in this relation to zero. For != 0, a zero between two signs of a
 * factor; for > 0, the same of a factor of even exponent; then for > 0 and >= 0 a value that is too low, downhill. */
static bool is_found_further(ttc_task *task, const ttc_ratio *ratio, ttc_relation relation, char **text)
{
    bool found = false;
    ttc_witness point;
    ttc_ratio below;
    const size_t mark = ttc_conditions_mark(&task->domain);
    const bool contradictory = task->domain.contradictory;
    ttc_ratio_init(task->ring, &below);
    ttc_ratio_set_polynomial(task->ring, &below, ratio->denominator);
    ttc_conditions_add(&task->domain, &below, TTC_IS_NONZERO);
    const size_t domain = ttc_conditions_mark(&task->domain);
    if (ttc_witness_init(&point, task->field)) {
        if (relation == TTC_IS_POSITIVE || relation == TTC_IS_NONZERO)
            found = ttc_search_zero(&point, &task->domain, ratio->numerator, relation == TTC_IS_POSITIVE);
        if (!found && relation != TTC_IS_NONZERO) {
            ttc_conditions_add_negative(&task->domain, ratio, opposite[relation]);
            found = ttc_search_downhill(&point, &task->domain, domain, ratio);
        }
    }
    if (found && text != NULL) *text = ttc_witness_text(&point);
    ttc_witness_clear(&point);
    ttc_conditions_rewind(&task->domain, mark, contradictory);
    ttc_ratio_clear(task->ring, &below);
    return found;
}

ttc_search_result ttc_task_search_against(ttc_task *task, const ttc_ratio *ratio, ttc_relation relation, char **text)
{
    const ttc_claim_kind kind = task->claim->kind;
    const bool of_all_points = kind != TTC_CLAIM_INVARIANT && kind != TTC_CLAIM_OBSTRUCTS;
    const bool of_opposite = relation == TTC_IS_POSITIVE || relation == TTC_IS_NONNEGATIVE;
    const ttc_search_result result = search(task, ratio, opposite[relation], of_opposite, of_all_points, text);
    if (result == TTC_POINT_NOT_DECIDED && relation != TTC_IS_ZERO && is_found_further(task, ratio, relation, text))
        return TTC_POINT_FOUND;
    return result;
}

char *ttc_task_point_with(ttc_task *task, uint32_t state, const fmpq_t value)
{
    char *text = NULL;
    ttc_witness point;
    const slong variable = ttc_valuation_variable(task->field, state);
    add_new_roots(task);
    if (ttc_witness_init(&point, task->field) && variable >= 0 && ttc_witness_is_free(&point, variable)
        && ttc_search_with(&point, &task->domain, variable, value))
        text = ttc_witness_text(&point);
    ttc_witness_clear(&point);
    return text;
}

char *ttc_task_zero_of(ttc_task *task, const ttc_ratio *value)
{
    char *text = NULL;
    ttc_witness point;
    add_new_roots(task);
    if (ttc_witness_init(&point, task->field) && ttc_search_zero(&point, &task->domain, value->numerator, false))
        text = ttc_witness_text(&point);
    ttc_witness_clear(&point);
    return text;
}

bool ttc_task_may_have_point(ttc_task *task) { return !says_none(ttc_task_search(task, NULL, TTC_IS_ZERO, NULL)); }
