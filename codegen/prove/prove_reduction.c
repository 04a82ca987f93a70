/* A reduction: the images of our states move as the target model says. */
#include "prove/prove_task.h"

#include <string.h>

static bool binding_of(const ttc_task *task, const char *name, ttc_id *expression)
{
    for (size_t i = 0; i < task->claim->bindings.count; i++)
        if (strcmp(task->claim->target_names[i], name) == 0) {
            *expression = task->claim->bindings.items[i].expression;
            return true;
        }
    return false;
}

/* A target's root given as an expression: its square is the radicand, and it is evidently positive. */
static void check_root(ttc_task *task, ttc_valuation *map, const ttc_symbol_entry *entry)
{
    ttc_ratio root, radicand;
    ttc_ratio_init(task->ring, &root);
    ttc_ratio_init(task->ring, &radicand);
    ttc_evaluate(map, &root, entry->node);
    ttc_evaluate(map, &radicand, entry->definition);
    if (ttc_task_open(task) && ttc_ratio_sign(task->ring, &root) <= 0)
        ttc_task_reject(task, "the image of the root %s is not evidently positive", entry->name);
    ttc_ratio_multiply(task->ring, &root, &root, &root);
    ttc_ratio_subtract(task->ring, &root, &root, &radicand);
    ttc_task_require_zero(task, &root, "%s^2 - its radicand", entry->name);
    ttc_ratio_clear(task->ring, &radicand);
    ttc_ratio_clear(task->ring, &root);
}

/* A target's parameter given as an expression is a quantity that our flow keeps. */
static void check_parameter(ttc_task *task, const ttc_symbol_entry *entry, ttc_id expression)
{
    ttc_ratio rate;
    ttc_ratio_init(task->ring, &rate);
    ttc_evaluate(task->field, &rate, ttc_derive_field(task->model, expression));
    ttc_task_require_zero(task, &rate, "d%s/dt, which should be constant", entry->name);
    ttc_ratio_clear(task->ring, &rate);
}

static void bind_target(ttc_task *task, const ttc_model *target, ttc_valuation *map)
{
    for (uint32_t i = 0; i < target->symbol_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *entry = &target->symbols[i];
        uint32_t own;
        ttc_id expression;
        if (binding_of(task, entry->name, &expression)) {
            if (entry->kind != TTC_STATE && entry->kind != TTC_ROOT && entry->kind != TTC_PARAM)
                ttc_task_reject(task, "%s is no state, root or parameter of %s", entry->name, target->name);
            ttc_valuation_bind(map, i, expression);
        } else if (entry->kind == TTC_STATE) {
            ttc_task_reject(task, "the state %s of %s is given no image", entry->name, target->name);
        } else if (entry->kind == TTC_PARAM) {
            if (ttc_model_find_symbol(task->model, entry->name, &own) && task->model->symbols[own].kind == TTC_PARAM)
                ttc_valuation_bind(map, i, task->model->symbols[own].node);
            else ttc_task_reject(task, "the parameter %s of %s is given no value", entry->name, target->name);
        }
    }
    for (size_t i = 0; i < task->claim->bindings.count && ttc_task_open(task); i++) {
        uint32_t symbol;
        if (!ttc_model_find_symbol(target, task->claim->target_names[i], &symbol))
            ttc_task_reject(task, "%s names nothing in %s", task->claim->target_names[i], target->name);
    }
}

static void chain_rule(ttc_task *task, const ttc_model *target, ttc_valuation *map)
{
    ttc_ratio left, right;
    ttc_ratio_init(task->ring, &left);
    ttc_ratio_init(task->ring, &right);
    for (size_t i = 0; i < target->state_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *state = &target->symbols[target->states[i]];
        ttc_id image = TTC_NONE;
        if (!binding_of(task, state->name, &image)) continue;
        ttc_evaluate(task->field, &left, ttc_derive_field(task->model, image));
        ttc_evaluate(map, &right, ttc_model_field(target, i));
        ttc_ratio_subtract(task->ring, &left, &left, &right);
        ttc_task_require_zero(task, &left, "chain rule - field of %s in %s", target->name, state->name);
    }
    ttc_ratio_clear(task->ring, &right);
    ttc_ratio_clear(task->ring, &left);
}

static void prove_onto(ttc_task *task, const ttc_model *target)
{
    ttc_valuation *map = ttc_valuation_map(target, task->field);
    if (map == NULL) {
        ttc_task_reject(task, "out of memory");
        return;
    }
    bind_target(task, target, map);
    for (size_t i = 0; i < target->symbol_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *entry = &target->symbols[i];
        ttc_id expression;
        if (!binding_of(task, entry->name, &expression)) continue;
        if (entry->kind == TTC_ROOT) check_root(task, map, entry);
        if (entry->kind == TTC_PARAM) check_parameter(task, entry, expression);
    }
    chain_rule(task, target, map);
    ttc_valuation_destroy(map);
}

void ttc_prove_reduction(ttc_task *task)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *target = NULL;
    if (diagnostics != NULL && task->resolver != NULL)
        target = task->resolver(task->resolver_context, task->model, task->claim->target, diagnostics);
    if (target == NULL) ttc_task_reject(task, "the target %s could not be read", task->claim->target);
    else prove_onto(task, target);
    ttc_model_destroy(target);
    ttc_diagnostics_destroy(diagnostics);
}
