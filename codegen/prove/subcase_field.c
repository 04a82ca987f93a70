/* The field of a subcase, in which the bindings of `when`, of a family and of solutions are made. */
#include "prove/subcase.h"

#include "prove/question.h"

static void bind_all(ttc_valuation *field, const ttc_bindings *bindings)
{
    for (size_t i = 0; i < bindings->count; i++)
        ttc_valuation_bind(field, bindings->items[i].symbol, bindings->items[i].expression);
}

bool ttc_subcase_open(ttc_task *task, const ttc_subcase *b, unsigned choices)
{
    const ttc_claim *family = ttc_task_family(task);
    task->field = ttc_valuation_create(task->model, choices);
    if (task->field == NULL) return false;
    task->ring = ttc_valuation_ring(task->field);
    bind_all(task->field, &task->claim->when);
    if (family != NULL && family != task->claim) bind_all(task->field, &family->when);
    if (family != NULL) bind_all(task->field, &family->bindings);
    for (size_t i = 0; i < b->solution_count; i++)
        if (b->solutions[i].square)
            ttc_valuation_bind_square(task->field, b->solutions[i].symbol, b->solutions[i].expression);
        else ttc_valuation_bind(task->field, b->solutions[i].symbol, b->solutions[i].expression);
    ttc_conditions_init(&task->domain, task->field);
    task->met = b->met;
    task->met_count = b->met_count;
    task->shown = 0;
    ttc_question_withhold(task);
    return true;
}

void ttc_subcase_close(ttc_task *task)
{
    ttc_conditions_clear(&task->domain);
    ttc_valuation_destroy(task->field);
    task->field = NULL;
    task->ring = NULL;
}

void ttc_subcase_keep_signs(ttc_subcase *b, ttc_task *task)
{
    const ttc_model *model = task->model;
    ttc_ratio root;
    ttc_ratio_init(task->ring, &root);
    for (uint32_t i = 0; task->ring->choice_count > 0 && i < model->symbol_count && task->ring->status == TTC_RING_OK; i++) {
        const ttc_symbol_entry *entry = &model->symbols[i];
        if ((entry->kind != TTC_ROOT && entry->kind != TTC_SINE) || !ttc_valuation_has_value(task->field, i) ||
            ttc_ring_generator(task->ring, ttc_valuation_variable(task->field, i)) != NULL)
            continue;
        ttc_evaluate(task->field, &root, entry->node);
        const ttc_id top = ttc_task_expression(task, root.numerator), bottom = ttc_task_expression(task, root.denominator);
        if (top == TTC_NONE || bottom == TTC_NONE) continue;
        const ttc_id zero = ttc_subtract(model->graph, top, ttc_multiply(model->graph, entry->node, bottom));
        if (b->met_count < sizeof b->met / sizeof *b->met) b->met[b->met_count++] = zero;
        else ttc_task_unsettle(task, "the zero level falls into too many cases");
    }
    ttc_ratio_clear(task->ring, &root);
}

void ttc_subcase_add_conditions(ttc_task *task, const ttc_subcase *subcase)
{
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; i < subcase->lead_count; i++) {
        ttc_evaluate(task->field, &value, subcase->leads[i]);
        ttc_conditions_add(&task->domain, &value, TTC_IS_NONZERO);
    }
    for (size_t i = 0; i < subcase->solution_count; i++) {
        if (!subcase->solutions[i].square) continue;
        ttc_evaluate(task->field, &value, subcase->solutions[i].expression);
        ttc_conditions_add(&task->domain, &value, TTC_IS_NONNEGATIVE);
    }
    ttc_ratio_clear(task->ring, &value);
}

void ttc_subcase_check_foundations(ttc_task *task)
{
    const ttc_model *model = task->model;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; i < task->claim->modulo_count && ttc_task_open(task); i++) {
        const ttc_claim *level = &model->claims[task->claim->modulo[i]];
        if (task->verdict_of == NULL || task->verdict_of(task->verdict_context, task->claim->modulo[i]) != TTC_PROVED)
            ttc_task_unsettle(task, "it rests on %s, which is not proved", level->name);
        for (size_t k = 0; k < level->when.count && ttc_task_open(task); k++) {
            ttc_evaluate(task->field, &value, model->symbols[level->when.items[k].symbol].node);
            ttc_task_take_off(task, &value, task->field, level->when.items[k].expression);
            if (ttc_task_open(task) && !ttc_ratio_is_zero(task->ring, &value))
                ttc_task_unsettle(task, "it rests on %s, which holds under a condition on %s that this claim does not make",
                                  level->name, model->symbols[level->when.items[k].symbol].name);
        }
        for (size_t k = 0; k < level->modulo_count && ttc_task_open(task); k++) {
            ttc_evaluate(task->field, &value, model->claims[level->modulo[k]].expression);
            if (ttc_task_open(task) && !ttc_ratio_is_zero(task->ring, &value))
                ttc_task_unsettle(task, "it rests on %s, which holds on a zero level of %s that this claim does not take",
                                  level->name, model->claims[level->modulo[k]].name);
        }
    }
    ttc_ratio_clear(task->ring, &value);
}
