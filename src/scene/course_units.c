#include "scene/course_units.h"

#include <string.h>

/* Whether the values `counted`, converted to the table's units, equal `told` bit for bit. */
static bool agree(const double *told, const double *counted, const jlt_quantity *of, unsigned count, const jlt_units *units)
{
    double restored[JLT_WAY_VALUES_MAX];

    jlt_units_restore(restored, counted, of, count, units);
    return memcmp(restored, told, count * sizeof *told) == 0;
}

jlt_status jlt_course_units_serve(bool *serves, const jlt_tier *tier, const double *params, const double *x, const jlt_units *units)
{
    const jlt_descriptor *model = tier->asked;
    double counted_params[JLT_PLAN_PARAMS_MAX], counted_x[JLT_PLAN_STATES_MAX], y[2][JLT_WAY_VALUES_MAX],
        back[2][JLT_WAY_VALUES_MAX];
    char refusal[JLT_TIER_TEXT_MAX];
    JLT_CLEARED(jlt_tier_close) jlt_tier_view told = { .instance = NULL }, view = { .instance = NULL };
    jlt_tier there = *tier;

    *serves = tier->way_count == 0; /* without ways the tier is the asked table, perhaps with a state eliminated */
    if (*serves) return JLT_OK;
    there.units = *units;
    jlt_units_count(counted_params, params, model->params, model->param_count, units);
    jlt_units_count(counted_x, x, model->states, model->state_count, units);
    JLT_PASS(jlt_tier_open(&told, y[0], refusal, tier, params, x));
    const jlt_status st = jlt_tier_open(&view, y[1], refusal, &there, counted_params, counted_x);
    if (st == JLT_OK && view.instance->descriptor == told.instance->descriptor) {
        const jlt_descriptor *kernel = view.instance->descriptor;
        jlt_tier_extract(&told, back[0], y[0]);
        jlt_tier_extract(&view, back[1], y[1]);
        if (memcmp(told.instance->params, view.instance->params, kernel->param_count * sizeof *told.instance->params) == 0
            && agree(y[0], y[1], kernel->states, kernel->state_count, units)
            && agree(back[0], back[1], model->states, model->state_count, units))
            *serves = kernel->scales || jlt_units_is_table(units);
    }
    return st == JLT_ERR_UNSUPPORTED ? JLT_OK : st;
}

jlt_status jlt_course_units(jlt_units *out, const jlt_plan *plan, const jlt_question *question)
{
    const jlt_tier *tier = &plan->candidates[plan->chosen].tier;
    bool scales = question->model->scales && plan->reduced->scales;
    jlt_units units;

    *out = (jlt_units){ 0 };
    JLT_PASS(jlt_instance_units(&units, question->model, question->params, question->start));
    if (scales && tier->way_count > 0) JLT_PASS(jlt_course_units_serve(&scales, tier, question->params, question->start, &units));
    if (scales) *out = units;
    return JLT_OK;
}
