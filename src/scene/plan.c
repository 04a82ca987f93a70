#include "scene/plan.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "integrate/field.h"
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

/* Refuse the tier if x, the states to which its rounded coordinates lead back, are not near the start, both in the units in which
 * the orbit has this size: if one is off by more than the default tolerance, as errors of a motion are measured, and by more than
 * what states as large as the largest lose by rounding. Returns whether it is refused. */
static bool refuse_moved(jlt_candidate *c, const double *x, const double *start, const jlt_descriptor *model)
{
    double largest = 0;

    for (unsigned i = 0; i < model->state_count; i++) largest = fmax(largest, fabs(start[i]));
    for (unsigned i = 0; i < model->state_count; i++) {
        const double near = fmax(0x1p-40 * fmax(fabs(start[i]), jlt_field_size(largest)), 16 * DBL_EPSILON * largest);
        if (fabs(x[i] - start[i]) <= near) continue;
        snprintf(c->refusal, sizeof c->refusal, "its coordinates lose digits of %s there", model->states[i].name);
        return true;
    }
    return false;
}

/* Refuse the tier if a rounding of one of its coordinates y of the start, or of a parameter of its tables, moves the start: a level
 * that is a difference of large numbers, or that underflows, has lost the digits of a small state. */
static void refuse_lost(jlt_candidate *c, const jlt_tier_view *view, const double *y, const jlt_question *question)
{
    const jlt_descriptor *model = question->model;
    double start[JLT_WAY_VALUES_MAX], x[JLT_WAY_VALUES_MAX], near[JLT_WAY_VALUES_MAX];
    jlt_tier_view other = *view;
    jlt_units units = { 0 };
    bool refused = false;

    if (!model->scales || jlt_instance_units(&units, model, question->params, question->start) != JLT_OK) units = (jlt_units){ 0 };
    jlt_units_count(start, question->start, model->states, model->state_count, &units);
    memcpy(near, y, view->instance->descriptor->state_count * sizeof *near);
    for (unsigned k = 0; k < view->instance->descriptor->state_count && !refused; k++) {
        near[k] = nextafter(y[k], INFINITY);
        jlt_tier_extract(view, x, near);
        jlt_units_count(x, x, model->states, model->state_count, &units);
        refused = refuse_moved(c, x, start, model);
        near[k] = y[k];
    }
    for (unsigned i = 0; i < view->tier.way_count; i++) {
        for (unsigned k = 0; k < view->tier.ways[i]->param_count && !refused; k++) {
            other.params[i + 1][k] = nextafter(view->params[i + 1][k], INFINITY);
            jlt_tier_extract(&other, x, y);
            jlt_units_count(x, x, model->states, model->state_count, &units);
            refused = refuse_moved(c, x, start, model);
            other.params[i + 1][k] = view->params[i + 1][k];
        }
    }
}

/* Find the tier's kernel, and whether its own conditions hold for the question. Errors: NOMEM. */
static jlt_status try_tier(jlt_candidate *c, const jlt_question *question)
{
    double y[JLT_WAY_VALUES_MAX];
    jlt_tier_view view;
    const jlt_status st = jlt_tier_open(&view, y, c->refusal, &c->tier, question->params, question->start);

    if (st == JLT_OK) {
        c->descriptor = view.instance->descriptor;
        const bool is_own = c->tier.way_count == 0 && c->tier.elimination[0] == '\0';
        const bool is_named = question->tier != NULL || c->tier.by_name; /* to be compared, say */
        if (question->start != NULL && !is_named && !is_own) refuse_lost(c, &view, y, question);
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
