#include "prove/observed.h"

#include "prove/vanishing.h"

#include <stdlib.h>

unsigned char *ttc_observed_divisors(const ttc_model *model, const ttc_observed *record)
{
    unsigned char *own = calloc(model->divisor_count + 1, 1), *field = ttc_model_uses(model);
    unsigned char *used = ttc_model_uses_of(model, record->role, record->owner);
    const bool ok = own != NULL && field != NULL && used != NULL;
    if (ok && record->role == TTC_DIVIDES_SYMBOL) used[record->owner] = 1;
    for (size_t i = 0; ok && i < model->divisor_count; i++) {
        const ttc_divisor *d = model->divisors + i;
        const bool named = d->role == TTC_DIVIDES_SYMBOL && used[d->owner] && !field[d->owner];
        own[i] = named || (record->role != TTC_DIVIDES_SYMBOL && d->role == record->role && d->owner == record->owner);
    }
    free(used);
    free(field);
    if (ok) return own;
    free(own);
    return NULL;
}

static bool divides(const ttc_model *model, const ttc_observed *record)
{
    unsigned char *own = ttc_observed_divisors(model, record);
    bool some = own == NULL;
    for (size_t i = 0; !some && i < model->divisor_count; i++) some = own[i] != 0;
    free(own);
    return some;
}

/* Record number i of all, observe first, then valid, then tier, whether or not it divides. Returns false beyond the last. */
static bool record_at(const ttc_model *model, size_t i, ttc_observed *record)
{
    if (i < model->observed_count) {
        const ttc_symbol_entry *entry = model->symbols + model->observed[i];
        *record = (ttc_observed){ "observe", entry->name, entry->place, TTC_DIVIDES_SYMBOL, model->observed[i] };
    } else if ((i -= model->observed_count) < model->validity_count) {
        const ttc_validity *validity = model->validities + i;
        *record = (ttc_observed){ "valid", validity->name, validity->place, TTC_DIVIDES_VALID, (uint32_t)i };
    } else if (i == model->validity_count && model->tier.name != NULL) {
        *record = (ttc_observed){ "tier", model->tier.name, model->tier.place, TTC_DIVIDES_TIER, 0 };
    } else {
        return false;
    }
    return true;
}

size_t ttc_observed_count(const ttc_model *model)
{
    size_t count = 0;
    ttc_observed record;
    for (size_t i = 0; record_at(model, i, &record); i++) count += divides(model, &record);
    return count;
}

void ttc_observed_get(const ttc_model *model, size_t index, ttc_observed *record)
{
    for (size_t i = 0; record_at(model, i, record); i++)
        if (divides(model, record) && index-- == 0) return;
}

static const char *const at_all_states =
    "for some parameters it divides by zero at all states, so that no kernel could be prepared: what it divides by";

static bool depends_on_some(const ttc_model *model, ttc_id id, const uint32_t *symbols, size_t count)
{
    bool depends = false;
    for (size_t i = 0; i < count && !depends; i++) depends = ttc_model_depends(model, id, symbols[i]);
    return depends;
}

/* Returns true if a root or function of states, or with `of_both` of states and parameters together, is in the expression. */
static bool uses_function(const ttc_model *model, ttc_id id, bool of_both)
{
    unsigned char *support = ttc_model_support(model, &id, 1);
    bool uses = support == NULL;
    for (uint32_t i = 0; !uses && i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = model->symbols + i;
        const bool is_function = entry->kind == TTC_ROOT || entry->kind == TTC_EXP || entry->kind == TTC_LOG ||
                                 entry->kind == TTC_COSINE || entry->kind == TTC_SINE;
        uses = support[i] && is_function && depends_on_some(model, entry->node, model->states, model->state_count) &&
               (!of_both || depends_on_some(model, entry->node, model->params, model->param_count));
    }
    free(support);
    return uses;
}

/* Returns true if what is zero on the leaf need not be so at all states. A root may be a state but for the sign, which is that of
 * some states; and where parameters are special, a function may have stopped moving, as exp(k*x) does at k = 0. */
static bool is_of_some_states(const ttc_task *task, ttc_id id)
{
    return (task->ring->choice_count > 0 && uses_function(task->model, id, false)) ||
           (task->is_at_zeros && uses_function(task->model, id, true));
}

static const char *const at_some_states = "for some parameters it divides by zero at some states, or at all";

static void refute_zero(ttc_task *task, ttc_id id, const ttc_ratio *divisor)
{
    if (!ttc_task_may_have_point(task)) return;
    if (!task->is_at_zeros) ttc_task_refute(task, NULL, "it divides by what is zero on a whole part of the domain");
    else if (is_of_some_states(task, id)) ttc_task_unsettle(task, "%s", at_some_states);
    else ttc_task_refute(task, divisor, "%s", at_all_states);
}

/* Require that a divisor is not zero on a whole part of the domain, nor at all states for some parameters. A function of states and
 * parameters counts as moving with the states: exp(k*x) - 1, zero at k = 0 alone, passes, as points around have values. */
static void require_values(ttc_task *task, ttc_id id, const ttc_ratio *divisor)
{
    if (ttc_ratio_is_zero(task->ring, divisor)) {
        refute_zero(task, id, divisor);
        return;
    }
    char *point = NULL;
    bool *moves = ttc_vanishing_moves(task);
    const ttc_search_result result =
        moves == NULL ? TTC_POINT_NOT_DECIDED : ttc_vanishing_search(task, divisor->numerator, divisor->denominator, moves, &point);
    free(moves);
    if (result == TTC_POINT_FOUND && !is_of_some_states(task, id)) {
        ttc_task_refute_at(task, point, divisor, "%s", at_all_states);
        return;
    }
    free(point);
    if (result == TTC_POINT_FOUND)
        ttc_task_unsettle(task, "%s", at_some_states);
    else if (result == TTC_POINT_NOT_DECIDED)
        ttc_task_unsettle(task, "that no parameters make it divide by zero at all states was not shown (expected a domain "
                                "record that excludes them)");
}

void ttc_prove_observed(ttc_task *task)
{
    const ttc_model *model = task->model;
    ttc_observed record;
    ttc_observed_get(model, task->claim->family, &record);
    unsigned char *own = ttc_observed_divisors(model, &record);
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    if (own == NULL) ttc_task_unsettle(task, "out of memory");
    for (size_t i = 0; i < model->divisor_count && ttc_task_open(task); i++) {
        if (!own[i]) continue;
        ttc_evaluate(task->field, &value, model->divisors[i].divisor);
        if (ttc_task_open(task)) require_values(task, model->divisors[i].divisor, &value);
    }
    ttc_ratio_clear(task->ring, &value);
    free(own);
}
