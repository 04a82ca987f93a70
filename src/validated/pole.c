#include "validated/pole.h"

#include "ext/scoped.h"

#include <math.h>
#include <stdlib.h>

enum { STEPS_MAX = 1000 };

void jlt_pole_result_init(jlt_pole_result *self, const jlt_descriptor *d)
{
    *self = (jlt_pole_result){ .states = d->state_count, .valid_count = d->valid_count };
    self->vanishes = calloc(d->state_count + 1, sizeof *self->vanishes);
    self->limit = _arb_vec_init(d->state_count);
    self->least = calloc(d->valid_count + 1, sizeof *self->least);
    for (unsigned i = 0; self->least != NULL && i < d->valid_count; i++) arf_init(self->least + i);
    arb_init(self->time);
}

void jlt_pole_result_clear(jlt_pole_result *self)
{
    for (unsigned i = 0; self->least != NULL && i < self->valid_count; i++) arf_clear(self->least + i);
    free(self->least);
    free(self->vanishes);
    _arb_vec_clear(self->limit, self->states);
    arb_clear(self->time);
}

/* Enclose the end of an interval, of which the descriptor has the nearest double. */
static void set_end(arb_t out, double end)
{
    arb_set_d(out, end);
    if (end != floor(end)) mag_set_d(arb_radref(out), ldexp(fabs(end), -52));
}

static bool is_inside(const arb_t value, const jlt_quantity *state)
{
    JLT_SCOPED(arb, low, high);

    set_end(low, state->low);
    set_end(high, state->high);
    return arb_gt(value, low) && arb_lt(value, high);
}

/* Append the lifted roots and t = 0 to the box. Returns false unless the box is shown to lie in the table's domain. */
static bool begin(arb_ptr x, jlt_step *step, const jlt_pole_question *question)
{
    const jlt_formulas *of = jlt_step_formulas(step);
    const unsigned first = of->states - 1 - of->lifted_count;
    bool good = is_inside(question->box + question->state, &question->descriptor->states[question->state]);

    _arb_vec_set(x, question->box, first);
    for (unsigned i = 0; i < of->lifted_count; i++) arb_one(x + first + i);
    arb_zero(x + of->states - 1);
    for (unsigned i = 0; good && i < of->lifted_count; i++) { /* a radicand may contain the roots before it */
        jlt_step_evaluate(step, x);
        arb_srcptr radicand = jlt_step_output(step, jlt_formulas_radicand(of, i));
        good = arb_is_positive(radicand);
        arb_sqrt(x + first + i, radicand, jlt_step_bits(step));
    }
    jlt_step_evaluate(step, x);
    return good && jlt_step_holds(step);
}

static bool is_at(const arb_t limit, double number)
{
    JLT_SCOPED(arb, end);

    if (!isfinite(number)) return false;
    set_end(end, number);
    return arb_overlaps(limit, end);
}

/* Tell at which end the pole is. The table is not defined where a lifted root is 0, and all conditions of its domain but those of
 * this state hold at the limit, so that the state is at an end there. Returns false if either end may be meant. */
static bool tell_end(jlt_pole_result *result, const jlt_pole_question *question)
{
    const jlt_quantity *state = &question->descriptor->states[question->state];
    arb_ptr limit = result->limit + question->state;
    const bool is_low = is_at(limit, state->low);

    result->is_high = is_at(limit, state->high);
    set_end(limit, result->is_high ? state->high : state->low);
    return is_low != result->is_high;
}

static jlt_pole_verdict conclude(jlt_pole_result *result, const jlt_pole_question *question, const jlt_settle_result *settled,
                                 const jlt_formulas *of)
{
    for (unsigned i = 0; i < result->states; i++) {
        result->vanishes[i] = settled->vanishes[i];
        arb_set(result->limit + i, settled->limit + i);
    }
    arb_set(result->time, settled->limit + of->states - 1);
    jlt_step_lower(result->least, settled->least, of->valid_count);
    return tell_end(result, question) ? JLT_POLE_PROVED : JLT_POLE_EITHER;
}

/* Carry the set to the instant, or, if that is 0, until it settles. */
static jlt_status fly(jlt_pole_result *result, jlt_settle_result *settled, bool *is_settled, jlt_step *step, jlt_set *set,
                      arb_ptr x, arf_t instant)
{
    const bool searches = arf_is_zero(instant);
    JLT_SCOPED(arf, left, h);
    JLT_SCOPED(arb, expansion);

    arf_set(left, instant);
    *is_settled = false;
    for (unsigned i = 0; i < STEPS_MAX && !*is_settled && (searches || arf_sgn(left) > 0); i++) {
        if (searches) arf_one(h);
        else arf_set(h, left);
        JLT_PASS(jlt_step_advance(step, set, h, expansion, result->least));
        if (searches) arf_add(instant, instant, h, ARF_PREC_EXACT, ARF_RND_DOWN);
        else arf_sub(left, left, h, ARF_PREC_EXACT, ARF_RND_DOWN);
        jlt_set_hull(x, set);
        if (searches || arf_is_zero(left)) *is_settled = jlt_settle(settled, step, x);
    }
    return JLT_OK;
}

jlt_status jlt_pole_prove(jlt_pole_result *result, const jlt_pole_question *question, arf_t instant)
{
    jlt_formulas *of = NULL;
    jlt_step *step = NULL;
    jlt_settle_result settled = { 0 };
    jlt_set set;
    arb_ptr x = NULL;
    bool is_settled;
    jlt_status st;

    JLT_TRY(jlt_formulas_create_lifted(&of, question->descriptor, question->time, question->state));
    JLT_TRY(jlt_step_create(&step, of, question->params, jlt_step_accuracy_for(question->digits), question->watch));
    x = _arb_vec_init((slong)of->dim);
    jlt_settle_result_init(&settled, of);
    for (unsigned i = 0; i < of->valid_count; i++) arf_pos_inf(result->least + i);
    result->verdict = JLT_POLE_OUTSIDE;
    if (!begin(x, step, question)) goto done;
    jlt_set_init(&set, x, of->dim, jlt_step_bits(step));
    st = fly(result, &settled, &is_settled, step, &set, x, instant);
    jlt_set_clear(&set);
    if (st == JLT_OK && is_settled) result->verdict = conclude(result, question, &settled, of);
    else result->verdict = st == JLT_ERR_DOMAIN ? JLT_POLE_LEAVES : JLT_POLE_OPEN;
    if (st == JLT_ERR_DOMAIN || st == JLT_ERR_NO_PROGRESS) st = JLT_OK; /* the verdict says it */
done:
    if (x != NULL) {
        _arb_vec_clear(x, (slong)of->dim);
        jlt_settle_result_clear(&settled, of);
    }
    jlt_step_destroy(step);
    jlt_formulas_destroy(of);
    return st;
}
