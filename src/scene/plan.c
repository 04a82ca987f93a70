#include "scene/plan.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "scene/course_more.h"
#include "top/rod.h"

/* The name of a known model for which the larger table is proved to serve; NULL: none. Out: *serves, whether it is for any. */
static const char *served_by(bool *serves, const jlt_descriptor *larger, const jlt_way_tables *others)
{
    const jlt_descriptor *served = NULL;

    *serves = false;
    for (const jlt_claim *claim = larger->claims; claim->kind != NULL && served == NULL; claim++) {
        if (claim->target == NULL || strcmp(claim->kind, "reduction") != 0 || claim->verdict != JLT_PROVED) continue;
        *serves = true;
        served = jlt_way_target(&(jlt_way){ .sha256 = claim->target }, others);
    }
    return served != NULL ? served->model : NULL;
}

/* Say why a claim does not hold; claim NULL: the larger table has no claim that it reduces onto `from`. */
static void say_lack(char *text, size_t size, const jlt_claim *claim, const jlt_descriptor *from, const jlt_descriptor *larger,
                     const jlt_way_tables *others)
{
    bool serves = false;
    const char *served = claim == NULL ? served_by(&serves, larger, others) : NULL;

    if (claim != NULL)
        snprintf(text, size, "a claim that it rests on is %s", claim->verdict == JLT_REFUTED ? "refuted" : "not settled");
    else if (!serves) snprintf(text, size, "it is proved to serve for no table");
    else if (served == NULL || strcmp(served, from->model) == 0)
        snprintf(text, size, "it is proved to serve for another table%s, not for this one", served != NULL ? " of this name" : "");
    else snprintf(text, size, "it is proved to serve for another table, %s, not for this one", served);
}

/* Say why the tier's table cannot be reached by proved claims, and return true, unless it can. Out: *broken, the unproved claim;
 * NULL: none. */
static bool say_unproved(char *text, size_t size, const jlt_claim **broken, const jlt_tier *tier, const jlt_way_tables *others)
{
    for (unsigned i = 0; i < tier->way_count; i++) {
        const jlt_descriptor *to = i + 1 < tier->way_count ? tier->from[i + 1] : tier->table;
        if (jlt_way_holds(broken, tier->from[i], tier->ways[i], to)) continue;
        say_lack(text, size, *broken, tier->from[i], to, others);
        return true;
    }
    *broken = tier->elimination[0] != '\0' ? jlt_descriptor_claim(tier->asked, "eliminate", tier->elimination) : NULL;
    if (*broken != NULL && (*broken)->verdict == JLT_PROVED) *broken = NULL;
    if (*broken != NULL) say_lack(text, size, *broken, tier->asked, NULL, others);
    return *broken != NULL;
}

void jlt_plan_refusal(char *text, size_t size, const jlt_candidate *candidate)
{
    const jlt_claim *claim = candidate->broken;

    if (claim == NULL) snprintf(text, size, "%s", candidate->refusal);
    else snprintf(text, size, "%s (%s %s: %s)", candidate->refusal, claim->kind, claim->name, claim->reason);
}

/* Find the tier's kernel, and whether its own conditions hold for the question. Errors: NOMEM. */
static jlt_status try_tier(jlt_candidate *c, const jlt_question *question)
{
    double y[JLT_WAY_VALUES_MAX];
    jlt_tier_view view;
    const jlt_status st = jlt_tier_open(&view, y, c->refusal, &c->tier, question->params, question->start);

    if (st == JLT_OK) {
        c->descriptor = view.instance->descriptor;
        jlt_tier_close(&view);
        return st;
    }
    c->descriptor = jlt_descriptor_sibling(c->tier.table, NULL, c->tier.time, c->tier.elimination);
    if (st == JLT_ERR_NOMEM) return st;
    if (st != JLT_ERR_UNSUPPORTED) {
        const jlt_descriptor *d = question->model;
        unsigned i = 0;
        while (i < d->param_count && !isnan(question->params[i])) i++;
        if (i < d->param_count) snprintf(c->refusal, sizeof c->refusal, "%s of %s has no value", d->params[i].name, d->model);
        else snprintf(c->refusal, sizeof c->refusal, "its kernel overflows there, or divides by what is 0 or underflows");
    }
    return JLT_OK;
}

