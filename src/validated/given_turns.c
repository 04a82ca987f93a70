#include "validated/given_turns.h"

#include "core/memory.h"
#include "kernel/descriptor.h"
#include "prove/prove.h"

#include <stdio.h>
#include <string.h>

enum { TURNS_MAX = 1000000 };

/* The period of a state, if the table proves it without a condition; else returns false. */
static bool find_period(arb_t period, const ttc_model *model, const jlt_descriptor *d, unsigned state, slong bits)
{
    const jlt_claim *claim = jlt_descriptor_claim(d, "periodic", d->states[state].name);
    const ttc_symbol_entry *entry = &model->symbols[model->states[state]];

    if (claim == NULL || claim->verdict != JLT_PROVED || claim->condition[0] != '\0' || entry->period == TTC_NONE) return false;
    if (entry->in_pi) arb_const_pi(period, bits);
    else arb_one(period);
    arb_mul_fmpz(period, period, fmpq_numref(ttc_coefficient(model->graph, entry->period)), bits);
    arb_div_fmpz(period, period, fmpq_denref(ttc_coefficient(model->graph, entry->period)), bits);
    return true;
}

/* Whether all levels are proved to be periodic; that all conditions are is a part of every period's claim. */
static bool all_turn(const ttc_model *model, const jlt_cycle_question *question, char *problem)
{
    const ttc_bindings none = { .count = 0 };
    const char *changed = NULL;

    for (unsigned i = 0; changed == NULL && i < question->level_count; i++) {
        uint32_t claim;
        if (!ttc_model_find_claim(model, question->levels[i], &claim)
            || !ttc_prove_turns(model, model->claims[claim].expression, &none))
            changed = question->levels[i];
    }
    if (changed != NULL)
        snprintf(problem, JLT_GIVEN_PROBLEM_MAX, "turns: %s is not shown to be the same a period on, so that nothing closes",
                 changed);
    return changed == NULL;
}

static bool measure(jlt_given_legs *self, const jlt_cycle_question *question, const ttc_model *model, char *problem)
{
    const jlt_descriptor *d = question->descriptor;
    const slong bits = jlt_step_accuracy_for(question->digits).bits;
    bool good = true;
    JLT_SCOPED(arb, period);

    for (unsigned k = 0; good && k < self->count * d->state_count; k++) {
        const unsigned state = k % d->state_count;
        if (self->turns[k] == 0) continue;
        good = find_period(period, model, d, state, bits);
        if (good) arb_mul_si(self->grown + k, period, self->turns[k], bits);
        else snprintf(problem, JLT_GIVEN_PROBLEM_MAX, "turns: %s has no period that %s proves (claim 'periodic')",
                      d->states[state].name, d->model);
    }
    return good;
}

bool jlt_given_turns_set(jlt_given_legs *self, const jlt_cycle_question *question, const int *counts,
                         char problem[JLT_GIVEN_PROBLEM_MAX])
{
    const jlt_descriptor *d = question->descriptor;
    const size_t all = (size_t)self->count * d->state_count;
    ttc_model *model = NULL;
    bool any = false, good = false;

    for (size_t k = 0; k < all; k++) any |= counts[k] != 0;
    if (!any) return true;
    self->turns = calloc(all, sizeof *self->turns);
    self->grown = _arb_vec_init((slong)all);
    if (self->turns != NULL) model = ttc_model_again(d->table, d->model);
    if (model == NULL) snprintf(problem, JLT_GIVEN_PROBLEM_MAX, "turns: %s", jlt_status_text(JLT_ERR_NOMEM));
    else {
        memcpy(self->turns, counts, all * sizeof *counts);
        good = measure(self, question, model, problem) && all_turn(model, question, problem);
    }
    ttc_model_destroy(model);
    return good;
}

static bool read_leg(int *counts, const jlt_descriptor *d, const json_t *turns, char *problem)
{
    const char *name;
    json_t *value;

    if (turns == NULL) return true;
    if (json_object_size(turns) == 0) return jlt_refuse(problem, "turns: no states with their numbers of periods");
    json_object_foreach((json_t *)(uintptr_t)turns, name, value) {
        const json_int_t count = json_integer_value(value);
        size_t state;
        if (jlt_descriptor_state(d, name, &state) && json_is_integer(value) && count != 0 && count >= -TURNS_MAX
            && count <= TURNS_MAX) {
            counts[state] = (int)count;
            continue;
        }
        return jlt_refuse(problem, "turns: %s is no state with a whole number from -%d to %d other than 0", name,
                          TURNS_MAX, TURNS_MAX);
    }
    return true;
}

bool jlt_given_turns_read(jlt_given_legs *self, const jlt_cycle_question *question, const json_t *legs,
                          char problem[JLT_GIVEN_PROBLEM_MAX])
{
    const jlt_descriptor *d = question->descriptor;
    JLT_FREED int *counts = calloc((size_t)self->count * d->state_count, sizeof *counts);
    bool good = counts != NULL;

    if (!good) snprintf(problem, JLT_GIVEN_PROBLEM_MAX, "turns: %s", jlt_status_text(JLT_ERR_NOMEM));
    for (unsigned i = 0; good && i < self->count; i++)
        good = read_leg(counts + i * d->state_count, d, json_object_get(json_array_get(legs, i), "turns"), problem);
    good = good && jlt_given_turns_set(self, question, counts, problem);
    return good;
}

json_t *jlt_given_turns_write(const jlt_given_legs *self, const jlt_cycle_question *question, unsigned leg)
{
    const jlt_descriptor *d = question->descriptor;
    json_t *turns = NULL;

    for (unsigned s = 0; self->turns != NULL && s < d->state_count; s++) {
        const int count = self->turns[leg * d->state_count + s];
        if (count == 0) continue;
        if (turns == NULL) turns = json_object();
        json_object_set_new(turns, d->states[s].name, json_integer(count));
    }
    return turns;
}
