/* Signs of sines and cosines on the domain, where the interval of a state keeps the angle within half a turn. */
#include "prove/domain.h"
#include "prove/one_state.h"
#include "prove/question.h"

#include "algebra/angle.h"

/* Returns true if, by the signs of its terms or as a number, the expression never has one of these signs. */
static bool is_never(ttc_task *task, const ttc_conditions *c, ttc_id id, unsigned signs, ttc_ratio *value)
{
    ttc_evaluate(task->field, value, id);
    if (task->ring->status != TTC_RING_OK) return false;
    fmpz_mpoly_mul(value->numerator, value->numerator, value->denominator, task->ring->context);
    return !(ttc_conditions_signs(c, value->numerator) & signs) || !(ttc_one_state_signs(task, task->field, id, NULL) & signs);
}

/* Add that the sine of an angle, with so many quarter turns added, is positive, if the sum lies between 0 and half a turn at both
 * ends of the state's interval.
 * half: half a turn: pi, or the number 3 in its place, with which this holds for 0, 1 or 2 quarter turns, and no pi is needed. */
static void add_turned(ttc_task *task, ttc_conditions *c, uint32_t cosine, const ttc_id ends[2], ttc_id half, const fmpq_t quarters)
{
    ttc_graph *graph = task->model->graph;
    const ttc_id turned = ttc_divide(graph, ttc_scale(graph, half, quarters), ttc_integer(graph, 2));
    bool within = true;
    ttc_ratio value, sine;
    ttc_ratio_init(task->ring, &value);
    ttc_ratio_init(task->ring, &sine);
    for (int i = 0; within && i < 2; i++) {
        const ttc_id angle = ttc_add(graph, ends[i], turned);
        within = is_never(task, c, angle, TTC_CAN_BE_NEGATIVE, &value) &&
                 is_never(task, c, ttc_subtract(graph, half, angle), TTC_CAN_BE_NEGATIVE, &value);
    }
    if (within) {
        ttc_evaluate(task->field, &value, task->model->symbols[cosine].node);
        ttc_evaluate(task->field, &sine, task->model->symbols[task->model->symbols[cosine].partner].node);
    }
    if (within && task->ring->status == TTC_RING_OK) {
        ttc_angle_turn_exactly(task->ring, &value, &sine, quarters);
        if (task->ring->status == TTC_RING_OK) ttc_conditions_add(c, &sine, TTC_IS_POSITIVE);
        else if (task->ring->status != TTC_RING_NO_MEMORY) task->ring->status = TTC_RING_OK; /* no room for roots of numbers */
    }
    ttc_ratio_clear(task->ring, &sine);
    ttc_ratio_clear(task->ring, &value);
}

/* The same with the turns that take an end to 0, and to half a turn, if the end is k pi/12. The cosines of these turns need no
 * roots but those of 2 and 3: more roots, and roots within roots, take longer than they are worth. */
static void add_turned_ends(ttc_task *task, ttc_conditions *c, uint32_t cosine, const ttc_id ends[2], ttc_id half)
{
    enum { PARTS = 6 /* of a quarter turn */ };
    const fmpz_mpoly_ctx_struct *context = task->ring->context;
    ttc_graph *graph = task->model->graph;
    ttc_ratio value;
    fmpq_t quarters;
    ttc_ratio_init(task->ring, &value);
    fmpq_init(quarters);
    for (int i = 0; i < 2 && task->ring->status == TTC_RING_OK; i++) {
        ttc_evaluate(task->field, &value, ttc_divide(graph, ttc_multiply(graph, ends[i], ttc_integer(graph, -2)), half));
        if (task->ring->status != TTC_RING_OK || !fmpz_mpoly_is_fmpz(value.numerator, context)
            || !fmpz_mpoly_is_fmpz(value.denominator, context)) continue;
        fmpz_mpoly_get_fmpz(fmpq_numref(quarters), value.numerator, context);
        fmpz_mpoly_get_fmpz(fmpq_denref(quarters), value.denominator, context);
        const ulong parts = fmpz_abs_fits_ui(fmpq_denref(quarters)) ? fmpz_get_ui(fmpq_denref(quarters)) : 1;
        if (parts == 1 || PARTS % parts != 0) continue;
        add_turned(task, c, cosine, ends, half, quarters);
        fmpq_add_si(quarters, quarters, 2);
        add_turned(task, c, cosine, ends, half, quarters);
    }
    fmpq_clear(quarters);
    ttc_ratio_clear(task->ring, &value);
}

/* An angle that is linear in a state lies between its values at the ends of the interval. If these, with some quarter turns added,
 * lie between 0 and half a turn, the sine of the angle so turned is positive: it is S, C, -S or -C. */
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
    fmpq_t quarters;
    fmpq_init(quarters);
    for (int k = exact ? -3 : 0; k <= (exact ? 4 : 2); k++) {
        fmpq_set_si(quarters, k, 1);
        add_turned(task, c, cosine, ends, half, quarters);
    }
    if (exact) add_turned_ends(task, c, cosine, ends, half);
    fmpq_clear(quarters);
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
