/* Reversors: maps of the states that turn the flow round. */
#include "prove/domain.h"

static bool binds_states(const ttc_task *task)
{
    for (size_t i = 0; i < task->claim->when.count; i++)
        if (task->model->symbols[task->claim->when.items[i].symbol].kind == TTC_STATE) return true;
    return task->claim->modulo_count > 0;
}

/* The model at the image of a point: states mapped as claimed, the rest as it is. */
static ttc_valuation *image(ttc_task *task)
{
    const ttc_model *model = task->model;
    ttc_ratio root;
    ttc_ratio_init(task->ring, &root);
    for (size_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_ROOT) ttc_evaluate(task->field, &root, model->symbols[i].node);
    ttc_ratio_clear(task->ring, &root);
    ttc_valuation *map = ttc_valuation_map(model, task->field);
    if (map == NULL) return NULL;
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        ttc_symbol_kind kind = model->symbols[i].kind;
        if (kind == TTC_PARAM || kind == TTC_STATE || kind == TTC_LEVEL || kind == TTC_LAMBDA)
            ttc_valuation_bind(map, i, model->symbols[i].node);
    }
    for (size_t i = 0; i < task->claim->bindings.count; i++)
        ttc_valuation_bind(map, task->claim->bindings.items[i].symbol, task->claim->bindings.items[i].expression);
    return map;
}

static ttc_id image_of_state(const ttc_task *task, size_t state)
{
    uint32_t symbol = task->model->states[state];
    for (size_t i = 0; i < task->claim->bindings.count; i++)
        if (task->claim->bindings.items[i].symbol == symbol) return task->claim->bindings.items[i].expression;
    return task->model->symbols[symbol].node;
}

/* S is an involution, and DS(x) f(x) = -f(S(x)). */
void ttc_prove_reversor(ttc_task *task)
{
    const ttc_model *model = task->model;
    ttc_ratio left, right;
    if (binds_states(task)) {
        ttc_task_unsettle(task, "a reversor acts on an open set of states");
        return;
    }
    ttc_valuation *map = image(task);
    if (map == NULL) {
        ttc_task_unsettle(task, "out of memory");
        return;
    }
    /* First, as the image's roots are then not yet in the ring, where they would be positive. */
    ttc_domain_require_image(task, map, model, " at the image of the reversor");
    ttc_ratio_init(task->ring, &left);
    ttc_ratio_init(task->ring, &right);
    for (size_t i = 0; i < model->state_count && ttc_task_open(task); i++) {
        const char *name = model->symbols[model->states[i]].name;
        ttc_evaluate(map, &left, image_of_state(task, i));
        ttc_evaluate(task->field, &right, model->symbols[model->states[i]].node);
        ttc_ratio_subtract(task->ring, &left, &left, &right);
        ttc_task_require_zero(task, &left, "S(S(%s)) - %s", name, name);
        ttc_evaluate(task->field, &left, ttc_derive_field(model, image_of_state(task, i)));
        ttc_evaluate(map, &right, ttc_model_field(model, i));
        ttc_ratio_add(task->ring, &left, &left, &right);
        ttc_task_require_zero(task, &left, "f(Sx) + S f(x) in %s", name);
    }
    ttc_ratio_clear(task->ring, &right);
    ttc_ratio_clear(task->ring, &left);
    ttc_valuation_destroy(map);
}

