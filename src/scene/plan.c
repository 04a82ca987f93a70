#include "scene/plan.h"

#include <stdio.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "kernel/link.h"

/* The table whose kernels a tier takes: the one that was asked about where it has the tier's name. */
static const jlt_descriptor *table_of(const char *name, const jlt_descriptor *asked)
{
    return strcmp(name, asked->model) == 0 ? asked : jlt_descriptor_find(name, NULL, NULL, NULL);
}

/* The most special kernel of a tier for these parameters; a model of its own is asked with its own parameters. */
static const jlt_descriptor *kernel_of(const jlt_tier *tier, const jlt_question *question, const jlt_top *top, const double *x)
{
    const jlt_descriptor *table = table_of(tier->model, question->model);
    const jlt_descriptor *general = table == NULL ? NULL : jlt_descriptor_sibling(table, NULL, tier->time, tier->elimination);
    double params[JLT_PLAN_PARAMS_MAX];
    jlt_tier_view view;

    if (general == NULL || general->param_count > JLT_PLAN_PARAMS_MAX) return NULL;
    jlt_tier_look(&view, tier, general, top, x);
    view.asked = question->model;
    view.asked_params = question->params;
    if (jlt_tier_params(params, &view) != JLT_OK) return NULL;
    return jlt_descriptor_choose(table, tier->time, tier->elimination, params);
}

/* What a claim lacks; NULL where it is proved. */
static const char *want_of(const jlt_claim *claim)
{
    if (claim == NULL) return "its table makes no claim that leads there";
    if (claim->verdict == JLT_PROVED) return NULL;
    return claim->verdict == JLT_REFUTED ? "a claim that it rests on is refuted" : "a claim that it rests on is not settled";
}

/* Why nothing proved leads from the asked table to the tier's; NULL where it does. */
static const char *unproved(const jlt_claim **broken, const jlt_tier *tier, const jlt_descriptor *asked)
{
    const jlt_descriptor *table = table_of(tier->proofs.table, asked);
    const char *want = NULL;

    *broken = NULL;
    if (table == NULL) return NULL; /* its kernel is not there: that is told elsewhere */
    if (!jlt_link_holds(broken, asked, table))
        return *broken != NULL ? want_of(*broken) : "it is proved to serve for another table of this name, not for this one";
    for (size_t i = 0; want == NULL && i < JLT_TIER_CLAIMS_MAX && tier->proofs.claims[i].kind != NULL; i++) {
        const jlt_claim *claim = jlt_descriptor_claim(asked, tier->proofs.claims[i].kind, tier->proofs.claims[i].name);
        want = want_of(claim);
        *broken = want != NULL ? claim : NULL;
    }
    return want;
}

void jlt_plan_refusal(char *text, size_t size, const jlt_candidate *candidate)
{
    const jlt_claim *claim = candidate->broken;

    if (claim == NULL) snprintf(text, size, "%s", candidate->refusal);
    else snprintf(text, size, "%s (%s %s: %s)", candidate->refusal, claim->kind, claim->name, claim->reason);
}

static bool has_section(const jlt_tier *tier)
{
    const jlt_descriptor *kernel = tier->model != NULL ? jlt_descriptor_find(tier->model, NULL, tier->time, tier->elimination) : NULL;

    return kernel != NULL && kernel->section_count > 0;
}

static jlt_candidate judge(const jlt_tier *tier, const jlt_question *question, const jlt_top *top)
{
    static const double anywhere[JLT_PLAN_STATES_MAX] = { 0 };
    const double *start = question->start != NULL ? question->start : anywhere;
    jlt_candidate candidate = { .tier = tier };

    if (question->section && !has_section(tier))
        candidate.refusal = "its table describes no section";
    else if (tier->refuses != NULL) candidate.refusal = tier->refuses(top, start);
    if (candidate.refusal == NULL && question->attitude && !tier->attitude)
        candidate.refusal = "attitude and track are asked for";
    if (candidate.refusal == NULL) candidate.refusal = unproved(&candidate.broken, tier, question->model);
    if (tier->model != NULL) candidate.descriptor = kernel_of(tier, question, top, start);
    if (candidate.refusal == NULL && tier->model != NULL
        && (candidate.descriptor == NULL || candidate.descriptor->rhs.call == NULL
            || candidate.descriptor->state_count != tier->columns))
        candidate.refusal = "its kernel is not built in";
    return candidate;
}

/* The most special kernel of the model itself, in t. */
static const jlt_descriptor *own_kernel(const jlt_question *question)
{
    return jlt_descriptor_choose(question->model, NULL, NULL, question->params);
}

jlt_status jlt_plan_make(jlt_plan *out, const jlt_question *question)
{
    jlt_plan plan = { .forced = question->tier != NULL };
    const bool own = !jlt_tier_has(question->model) || (plan.forced && strcmp(question->tier, "model") == 0);
    jlt_top top;
    bool found = false;

    if (plan.forced && !own && jlt_tier_find(question->tier) == NULL) return JLT_ERR_ARG;
    if (plan.forced && !jlt_tier_has(question->model) && strcmp(question->tier, "model") != 0) return JLT_ERR_ARG;
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
