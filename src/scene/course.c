#include "scene/course.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "scene/course_conditions.h"
#include "scene/course_drift.h"
#include "scene/course_more.h"
#include "scene/course_pole.h"
#include "scene/course_units.h"
#include "top/rod.h"

enum { CHANGES_MAX = 16 };

typedef struct {
    double t;
    unsigned from, to; /* candidates of the plan */
    char why[JLT_TIER_TEXT_MAX];
} change;

/* Everything that is integrated or watched is in the course's units, unless said otherwise. */
struct jlt_course {
    jlt_plan plan;
    jlt_question question; /* its params and start point to told_params and told_start */
    jlt_course_options options;
    jlt_units units;
    unsigned states, taken, judged; /* of the asked model; taken, judged - 1: candidates that are integrated, with a judged drift */
    int direction; /* of time: +1, -1; 0: not yet known */
    double t;
    bool is_rod;

    jlt_instance *watch; /* the asked model's most special kernel in t, for its integrals */
    jlt_course_drift drift;

    jlt_leg legs[2], *leg; /* leg: the current one; the other is free for the next; NULL: none yet, or nothing is integrated */
    jlt_rod rod;
    change changes[CHANGES_MAX];
    unsigned change_count;
    char edge[JLT_TIER_TEXT_MAX];

    jlt_course_conditions conditions;
    double *seen; /* the quantities that the asked model observes, for rows */
    jlt_course_more more;

    double told_params[JLT_PLAN_PARAMS_MAX], told_start[JLT_PLAN_STATES_MAX]; /* in the table's units */
    double params[JLT_PLAN_PARAMS_MAX], start[JLT_PLAN_STATES_MAX];
    double x[JLT_PLAN_STATES_MAX];
    double row[JLT_PLAN_STATES_MAX]; /* x in the table's units */
};

const jlt_instance *jlt_course_kernel(const jlt_course *self) { return self->is_rod ? self->watch : self->leg->view.instance; }

unsigned jlt_course_integrals(const jlt_course *self) { return self->drift.count; }

const char *jlt_course_integral(const jlt_course *self, unsigned index)
{
    return self->watch->descriptor->integrals[index].name;
}

unsigned jlt_course_changes(const jlt_course *self) { return self->is_rod ? 0 : self->change_count; }

void jlt_course_change(const jlt_course *self, unsigned index, double *t, const char **from, const char **to, const char **why)
{
    const change *c = &self->changes[index];

    *t = c->t;
    *from = self->plan.candidates[c->from].tier.name;
    *to = self->plan.candidates[c->to].tier.name;
    *why = c->why;
}

unsigned jlt_course_observes(const jlt_course *self, const jlt_quantity **quantities)
{
    if (quantities != NULL) *quantities = jlt_observed_quantities(self->conditions.observed);
    return jlt_observed_count(self->conditions.observed);
}

unsigned jlt_course_tells_more(const jlt_course *self, const jlt_quantity **quantities, unsigned *states)
{
    if (quantities != NULL) *quantities = self->more.quantities;
    if (states != NULL) *states = self->more.states;
    return self->more.count;
}

static void note_conditions(jlt_course *self, double t, const double *x)
{
    jlt_course_conditions *conditions = &self->conditions;
    const char *unknown;

    if (!jlt_course_conditions_note(conditions, &unknown, t, x) || jlt_course_conditions_by(conditions->unknown_at, t)
        || !jlt_course_pole_is_off(x, self->question.model, &self->units))
        return;
    conditions->unknown_at = t;
    conditions->unknown = unknown;
}

static int watch_conditions(void *context, jlt_orbit *orbit)
{
    jlt_course *self = context;
    const jlt_stepper *stepper = jlt_orbit_stepper(orbit);
    double x[JLT_PLAN_STATES_MAX];

    jlt_tier_extract(&self->leg->view, x, stepper->x);
    jlt_course_conditions_look_within(&self->conditions, self->leg);
    note_conditions(self, jlt_leg_time(self->leg, jlt_stepper_time(stepper)), x);
    return 0;
}

static jlt_status open_at(jlt_leg *out, const jlt_course *self, unsigned candidate, const double *x, double t)
{
    const jlt_course_options *o = &self->options;
    const jlt_options to_orbit = {
        .tolerance = o->tolerance, .max_steps = o->max_steps, .t_last = ldexp(o->t_last, -self->units.time),
        .interrupt = o->interrupt, .project = o->project
    };
    jlt_tier tier = self->plan.candidates[candidate].tier;
    char refusal[JLT_TIER_TEXT_MAX];

    tier.units = self->units;
    return jlt_leg_open(out, refusal, &tier, self->params, x, t, self->direction,
                        o->method != NULL ? o->method : jlt_method_find(NULL), &to_orbit);
}

