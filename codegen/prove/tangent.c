#include "prove/tangent.h"

#include <stdlib.h>

void ttc_tangent_gradient(ttc_task *task, const ttc_tangent *t, ttc_ratio *row, ttc_id expression)
{
    const size_t n = task->model->state_count;
    ttc_ratio partial;
    ttc_ratio_init(task->ring, &partial);
    for (size_t j = 0; j < n && ttc_task_open(task); j++) {
        ttc_evaluate(task->field, &partial, ttc_derive_state(task->model, expression, j));
        for (size_t k = 0; k < t->columns; k++) ttc_ratio_add_product(task->ring, &row[k], &partial, &t->states[k * n + j]);
    }
    ttc_ratio_clear(task->ring, &partial);
}

/* out[k * stride] = the derivative by free state k of the value of the symbol `node`. slopes: as of find_slopes. */
static void add_rates(ttc_task *task, ttc_ratio *out, size_t stride, ttc_id node, ttc_ratio *const *slopes, size_t columns)
{
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &value, node);
    for (size_t k = 0; k < columns && ttc_task_open(task); k++)
        ttc_ratio_derive(task->ring, &out[k * stride], &value, slopes[k]);
    ttc_ratio_clear(task->ring, &value);
}

static void find_states(ttc_task *task, ttc_tangent *t, ttc_ratio *const *slopes)
{
    const ttc_model *model = task->model;
    for (size_t j = 0; j < model->state_count && ttc_task_open(task); j++)
        add_rates(task, t->states + j, model->state_count, model->symbols[model->states[j]].node, slopes, t->columns);
}

/* Add the constraint of a bound symbol. The expression of a parameter or level is constant. The derivative of a cosine's expression
 * equals that of the cosine by its angle; where it is 1 or -1, its angle is constant. */
static void add_constraint(ttc_task *task, ttc_tangent *t, uint32_t symbol, ttc_ratio *const *slopes)
{
    const ttc_symbol_entry *entry = task->model->symbols + symbol;
    ttc_ratio *row = t->constraints + t->constraint_count++ * t->columns;
    if (entry->kind != TTC_COSINE) {
        add_rates(task, row, 1, entry->node, slopes, t->columns);
        return;
    }
    const bool by_angle = ttc_task_is_at_turn(task, entry);
    if (!by_angle) add_rates(task, row, 1, entry->node, slopes, t->columns);
    for (size_t k = 0; k < t->columns; k++) ttc_ratio_scale(task->ring, &row[k], &row[k], task->ring->minus_one);
    ttc_tangent_gradient(task, t, row, by_angle ? entry->definition : entry->node);
}

static bool is_constraint(const ttc_task *task, uint32_t symbol)
{
    return ttc_valuation_is_bound(task->field, symbol) && task->model->symbols[symbol].kind != TTC_STATE;
}

/* slopes[k]: derivatives of all variables by free state k, shape (variable_count,). Returns false when memory is out. */
static bool find_slopes(ttc_task *task, ttc_ratio **slopes)
{
    const ttc_model *model = task->model;
    size_t k = 0;
    for (size_t i = 0; i < model->state_count; i++) {
        if (ttc_valuation_is_bound(task->field, model->states[i])) continue;
        slopes[k] = ttc_task_ratios(task, task->ring->variable_count);
        if (slopes[k] == NULL) return false;
        ttc_ratio_set_integer(task->ring, &slopes[k][ttc_valuation_variable(task->field, model->states[i])], 1);
        ttc_valuation_add_function_rates(task->field, slopes[k++]);
    }
    return true;
}

bool ttc_tangent_init(ttc_task *task, ttc_tangent *t)
{
    const ttc_model *model = task->model;
    size_t bound = 0;
    *t = (ttc_tangent){ .columns = 0 };
    for (size_t i = 0; i < model->state_count; i++) t->columns += !ttc_valuation_is_bound(task->field, model->states[i]);
    for (uint32_t i = 0; i < model->symbol_count; i++) bound += is_constraint(task, i);
    ttc_ratio **slopes = calloc(t->columns + 1, sizeof *slopes);
    t->states = ttc_task_ratios(task, t->columns * model->state_count);
    t->constraints = ttc_task_ratios(task, bound * t->columns);
    if (slopes == NULL) ttc_task_unsettle(task, "out of memory");
    bool ok = slopes != NULL && t->states != NULL && t->constraints != NULL && find_slopes(task, slopes);
    if (ok) find_states(task, t, slopes);
    for (uint32_t i = 0; ok && i < model->symbol_count; i++)
        if (is_constraint(task, i)) add_constraint(task, t, i, slopes);
    for (size_t k = 0; slopes != NULL && k < t->columns; k++) ttc_task_free(task, slopes[k], task->ring->variable_count);
    free(slopes);
    return ok;
}

void ttc_tangent_clear(ttc_task *task, ttc_tangent *t)
{
    ttc_task_free(task, t->constraints, t->constraint_count * t->columns);
    ttc_task_free(task, t->states, t->columns * task->model->state_count);
}
