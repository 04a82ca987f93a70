/* The flow on a leaf: rates of its variables, dependence on states, and whether the flow keeps a set. */
#include "prove/prove_task.h"

#include <stdlib.h>

/* Rates of all variables of the ring along the flow, shape (variable_count,), for ttc_task_free. NULL when memory is out. */
static ttc_ratio *slopes_of(ttc_task *task)
{
    const ttc_model *model = task->model;
    ttc_ratio *slopes = ttc_task_ratios(task, task->ring->variable_count);
    for (size_t i = 0; slopes != NULL && i < model->state_count; i++)
        if (!ttc_valuation_is_bound(task->field, model->states[i]))
            ttc_evaluate(task->field, &slopes[ttc_valuation_variable(task->field, model->states[i])], ttc_model_field(model, i));
    if (slopes != NULL) ttc_valuation_add_function_rates(task->field, slopes);
    return slopes;
}

bool ttc_task_restricts_states(const ttc_task *task)
{
    const ttc_bindings *when = &task->claim->when;
    for (size_t i = 0; i < when->count; i++) {
        if (task->model->symbols[when->items[i].symbol].kind == TTC_STATE) return true;
        for (size_t k = 0; k < task->model->state_count; k++)
            if (ttc_model_depends(task->model, when->items[i].expression, task->model->states[k])) return true;
    }
    return false;
}

static bool variable_moves(ttc_task *task, slong variable)
{
    const ttc_generator *root = ttc_ring_generator(task->ring, variable);
    const ttc_model *model = task->model;
    if (root != NULL) return ttc_task_moves(task, &root->square);
    size_t symbol = ttc_valuation_symbol(task->field, variable);
    if (symbol >= model->symbol_count) return true;
    if (model->symbols[symbol].kind == TTC_STATE || model->symbols[symbol].kind == TTC_ROOT) return true;
    if (!ttc_symbol_is_function(model->symbols[symbol].kind)) return false;
    ttc_ratio angle;
    ttc_ratio_init(task->ring, &angle);
    ttc_evaluate(task->field, &angle, model->symbols[symbol].definition);
    bool moves = ttc_task_moves(task, &angle);
    ttc_ratio_clear(task->ring, &angle);
    return moves;
}

/* Returns true unless the derivative by a free state is zero in form. */
static bool varies_with(ttc_task *task, const ttc_ratio *ratio, uint32_t state)
{
    ttc_ratio *slopes = ttc_task_ratios(task, task->ring->variable_count), rate;
    if (slopes == NULL) return true;
    ttc_ratio_init(task->ring, &rate);
    ttc_ratio_set_integer(task->ring, &slopes[ttc_valuation_variable(task->field, state)], 1);
    ttc_valuation_add_function_rates(task->field, slopes);
    ttc_ratio_derive(task->ring, &rate, ratio, slopes);
    const bool varies = !fmpz_mpoly_is_zero(rate.numerator, task->ring->context);
    ttc_ratio_clear(task->ring, &rate);
    ttc_task_free(task, slopes, task->ring->variable_count);
    return varies;
}

/* A ratio that uses states may be constant, such as sqrt(2 x)/sqrt(x): returns true if some derivative is nonzero in form. */
static bool varies(ttc_task *task, const ttc_ratio *ratio)
{
    const ttc_model *model = task->model;
    bool result = fmpz_mpoly_is_gen(ratio->numerator, -1, task->ring->context) &&
                  fmpz_mpoly_is_one(ratio->denominator, task->ring->context);
    for (size_t i = 0; !result && i < model->state_count; i++)
        result = !ttc_valuation_is_bound(task->field, model->states[i]) && varies_with(task, ratio, model->states[i]);
    return result;
}

bool ttc_task_moves(ttc_task *task, const ttc_ratio *ratio)
{
    for (slong v = 0; v < (slong)task->ring->variable_count; v++)
        if (ttc_ratio_uses(task->ring, ratio, v) && variable_moves(task, v)) return varies(task, ratio);
    return false;
}

/* Refute the claim at a real point of the leaf at which one of the first four derivatives by time of an expression is not zero. The
 * expression is zero on the level, but then not along the orbit of this point. */