/* Continue in the tier of a candidate, from x at t. If the leg cannot be opened, nothing changes. */
static jlt_status open_leg(jlt_course *self, unsigned candidate, const double *x, double t)
{
    jlt_leg *next = self->leg == &self->legs[0] ? &self->legs[1] : &self->legs[0];

    JLT_PASS(open_at(next, self, candidate, x, t));
    if (self->leg != NULL) jlt_leg_close(self->leg);
    self->leg = next;
    if (jlt_observed_conditions(self->conditions.observed) > 0) jlt_orbit_observe(self->leg->orbit, watch_conditions, self);
    self->taken = candidate;
    if (self->question.more) JLT_PASS(jlt_course_more_follow(&self->more, next, self->question.model, &self->units));
    return JLT_OK;
}

/* Set the kernel's params, which headers print, to their values in the table's units. */
static jlt_status tell_params(jlt_course *self)
{
    jlt_instance *kernel = self->leg->view.instance;
    double y[JLT_WAY_VALUES_MAX];
    char refusal[JLT_TIER_TEXT_MAX];
    jlt_tier_view told;

    JLT_PASS(jlt_tier_open(&told, y, refusal, &self->plan.candidates[self->taken].tier, self->question.params,
                           self->question.start));
    memcpy(kernel->params, told.instance->params, kernel->descriptor->param_count * sizeof *kernel->params);
    jlt_tier_close(&told);
    return JLT_OK;
}

static void copy_question(jlt_course *self, const jlt_plan *plan, const jlt_question *question, const jlt_course_options *options)
{
    self->plan = *plan;
    self->question = *question;
    self->options = *options;
    memcpy(self->told_params, question->params, question->model->param_count * sizeof *question->params);
    memcpy(self->told_start, question->start, question->model->state_count * sizeof *question->start);
    self->question.params = self->told_params;
    self->question.start = self->told_start;
    self->states = question->model->state_count;
    self->taken = plan->chosen;
    self->is_rod = plan->candidates[plan->chosen].tier.table == NULL;
}

/* Open a leg in the tier of a candidate from x at t, told in the table's units. DOMAIN: the tier does not serve there. */
static jlt_status open_served(jlt_course *self, unsigned candidate, const double *told, const double *x, double t)
{
    jlt_candidate *next = &self->plan.candidates[candidate];
    bool serves = jlt_plan_serves(&next->tier, next, &self->question, told);
    jlt_status st = JLT_OK;

    if (serves) st = jlt_course_units_serve(&serves, &next->tier, self->told_params, told, &self->units);
    if (st == JLT_OK) st = serves ? open_leg(self, candidate, x, t) : JLT_ERR_DOMAIN;
    return st == JLT_ERR_UNSUPPORTED ? JLT_ERR_DOMAIN : st; /* this tier does not serve in the course's units */
}

/* Quadratures give states at the times of rows alone: between rows conditions are watched along the same motion, integrated in the
 * smallest tier that serves. */
static jlt_status watch_between_rows(jlt_course *self)
{
    jlt_status st = JLT_ERR_DOMAIN;

    if (jlt_observed_conditions(self->conditions.observed) == 0) return JLT_OK;
    for (unsigned i = 0; st == JLT_ERR_DOMAIN && i < self->plan.count; i++)
        if (self->plan.candidates[i].tier.table != NULL) st = open_served(self, i, self->told_start, self->start, 0);
    return st;
}

jlt_status jlt_course_create(jlt_course **out, const jlt_plan *plan, const jlt_question *question,
                             const jlt_course_options *options)
{
    const jlt_descriptor *model = question->model;
    JLT_OWNED(jlt_course) *self = NULL;

    *out = NULL;
    if (question->start == NULL) return JLT_ERR_ARG;
    if (model->state_count > JLT_PLAN_STATES_MAX || model->param_count > JLT_PLAN_PARAMS_MAX
        || plan->reduced->integral_count > JLT_PLAN_STATES_MAX)
        return JLT_ERR_UNSUPPORTED;
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    copy_question(self, plan, question, options != NULL ? options : &(jlt_course_options){ 0 });
    JLT_PASS(jlt_course_units(&self->units, plan, &self->question));
    jlt_units_count(self->params, question->params, model->params, model->param_count, &self->units);
    jlt_units_count(self->start, question->start, model->states, self->states, &self->units);
    memcpy(self->x, self->start, self->states * sizeof *self->x);
    JLT_PASS(jlt_instance_create_in(&self->watch, plan->reduced, question->params, &self->units));
    JLT_PASS(jlt_course_drift_begin(&self->drift, self->watch, self->start));
    JLT_PASS(jlt_course_conditions_open(&self->conditions, model, question->params, &self->units));
    self->seen = calloc(jlt_observed_count(self->conditions.observed) + 1, sizeof *self->seen);
    if (self->seen == NULL) return JLT_ERR_NOMEM;
    note_conditions(self, 0, self->start);
    if (self->is_rod) {
        JLT_PASS(jlt_rod_open(&self->rod, model, self->params, self->start));
        JLT_PASS(watch_between_rows(self));
    } else {
        JLT_PASS(open_leg(self, plan->chosen, self->start, 0));
        JLT_PASS(tell_params(self));
    }
    *out = self;
    self = NULL;
    return JLT_OK;
}

