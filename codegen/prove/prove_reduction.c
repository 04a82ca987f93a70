/* The prover of reductions and embeddings: images of this table's points lie in the other model's domain and move by its equations;
 * those of a reduction have the other model's dimension, those of an embedding the dimension of this one. */
#include "prove/domain.h"
#include "prove/way_table.h"

#include <string.h>

void ttc_prove_constant(ttc_task *task, const char *name, ttc_id expression)
{
    ttc_ratio rate;
    ttc_ratio_init(task->ring, &rate);
    ttc_evaluate(task->field, &rate, ttc_derive_field(task->model, expression));
    ttc_task_require_zero(task, &rate, "d%s/dt, which should be constant", name);
    ttc_ratio_clear(task->ring, &rate);
}

static void bind_target(ttc_task *task, ttc_valuation *map)
{
    const ttc_model *target = ttc_valuation_model(map);
    for (uint32_t i = 0; i < target->symbol_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *entry = &target->symbols[i];
        uint32_t own;
        const ttc_id expression = ttc_given_for(task->claim, entry->name);
        if (expression != TTC_NONE) {
            if (entry->kind != TTC_STATE && entry->kind != TTC_ROOT && entry->kind != TTC_PARAM)
                ttc_task_unsettle(task, "%s is no state, root or parameter of %s", entry->name, target->name);
            ttc_valuation_bind(map, i, expression);
        } else if (entry->kind == TTC_STATE) {
            ttc_task_unsettle(task, "the state %s of %s is given no image", entry->name, target->name);
        } else if (entry->kind == TTC_PARAM) {
            if (ttc_model_find_symbol(task->model, entry->name, &own) && task->model->symbols[own].kind == TTC_PARAM)
                ttc_valuation_bind(map, i, task->model->symbols[own].node);
            else ttc_task_unsettle(task, "the parameter %s of %s is given no value", entry->name, target->name);
        }
    }
    for (size_t i = 0; i < task->claim->bindings.count && ttc_task_open(task); i++) {
        uint32_t symbol;
        if (!ttc_model_find_symbol(target, task->claim->target_names[i], &symbol))
            ttc_task_unsettle(task, "%s names nothing in %s", task->claim->target_names[i], target->name);
    }
}

void ttc_prove_chain_rule(ttc_task *task, const ttc_claim *claim, ttc_valuation *map)
{
    const ttc_model *target = ttc_valuation_model(map);
    for (size_t i = 0; i < target->state_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *state = &target->symbols[target->states[i]];
        const ttc_id image = ttc_given_for(claim, state->name);
        if (image != TTC_NONE)
            ttc_task_require_equal(task, task->field, ttc_derive_field(task->model, image), map, ttc_model_field(target, i),
                                   "chain rule - field of %s in %s", target->name, state->name);
    }
}

/* Returns true for an integral without conditions. */
static bool is_plain_integral(const ttc_claim *claim)
{
    return claim->kind == TTC_CLAIM_INTEGRAL && claim->when.count == 0 && claim->modulo_count == 0;
}

void ttc_prove_same_observations(ttc_task *task, ttc_valuation *map)
{
    const ttc_model *model = task->model, *target = ttc_valuation_model(map);
    for (size_t i = 0; i < model->observed_count; i++)
        for (size_t k = 0; k < target->observed_count && ttc_task_open(task); k++) {
            const ttc_symbol_entry *own = model->symbols + model->observed[i], *theirs = target->symbols + target->observed[k];
            if (strcmp(own->name, theirs->name) == 0)
                ttc_task_require_equal(task, task->field, own->node, map, theirs->node, "observe %s of %s - of %s", own->name,
                                       model->name, target->name);
        }
    for (size_t i = 0; i < model->validity_count; i++)
        for (size_t k = 0; k < target->validity_count && ttc_task_open(task); k++) {
            const ttc_validity *own = model->validities + i, *theirs = target->validities + k;
            if (strcmp(own->name, theirs->name) == 0)
                ttc_task_require_equal(task, task->field, own->expression, map, theirs->expression,
                                       "valid %s of %s - of %s", own->name, model->name, target->name);
        }
    for (size_t i = 0; i < model->claim_count; i++)
        for (size_t k = 0; k < target->claim_count && ttc_task_open(task); k++) {
            const ttc_claim *own = model->claims + i, *theirs = target->claims + k;
            if (is_plain_integral(own) && is_plain_integral(theirs) && strcmp(own->name, theirs->name) == 0)
                ttc_task_require_equal(task, task->field, own->expression, map, theirs->expression,
                                       "integral %s of %s - of %s", own->name, model->name, target->name);
        }
}

static void prove_onto(ttc_task *task, const ttc_model *target)
{
    ttc_valuation *map = ttc_task_enter_map(task, target, task->field);
    if (map == NULL) return;
    bind_target(task, map);
    /* First, before the image's roots are in the ring, where they count as positive. */
    ttc_domain_require_image(task, map, " of the image");
    for (size_t i = 0; i < target->symbol_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *entry = &target->symbols[i];
        const ttc_id expression = ttc_given_for(task->claim, entry->name);
        if (expression == TTC_NONE) continue;
        if (entry->kind == TTC_ROOT) ttc_domain_require_root(task, map, entry);
        if (entry->kind == TTC_PARAM) ttc_prove_constant(task, entry->name, expression);
    }
    ttc_prove_chain_rule(task, task->claim, map);
    ttc_prove_same_observations(task, map);
    /* For all parameters, special ones included, a reduction claims a dimension. */
    const bool claims = !task->is_at_zeros || (!task->is_lower && task->claim->kind == TTC_CLAIM_REDUCTION);
    if (ttc_task_open(task) && claims && ttc_task_may_have_point(task)) ttc_prove_dimension(task, target);
    ttc_task_leave_map(task);
}

void ttc_prove_reduction(ttc_task *task)
{
    if (ttc_task_restricts_states(task)) {
        ttc_task_unsettle(task, "'%s' under a condition on states (expected 'modulo' of what the flow keeps)",
                          ttc_claim_kind_name(task->claim->kind));
        return;
    }
    char reason[2 * TTC_DIAGNOSTIC_LINE];
    ttc_model *target = ttc_resolve(task->resolver, task->resolver_context, task->model, "the target", task->claim->target, reason,
                                    sizeof reason);
    if (target == NULL) ttc_task_unsettle(task, "%s", reason);
    else if (target->equation_count == 0)
        ttc_task_unsettle(task, "%s is a table of coordinates, in which nothing moves", task->claim->target);
    else prove_onto(task, target);
    ttc_model_destroy(target);
}
