/* Signs of sines and cosines on the domain, where the interval of a state keeps the angle within half a turn. */
#include "prove/domain.h"
#include "prove/question.h"

/* Returns true if, by the signs of its terms, the expression never has one of these signs. */
static bool is_never(ttc_task *task, const ttc_conditions *c, ttc_id id, unsigned signs, ttc_ratio *value)
{
    ttc_evaluate(task->field, value, id);
    if (task->ring->status != TTC_RING_OK) return false;
    fmpz_mpoly_mul(value->numerator, value->numerator, value->denominator, task->ring->context);
    return !(ttc_conditions_signs(c, value->numerator) & signs);
}

/* An angle that is linear in a state lies between its values at the ends of the interval. If these, with some quarter turns added,
 * lie between 0 and half a turn, the sine of the angle so turned is positive: it is S, C, -S or -C.
 * half: half a turn, pi or the number 3, which is less, so that only as many turns are added as leave the statement true. */
static void add_sign(ttc_task *task, ttc_conditions *c, uint32_t cosine, size_t state, ttc_id half, ttc_ratio *value)
{
    const ttc_model *model = task->model;
    ttc_graph *graph = model->graph;
    const ttc_symbol_entry *entry = &model->symbols[cosine], *x = &model->symbols[model->states[state]];
    const ttc_id slope = ttc_derive_state(model, entry->definition, state);
    if (x->low == TTC_NONE || x->high == TTC_NONE || ttc_derive_state(model, slope, state) != ttc_integer(graph, 0) ||
        !is_never(task, c, slope, TTC_CAN_BE_ZERO, value))
        return;
    const ttc_id ends[] = { ttc_add(graph, entry->definition, ttc_multiply(graph, slope, ttc_subtract(graph, x->low, x->node))),
                            ttc_add(graph, entry->definition, ttc_multiply(graph, slope, ttc_subtract(graph, x->high, x->node))) };
    const bool exact = ttc_kind_of(graph, half) == TTC_SYMBOL;
    for (int quarters = exact ? -3 : 0; quarters <= (exact ? 4 : 2); quarters++) {
        const ttc_id turned = ttc_divide(graph, ttc_multiply(graph, half, ttc_integer(graph, quarters)), ttc_integer(graph, 2));
        bool within = true;
        for (int i = 0; within && i < 2; i++) {
            const ttc_id angle = ttc_add(graph, ends[i], turned);
            within = is_never(task, c, angle, TTC_CAN_BE_NEGATIVE, value) &&
                     is_never(task, c, ttc_subtract(graph, half, angle), TTC_CAN_BE_NEGATIVE, value);
        }
        if (!within) continue;
        ttc_evaluate(task->field, value, quarters % 2 == 0 ? model->symbols[entry->partner].node : entry->node);
        if ((quarters & 3) >= 2) ttc_conditions_add_negative(c, value, TTC_IS_POSITIVE);
        else ttc_conditions_add(c, value, TTC_IS_POSITIVE);
    }
}

void ttc_domain_add_angle(ttc_task *task, ttc_conditions *c, uint32_t cosine)
{
    ttc_ratio value;
    if (ttc_question_depends(task, task->model->symbols[cosine].node)) return;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; i < task->model->state_count; i++) {
        add_sign(task, c, cosine, i, ttc_integer(task->model->graph, 3), &value);
        for (size_t k = 0; k < task->model->symbol_count; k++)
            if (task->model->symbols[k].kind == TTC_PI) add_sign(task, c, cosine, i, task->model->symbols[k].node, &value);
    }
    ttc_ratio_clear(task->ring, &value);
}