void jlt_course_destroy(jlt_course *self)
{
    if (self == NULL) return;
    if (self->leg != NULL) jlt_leg_close(self->leg);
    jlt_instance_destroy(self->watch);
    jlt_course_conditions_close(&self->conditions);
    jlt_course_more_close(&self->more);
    free(self->seen);
    free(self);
}

/* Convert a row's states and times to the table's units. */
static void restore(jlt_course *self, jlt_course_row *row, double t)
{
    const jlt_units *units = &self->units;

    jlt_units_restore(self->row, self->x, self->question.model->states, self->states, units);
    row->t = ldexp(t, units->time);
    row->lost_at = ldexp(row->lost_at, units->time);
    row->unknown_at = ldexp(row->unknown_at, units->time);
}

/* Fill a row from the states self->x at time t, both in the course's units. */
static void fill(jlt_course *self, jlt_course_row *row, jlt_end end, double t)
{
    *row = (jlt_course_row){ .end = end, .x = self->row, .drift = self->drift.value, .observed = self->seen,
                              .fate = JLT_FATE_LEFT_DOMAIN };
    jlt_course_pole_settle(row, self->x, self->question.model, &self->units, end == JLT_END_POLE);
    jlt_course_drift_note(&self->drift, self->x);
    jlt_observed_values(self->conditions.observed, self->seen, self->x);
    note_conditions(self, t, self->x);
    row->least = self->conditions.least;
    row->lost_at = row->unknown_at = NAN;
    if (jlt_course_conditions_by(self->conditions.lost_at, t)) {
        row->lost_at = self->conditions.lost_at;
        row->lost = self->conditions.lost;
    }
    if (jlt_course_conditions_by(self->conditions.unknown_at, t)) {
        row->unknown_at = self->conditions.unknown_at;
        row->unknown = self->conditions.unknown;
        row->unwatched = self->conditions.unwatched;
    }
    if (self->more.count > 0) {
        jlt_course_more_fill(&self->more, self->leg);
        row->more = self->more.values;
    }
    restore(self, row, t);
}

/* Continue in the next larger tier that serves: from the start of the orbit or, unless `from_start`, from here, where the state has
 * lost digits: half of them if a rate is a root. DOMAIN: there is none. */
static jlt_status change_tier(jlt_course *self, bool from_start)
{
    double here[JLT_PLAN_STATES_MAX];
    jlt_status st = JLT_ERR_DOMAIN;

    if ((self->plan.forced && !self->is_rod) || self->change_count == CHANGES_MAX) return st;
    jlt_units_restore(here, self->x, self->question.model->states, self->states, &self->units);
    for (unsigned i = self->taken + 1; st == JLT_ERR_DOMAIN && i < self->plan.count; i++) {
        const unsigned from = self->taken;
        if (!jlt_plan_serves(&self->plan.candidates[i].tier, &self->plan.candidates[i], &self->question, here)) continue;
        if (self->options.project && jlt_descriptor_doubted_integral(self->plan.candidates[i].descriptor) != NULL) continue;
        st = open_served(self, i, self->told_start, self->start, 0);
        if (st == JLT_ERR_DOMAIN && !from_start) st = open_served(self, i, here, self->x, self->t);
        if (st != JLT_OK) continue;
        change *c = &self->changes[self->change_count++];
        *c = (change){ .t = ldexp(self->t, self->units.time), .from = from, .to = i };
        memcpy(c->why, self->edge, sizeof c->why);
    }
    return st;
}

static void tell_step(const jlt_course *self, jlt_course_row *row)
{
    const jlt_stepper *stepper = jlt_orbit_stepper(self->leg->orbit);

    row->step = ldexp(fabs(jlt_stepper_time(stepper) - jlt_stepper_time_start(stepper)), self->units.time);
    row->stiff = jlt_stepper_is_held(stepper);
}

