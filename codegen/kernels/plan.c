#include "kernels/plan.h"

#include <stdlib.h>

static bool plan_field(ttc_planned *planned, const ttc_model *model, ttc_effort effort)
{
    ttc_field *field = NULL;
    planned->status = ttc_field_create(&field, model, planned->variant, planned->time, planned->elimination);
    if (planned->status == TTC_FIELD_DIVIDES_BY_ZERO) return true;
    if (planned->status != TTC_FIELD_OK) return false;
    planned->kernels = ttc_kernels_create(field, effort);
    return planned->kernels != NULL;
}

ttc_place ttc_plan_place(const ttc_planned *planned, const ttc_model *model)
{
    if (planned->elimination != NULL) return planned->elimination->place;
    if (planned->time != NULL) return planned->time->place;
    if (planned->variant != NULL) return planned->variant->place;
    return model->equation_count > 0 ? model->equations[0].place : (ttc_place){ 1, 1 };
}

static const char *reason_of(const ttc_model *model)
{
    ttc_graph_status error = ttc_graph_error(model->graph);
    return error != TTC_GRAPH_OK ? ttc_graph_status_text(error) : "memory is out, or a number is divided by zero";
}

/* After all fields are there: what one of them gains adds nodes to the graph, on whose ids the others' programs rest. */
static bool keep_digits(ttc_plan *plan, ttc_effort effort)
{
    for (size_t i = 0; i < plan->count; i++)
        if (plan->fields[i].kernels != NULL && !ttc_kernels_keep_digits(plan->fields[i].kernels, effort)) return false;
    return true;
}

bool ttc_plan_create(ttc_plan *plan, const ttc_model *model, ttc_plan_extent extent, ttc_effort effort)
{
    size_t eliminations = extent == TTC_WITHOUT_ELIMINATIONS ? 0 : model->elimination_count;
    size_t most = (model->variant_count + 1) * (model->time_count + 1) * (eliminations + 1);
    *plan = (ttc_plan){ .model = model, .fields = calloc(most, sizeof *plan->fields) };
    if (plan->fields == NULL) return false;
    for (size_t v = 0; v <= model->variant_count; v++)
        for (size_t t = 0; t <= model->time_count; t++)
            for (size_t e = 0; e <= eliminations; e++) {
                ttc_planned *planned = plan->fields + plan->count++;
                planned->variant = v == 0 ? NULL : model->variants + v - 1;
                planned->time = t == 0 ? NULL : model->times + t - 1;
                planned->elimination = e == 0 ? NULL : model->eliminations + e - 1;
                if (plan_field(planned, model, effort)) continue;
                ttc_plan failed = { .failed_at = ttc_plan_place(planned, model), .failure = reason_of(model) };
                ttc_plan_clear(plan);
                *plan = failed;
                return false;
            }
    if (keep_digits(plan, effort)) return true;
    ttc_plan failed = { .failed_at = ttc_plan_place(&plan->fields[0], model), .failure = reason_of(model) };
    ttc_plan_clear(plan);
    *plan = failed;
    return false;
}

void ttc_plan_clear(ttc_plan *plan)
{
    for (size_t i = 0; i < plan->count; i++) ttc_kernels_destroy(plan->fields[i].kernels);
    free(plan->fields);
    *plan = (ttc_plan){ 0 };
}
