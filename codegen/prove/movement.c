#include "prove/movement.h"

#include "prove/image.h"
#include "prove/vanishing.h"

#include <stdlib.h>

/* Clear `moves` for all variables that a value uses, directly or in definitions of its roots and functions. */
static void hold(ttc_task *task, bool *moves, const ttc_ratio *value)
{
    const ttc_ring *ring = task->ring;
    const ttc_model *model = task->model;
    ttc_ratio of;
    ttc_ratio_init(task->ring, &of);
    for (slong v = 0; v < (slong)ring->variable_count; v++) {
        if (!moves[v] || !ttc_ratio_uses(ring, value, v)) continue;
        moves[v] = false;
        const ttc_generator *root = ttc_ring_generator(ring, v);
        if (root != NULL) hold(task, moves, &root->square);
        const size_t symbol = ttc_valuation_symbol(task->field, v);
        if (symbol >= model->symbol_count || model->symbols[symbol].definition == TTC_NONE) continue;
        ttc_evaluate(task->field, &of, model->symbols[symbol].definition);
        hold(task, moves, &of);
    }
    ttc_ratio_clear(task->ring, &of);
}

bool *ttc_movement_flags(ttc_task *task, const ttc_model *target)
{
    const ttc_bindings *given = &task->claim->bindings;
    const ttc_symbol_entry *symbols = task->model->symbols;
    bool *moves = ttc_vanishing_moves(task);
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; moves != NULL && i < given->count; i++) {
        if (ttc_param_of(target, task->claim->target_names[i]) == UINT32_MAX) continue;
        ttc_evaluate(task->field, &value, given->items[i].expression);
        hold(task, moves, &value);
    }
    for (uint32_t i = 1; moves != NULL && i < task->model->symbol_count; i++) {
        if (!ttc_valuation_is_bound(task->field, i) || symbols[i].kind == TTC_STATE) continue;
        ttc_evaluate(task->field, &value, symbols[i].kind == TTC_COSINE ? symbols[i].definition : symbols[i].node);
        hold(task, moves, &value);
    }
    ttc_ratio_clear(task->ring, &value);
    return moves;
}

/* Add that a ratio and its derivatives by the free states that move are zero. */
static void add_flat(ttc_task *task, const ttc_ratio *ratio, const bool *moves)
{
    ttc_ratio rate;
    ttc_ratio_init(task->ring, &rate);
    ttc_conditions_add(&task->domain, ratio, TTC_IS_ZERO);
    for (size_t i = 0; i < task->model->state_count; i++) {
        const uint32_t state = task->model->states[i];
        if (ttc_valuation_is_bound(task->field, state) || !moves[ttc_valuation_variable(task->field, state)]) continue;
        ttc_ratio *slopes = ttc_task_ratios(task, task->ring->variable_count);
        if (slopes == NULL) break;
        ttc_ratio_set_integer(task->ring, &slopes[ttc_valuation_variable(task->field, state)], 1);
        ttc_valuation_add_function_rates(task->field, slopes);
        ttc_ratio_set_integer(task->ring, &rate, 0);
        ttc_ratio_derive(task->ring, &rate, ratio, slopes);
        ttc_conditions_add(&task->domain, &rate, TTC_IS_ZERO);
        ttc_task_free(task, slopes, task->ring->variable_count);
    }
    ttc_ratio_clear(task->ring, &rate);
}

/* Returns true for a square root by which a level was solved, if its square changes with what moves. */
static bool is_solved_root(const ttc_task *task, const ttc_generator *generator, const bool *moves)
{
    const ttc_model *model = task->model;
    const size_t symbol = ttc_valuation_symbol(task->field, generator->variable);
    const bool is_sine = symbol < model->symbol_count && model->symbols[symbol].kind == TTC_SINE &&
                         !ttc_valuation_is_bound(task->field, model->symbols[symbol].partner);
    bool uses = false;
    for (slong v = 0; v < (slong)task->ring->variable_count && !uses; v++)
        uses = moves[v] && ttc_ratio_uses(task->ring, &generator->square, v);
    return uses && !generator->positive && !is_sine;
}

bool ttc_movement_may_be_thin(ttc_task *task, const bool *moves)
{
    const ttc_ring *ring = task->ring;
    const size_t mark = ttc_conditions_mark(&task->domain);
    const bool contradictory = task->domain.contradictory;
    bool thin = false;
    for (size_t i = 0; i < ring->generator_count && !thin; i++)
        for (size_t k = 0; k <= i && !thin && is_solved_root(task, &ring->generators[i], moves); k++) {
            if (!is_solved_root(task, &ring->generators[k], moves)) continue;
            ttc_conditions_add(&task->domain, &ring->generators[i].square, TTC_IS_ZERO);
            if (k < i) ttc_conditions_add(&task->domain, &ring->generators[k].square, TTC_IS_ZERO);
            else add_flat(task, &ring->generators[i].square, moves);
            thin = ttc_task_may_have_point(task);
            ttc_conditions_rewind(&task->domain, mark, contradictory);
        }
    return thin;
}