static void refute_along_orbit(ttc_task *task, ttc_id derivative, const char *part)
{
    static const char *const orders[] = { "", "second ", "third ", "fourth " };
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; i < sizeof orders / sizeof *orders && derivative != TTC_NONE && ttc_task_open(task); i++) {
        derivative = ttc_derive_field(task->model, derivative);
        ttc_evaluate(task->field, &value, derivative);
        if (ttc_task_open(task) && ttc_task_search(task, &value, TTC_IS_NONZERO, NULL) == TTC_POINT_FOUND)
            ttc_task_require_zero(task, &value, "the set is left: %sderivative by time of %s%s", orders[i], part,
                                  task->claim->name);
    }
    ttc_ratio_clear(task->ring, &value);
}

/* The flow is not tangent to the leaf. Refute the claim along an orbit, or at a real point of the leaf that lies on no other
 * component, as the flow leaves the level there; otherwise it is not settled. Nothing is said of a leaf that has no point, as is
 * sometimes known only when roots that the rate alone uses have joined the ring. */
static void refute_kept(ttc_task *task, const ttc_symbol_entry *entry, const ttc_ratio *rate, bool by_angle)
{
    ttc_ratio others;
    size_t mark = ttc_conditions_mark(&task->domain);
    bool contradictory = task->domain.contradictory;
    if (!ttc_task_may_have_point(task)) {
        task->has_point = false;
        return;
    }
    ttc_ratio_init(task->ring, &others);
    if (task->apart != TTC_NONE) {
        ttc_evaluate(task->field, &others, task->apart);
        ttc_conditions_add(&task->domain, &others, TTC_IS_NONZERO);
    }
    if (!task->is_thin && ttc_task_search(task, rate, TTC_IS_NONZERO, NULL) == TTC_POINT_FOUND)
        ttc_task_require_zero(task, rate, by_angle ? "the set is left: rate of the angle of %s, which is fixed on it"
                                                   : "the set is left: rate of %s - rate of what it stands for", entry->name);
    ttc_conditions_rewind(&task->domain, mark, contradictory);
    refute_along_orbit(task, task->claim->expression, "");
    refute_along_orbit(task, task->radical, "the factors, each once, of ");
    ttc_task_unsettle(task, "the flow is not tangent to the set, by the rate of %s; that it leaves its real points was not shown",
                      entry->name);
    ttc_ratio_clear(task->ring, &others);
}

bool ttc_task_is_at_turn(ttc_task *task, const ttc_symbol_entry *entry)
{
    ttc_ratio sine;
    if (entry->kind != TTC_COSINE) return false;
    ttc_ratio_init(task->ring, &sine);
    ttc_evaluate(task->field, &sine, task->model->symbols[entry->partner].node);
    const bool zero = ttc_task_open(task) && ttc_ratio_is_zero(task->ring, &sine);
    ttc_ratio_clear(task->ring, &sine);
    return zero;
}

/* The rate of a bound symbol's expression must be the symbol's own: that of a state by its equation, zero for a parameter. For a
 * cosine bound to 1 or -1, the rate of its angle must be zero. */
static void require_symbol_kept(ttc_task *task, uint32_t symbol, const ttc_ratio *slopes, const char *hint)
{
    const ttc_symbol_entry *entry = &task->model->symbols[symbol];
    ttc_ratio value, rate;
    ttc_ratio_init(task->ring, &value);
    ttc_ratio_init(task->ring, &rate);
    const bool by_angle = ttc_task_is_at_turn(task, entry);
    ttc_evaluate(task->field, &value, entry->node);
    if (ttc_task_open(task) && !by_angle) ttc_ratio_derive(task->ring, &rate, &value, slopes);
    ttc_evaluate(task->field, &value, ttc_derive_field(task->model, by_angle ? entry->definition : entry->node));
    ttc_ratio_subtract(task->ring, &rate, &value, &rate);
    if (ttc_task_open(task) && hint != NULL && !ttc_ratio_is_zero(task->ring, &rate))
        ttc_task_unsettle(task, "the flow does not keep the set of the condition on %s (%s)", entry->name, hint);
    if (ttc_task_open(task) && !ttc_ratio_is_zero(task->ring, &rate)) refute_kept(task, entry, &rate, by_angle);
    ttc_ratio_clear(task->ring, &rate);
    ttc_ratio_clear(task->ring, &value);
}

void ttc_task_require_kept(ttc_task *task, const char *hint)
{
    const ttc_model *model = task->model;
    ttc_ratio *slopes = slopes_of(task);
    for (uint32_t i = 0; slopes != NULL && i < model->symbol_count && ttc_task_open(task); i++) {
        if (ttc_valuation_is_bound(task->field, i)) require_symbol_kept(task, i, slopes, hint);
    }
    ttc_task_free(task, slopes, task->ring->variable_count);
    task->kept += ttc_task_open(task);
}
