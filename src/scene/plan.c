#include "scene/plan.h"

#include <string.h>

#include "kernel/descriptor.h"

static const char tiered_model[] = "spherical_top";

bool jlt_plan_has_tiers(const jlt_descriptor *model)
{
    return strcmp(model->model, tiered_model) == 0;
}

/* The most special kernel of a tier for these parameters; a model of its own is asked with its own parameters. */
static const jlt_descriptor *kernel_of(const jlt_tier *tier, const jlt_top *top, const double *x)
{
    const jlt_descriptor *general = jlt_descriptor_find(tier->model, NULL, tier->time, tier->elimination);
    double params[JLT_PLAN_PARAMS_MAX];
    jlt_tier_view view;

    if (general == NULL || general->param_count > JLT_PLAN_PARAMS_MAX) return NULL;
    jlt_tier_look(&view, tier, general, top, x);
    if (jlt_tier_params(params, &view) != JLT_OK) return NULL;
    return jlt_descriptor_choose(tier->model, tier->time, tier->elimination, params);
}

static jlt_candidate judge(const jlt_tier *tier, const jlt_question *question, const jlt_top *top)
{
    static const double anywhere[JLT_TOP_STATES] = { 0 };
    const double *start = question->start != NULL ? question->start : anywhere;
    jlt_candidate candidate = { .tier = tier };

    if (question->section && !tier->section)
        candidate.refusal = "it has no chart (eta, gamma3) of the section on levels of E and G";
    else if (tier->refuses != NULL) candidate.refusal = tier->refuses(top, start);
    if (candidate.refusal == NULL && question->attitude && !tier->attitude)
        candidate.refusal = "attitude and track are asked for";
    if (tier->model != NULL) candidate.descriptor = kernel_of(tier, top, start);
    if (candidate.refusal == NULL && tier->model != NULL
        && (candidate.descriptor == NULL || candidate.descriptor->rhs.call == NULL
            || candidate.descriptor->state_count != tier->columns))
        candidate.refusal = "its kernel is not built in";
    return candidate;
}

/* The most special kernel of the model itself, in t. */
static const jlt_descriptor *own_kernel(const jlt_question *question)
{
    return jlt_descriptor_choose(question->model->model, NULL, NULL, question->params);
}

jlt_status jlt_plan_make(jlt_plan *out, const jlt_question *question)
{
    jlt_plan plan = { .forced = question->tier != NULL };
    const bool own = !jlt_plan_has_tiers(question->model) || (plan.forced && strcmp(question->tier, "model") == 0);
    jlt_top top;
    bool found = false;

    if (plan.forced && !own && jlt_tier_find(question->tier) == NULL) return JLT_ERR_ARG;
    if (plan.forced && !jlt_plan_has_tiers(question->model) && strcmp(question->tier, "model") != 0) return JLT_ERR_ARG;
    plan.reduced = own_kernel(question);
    if (plan.reduced == NULL) return JLT_ERR_UNSUPPORTED;
    if (own) {
        plan.candidates[plan.count++] = (jlt_candidate){ .descriptor = plan.reduced };
        *out = plan;
        return JLT_OK;
    }
    if (jlt_top_read(&top, question->model, question->params) != JLT_OK) return JLT_ERR_UNSUPPORTED;
    for (const jlt_tier *tier = jlt_tier_at(0); tier != NULL; tier = jlt_tier_at(plan.count)) {
        const jlt_candidate candidate = judge(tier, question, &top);
        const bool wanted = plan.forced ? strcmp(tier->name, question->tier) == 0 : !tier->by_name;
        if (wanted && !found && (candidate.refusal == NULL || plan.forced)) {
            plan.chosen = plan.count;
            found = true;
        }
        plan.candidates[plan.count++] = candidate;
    }
    if (!found) return JLT_ERR_UNSUPPORTED;
    *out = plan;
    return plan.candidates[plan.chosen].refusal == NULL ? JLT_OK : JLT_ERR_UNSUPPORTED;
}

const char *jlt_plan_tier(const jlt_plan *plan)
{
    const jlt_tier *tier = plan->candidates[plan->chosen].tier;
    return tier != NULL ? tier->name : "model";
}