/* Judge a tier by one of its ways. Errors: NOMEM. */
static jlt_status judge_way(jlt_candidate *out, const jlt_tier *tier, const jlt_question *question)
{
    jlt_candidate c = { .tier = *tier };
    const char *refusal = NULL;

    if (tier->table == NULL) refusal = jlt_rod_refuses(&c.broken, question->model, question->params, question->start);
    else JLT_PASS(try_tier(&c, question));
    c.may_serve_elsewhere = c.refusal[0] != '\0' || (refusal != NULL && c.broken == NULL);
    if (question->section && (c.descriptor == NULL || c.descriptor->family[0]->section_count == 0 || tier->elimination[0] != '\0'))
        refusal = "its table describes no section";
    else if (c.refusal[0] == '\0' && refusal == NULL && question->more
             && (tier->elimination[0] != '\0' || !jlt_course_more_is_told(tier->table, question->model)))
        refusal = "its table observes no more than the model's";
    if (refusal != NULL) snprintf(c.refusal, sizeof c.refusal, "%s", refusal);
    if ((tier->table != NULL || refusal == NULL) && say_unproved(c.refusal, sizeof c.refusal, &c.broken, tier, question->others))
        c.may_serve_elsewhere = false;
    *out = c;
    return JLT_OK;
}

/* Judge a tier by all ways to its table, and take the first by which it serves; if there is none, keep the refusal of the first
 * way by which it may serve elsewhere, or else of the first way. Errors: NOMEM. */
static jlt_status judge(jlt_candidate *out, const jlt_tier *tier, const jlt_question *question)
{
    jlt_status st = judge_way(out, tier, question);
    jlt_candidate c;
    jlt_tier other;

    for (unsigned i = 1; st == JLT_OK && out->refusal[0] != '\0' && jlt_tier_by_way(&other, tier, i, question->others); i++) {
        st = judge_way(&c, &other, question);
        if (st == JLT_OK && (c.refusal[0] == '\0' || (c.may_serve_elsewhere && !out->may_serve_elsewhere))) *out = c;
    }
    return st;
}

jlt_status jlt_plan_make(jlt_plan *out, const jlt_question *question)
{
    jlt_tier tiers[JLT_TIERS_MAX], named;
    jlt_plan plan = { .forced = question->tier != NULL };

    if (question->model == NULL || question->params == NULL) return JLT_ERR_ARG;
    const bool own = plan.forced && strcmp(question->tier, "model") == 0;
    bool found = false;

    if (plan.forced && !jlt_tier_find(&named, question->model, question->others, question->tier)) return JLT_ERR_ARG;
    plan.count = own ? 1 : jlt_tier_list(tiers, question->model, question->others);
    if (own) tiers[0] = named;
    plan.reduced = jlt_descriptor_choose(question->model, NULL, NULL, question->params);
    if (plan.reduced == NULL) return JLT_ERR_UNSUPPORTED;
    for (unsigned i = 0; i < plan.count; i++) {
        JLT_PASS(judge(&plan.candidates[i], &tiers[i], question));
        const bool wanted = plan.forced ? strcmp(tiers[i].name, question->tier) == 0 : !tiers[i].by_name;
        if (!wanted || found || (plan.candidates[i].refusal[0] != '\0' && !plan.forced)) continue;
        plan.chosen = i;
        found = true;
    }
    *out = plan;
    return found && plan.candidates[plan.chosen].refusal[0] == '\0' ? JLT_OK : JLT_ERR_UNSUPPORTED;
}

bool jlt_plan_serves(jlt_tier *by, const jlt_candidate *candidate, const jlt_question *question, const double *start)
{
    jlt_question there = *question;
    jlt_candidate again;

    there.start = start;
    if (candidate->tier.by_name || judge(&again, &candidate->tier, &there) != JLT_OK || again.refusal[0] != '\0') return false;
    *by = again.tier;
    return true;
}

const char *jlt_plan_tier(const jlt_plan *plan)
{
    return plan->candidates[plan->chosen].tier.name;
}
