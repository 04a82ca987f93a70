/* The flow on a leaf: rates of its free variables, what moves, and whether a set is kept. */
#include "prove/prove_task.h"

#include <stdlib.h>

/* d cos(a) = -sin(a) da; the sine follows, as a root of 1 - cos^2. */
static void add_cosine(ttc_task *task, ttc_ratio *slopes, uint32_t symbol)
{
    const ttc_model *model = task->model;
    slong variable = ttc_valuation_variable(task->field, symbol);
    ttc_ratio angle, rate;
    ttc_ratio_init(task->ring, &angle);
    ttc_ratio_init(task->ring, &rate);
    ttc_evaluate(task->field, &angle, model->symbols[symbol].definition);
    ttc_ratio_derive(task->ring, &rate, &angle, slopes);
    ttc_evaluate(task->field, &angle, model->symbols[model->symbols[symbol].partner].node);
    ttc_ratio_multiply(task->ring, &rate, &rate, &angle);
    ttc_ratio_scale(task->ring, &slopes[variable], &rate, task->ring->minus_one);
    ttc_ratio_clear(task->ring, &rate);
    ttc_ratio_clear(task->ring, &angle);
}

ttc_ratio *ttc_task_slopes(ttc_task *task)
{
    const ttc_model *model = task->model;
    ttc_ratio *slopes = ttc_task_ratios(task, task->ring->variable_count);
    for (size_t i = 0; slopes != NULL && i < model->state_count; i++)
        if (!ttc_valuation_is_bound(task->field, model->states[i]))
            ttc_evaluate(task->field, &slopes[ttc_valuation_variable(task->field, model->states[i])], ttc_model_field(model, i));
    for (uint32_t i = 0; slopes != NULL && i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_COSINE && ttc_valuation_has_value(task->field, i)) add_cosine(task, slopes, i);
    return slopes;
}

static bool variable_moves(ttc_task *task, slong variable)
{
    const ttc_ring *ring = task->ring;
    const ttc_model *model = task->model;
    for (size_t i = 0; i < ring->generator_count; i++)
        if (ring->generators[i].variable == variable) return ttc_task_moves(task, &ring->generators[i].square);
    size_t symbol = ttc_valuation_symbol(task->field, variable);
    if (symbol >= model->symbol_count) return true;
    if (model->symbols[symbol].kind == TTC_STATE || model->symbols[symbol].kind == TTC_ROOT) return true;
    if (model->symbols[symbol].kind != TTC_COSINE) return false;
    ttc_ratio angle;
    ttc_ratio_init(task->ring, &angle);
    ttc_evaluate(task->field, &angle, model->symbols[symbol].definition);
    bool moves = ttc_task_moves(task, &angle);
    ttc_ratio_clear(task->ring, &angle);
    return moves;
}

bool ttc_task_moves(ttc_task *task, const ttc_ratio *ratio)
{
    for (slong v = 0; v < (slong)task->ring->variable_count; v++)
        if (ttc_ratio_uses(task->ring, ratio, v) && variable_moves(task, v)) return true;
    return false;
}

/* A symbol that follows from the free ones must move as they make it move: a state by its equation, a parameter not at all. */
static void require_symbol_kept(ttc_task *task, uint32_t symbol, const ttc_ratio *slopes, const char *hint)
{
    const ttc_symbol_entry *entry = &task->model->symbols[symbol];
    ttc_ratio value, rate;
    ttc_ratio_init(task->ring, &value);
    ttc_ratio_init(task->ring, &rate);
    ttc_evaluate(task->field, &value, entry->node);
    if (ttc_task_open(task)) ttc_ratio_derive(task->ring, &rate, &value, slopes);
    ttc_evaluate(task->field, &value, ttc_derive_field(task->model, entry->node));
    ttc_ratio_subtract(task->ring, &rate, &value, &rate);
    if (ttc_task_open(task) && hint != NULL && !ttc_ratio_is_zero(task->ring, &rate))
        ttc_task_unsettle(task, "the flow does not keep the set of the condition on %s (%s)", entry->name, hint);
    ttc_task_require_zero(task, &rate, "the set is left: rate of %s - rate of what it stands for", entry->name);
    ttc_ratio_clear(task->ring, &rate);
    ttc_ratio_clear(task->ring, &value);
}

void ttc_task_require_kept(ttc_task *task, const char *hint)
{
    const ttc_model *model = task->model;
    ttc_ratio *slopes = ttc_task_slopes(task);
    for (uint32_t i = 0; slopes != NULL && i < model->symbol_count && ttc_task_open(task); i++) {
        if (ttc_valuation_is_bound(task->field, i)) require_symbol_kept(task, i, slopes, hint);
    }
    ttc_task_free(task, slopes, task->ring->variable_count);
}
