#include "scene/course_units.h"

#include <math.h>
#include <string.h>

/* Whether the chosen tier is the same in these units: it serves, and its parameters are those that it has in the table's. */
static jlt_status fits_tier(bool *fits, const jlt_plan *plan, const jlt_question *question, const jlt_units *units)
{
    const jlt_descriptor *model = question->model;
    const jlt_tier *tier = &plan->candidates[plan->chosen].tier;
    double params[JLT_PLAN_PARAMS_MAX], x[JLT_PLAN_STATES_MAX], y[JLT_WAY_VALUES_MAX], counted[JLT_WAY_VALUES_MAX];
    char refusal[JLT_TIER_TEXT_MAX];
    jlt_tier_view told = { .instance = NULL }, view = { .instance = NULL };
    jlt_status st = JLT_OK;

    *fits = tier->way_count == 0; /* the level by which a state is eliminated has no unit */
    if (*fits) return st;
    jlt_units_count(params, question->params, model->params, model->param_count, units);
    jlt_units_count(x, question->start, model->states, model->state_count, units);
    JLT_TRY(jlt_tier_open(&told, y, refusal, tier, question->params, question->start));
    st = jlt_tier_open(&view, y, refusal, tier, params, x);
    if (st == JLT_OK && view.instance->descriptor == told.instance->descriptor) {
        const jlt_descriptor *kernel = view.instance->descriptor;
        jlt_units_count(counted, told.instance->params, kernel->params, kernel->param_count, units);
        *fits = memcmp(counted, view.instance->params, kernel->param_count * sizeof *counted) == 0;
    }
    if (st == JLT_ERR_UNSUPPORTED) st = JLT_OK;
done:
    jlt_tier_close(&view);
    jlt_tier_close(&told);
    return st;
}

jlt_status jlt_course_units(jlt_units *out, const jlt_plan *plan, const jlt_question *question)
{
    const jlt_descriptor *model = question->model;
    double still[JLT_PLAN_STATES_MAX], f[JLT_PLAN_STATES_MAX];
    jlt_instance *instance = NULL;
    jlt_units units = { 0 };
    bool scales = false;
    jlt_status st = JLT_OK;

    *out = (jlt_units){ 0 };
    jlt_units_of_params(&units, question->params, model->params, model->param_count);
    JLT_TRY(jlt_instance_create(&instance, model, question->params));
    for (unsigned i = 0; i < model->state_count; i++)
        still[i] = jlt_units_exponent(&(jlt_units){ .time = 1 }, model->states[i].unit) == 0 ? question->start[i] : 0;
    model->rhs.call(still, instance->prepared, f);
    jlt_units_of_rate(&units, fmax(jlt_units_rate(&units, question->start, model->states, model->state_count, 0),
                                   jlt_units_rate(&units, f, model->states, model->state_count, 1)));
    JLT_TRY(jlt_instance_scales(&scales, model, question->params, &units));
    if (scales) JLT_TRY(fits_tier(&scales, plan, question, &units));
    if (scales) *out = units;
done:
    jlt_instance_destroy(instance);
    return st;
}