/* Whether the orbit is wrong in a smaller tier, as where its states no longer determine those of the asked model: the next larger
 * tier passes the pole at which this one ends, or keeps an integral that drifts. A drift is judged once in a tier. */
static bool is_astray(jlt_course *self, const jlt_course_row *row)
{
    const jlt_tier *tier = &self->plan.candidates[self->taken].tier;
    const bool at_pole = row->end == JLT_END_POLE;
    unsigned i = self->taken + 1;
    jlt_leg leg;
    jlt_tier by;

    if (self->is_rod || self->plan.forced || tier->dimension >= self->states || (!at_pole && self->judged > self->taken))
        return false;
    if (!at_pole && !jlt_course_drift_tells(self->edge, &self->drift, tier->name, self->leg->orbit, self->options.tolerance))
        return false;
    self->judged = self->taken + 1;
    while (i < self->plan.count && !jlt_plan_serves(&by, &self->plan.candidates[i], &self->question, self->told_start)) i++;
    if (i == self->plan.count || open_at(&leg, self, i, self->start, 0) != JLT_OK) return false;
    const bool astray = at_pole ? jlt_course_pole_is_passed(&leg, row, self->t, self->question.model, &self->units,
                                                            self->options.tolerance)
                                : jlt_course_drift_is_less(&self->drift, &leg, self->t);
    jlt_leg_close(&leg);
    if (at_pole)
        snprintf(self->edge, sizeof self->edge, "the tier %s passes the pole at which %s ends", self->plan.candidates[i].tier.name,
                 tier->name);
    return astray;
}

static jlt_status along_orbit(jlt_course *self, double t, jlt_course_row *row)
{
    jlt_status st;

    do {
        jlt_outcome outcome;
        unsigned edge;
        st = jlt_leg_to(self->leg, t, &outcome, &edge);
        if (outcome.x != NULL) {
            jlt_tier_extract(&self->leg->view, self->x, self->leg->y);
            self->t = jlt_leg_time(self->leg, outcome.t);
            fill(self, row, outcome.end, self->t);
        }
        if (st != JLT_OK && outcome.x != NULL) row->unbounded = jlt_leg_unbounded(self->leg, outcome.t);
        if (st == JLT_ERR_BUDGET) tell_step(self, row);
        if (st == JLT_OK && is_astray(self, row) && change_tier(self, true) == JLT_OK) {
            jlt_course_conditions_again(&self->conditions);
            note_conditions(self, 0, self->start);
            continue;
        }
        if (st != JLT_ERR_DOMAIN) return st;
        jlt_leg_end_text(self->edge, self->leg, edge);
        row->edge = self->edge;
        st = outcome.x != NULL ? change_tier(self, false) : st;
    } while (st == JLT_OK);
    return st;
}

jlt_status jlt_course_to(jlt_course *self, double t, jlt_course_row *row)
{
    row->x = NULL; /* until a point is reached */
    row->lost_at = row->unknown_at = NAN;
    row->lost = row->unknown = NULL;
    row->unwatched = false;
    t = ldexp(t, -self->units.time);
    if (self->direction != 0 && self->direction * (t - self->t) < 0) return JLT_ERR_ARG;
    if (t == self->t) {
        if (self->direction == 0) memcpy(self->x, self->start, self->states * sizeof *self->x);
        fill(self, row, JLT_END_TIME, t);
        return JLT_OK;
    }
    self->direction = t < self->t ? -1 : 1;
    row->end = JLT_END_TIME;
    const jlt_status st = self->leg != NULL ? along_orbit(self, t, row) : JLT_OK;
    if (self->is_rod && (row->end == JLT_END_POLE || (st != JLT_OK && st != JLT_ERR_NOMEM))) {
        jlt_course_conditions_stop(&self->conditions, self->t);
        jlt_leg_close(self->leg);
        self->leg = NULL;
        row->end = JLT_END_TIME;
    } else if (st != JLT_OK || !self->is_rod) return st;
    if (self->leg == NULL) self->t = t;
    JLT_PASS(jlt_rod_at(&self->rod, self->x, self->t));
    fill(self, row, row->end, self->t);
    return JLT_OK;
}

void jlt_course_cost(const jlt_course *self, size_t *steps, size_t *evaluations)
{
    *steps = *evaluations = 0;
    if (self->is_rod) return;
    const jlt_stepper *stepper = jlt_orbit_stepper(self->leg->orbit);
    *steps = stepper->steps;
    *evaluations = stepper->evaluations;
}
