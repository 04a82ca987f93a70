#include "dynamics/section.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/guard.h"
#include "dynamics/chart_crossing.h"
#include "dynamics/section_conditions.h"
#include "dynamics/settling.h"
#include "integrate/epoch.h"
#include "integrate/locate.h"
#include "integrate/rest.h"

struct jlt_section {
    jlt_flow flow;
    jlt_orbit *orbit;
    jlt_event events[JLT_ORBIT_EVENTS_MAX];
    unsigned crossings, event_count; /* the first `crossings` events are of the section, the others losses of model conditions */
    jlt_observed_one conditions[JLT_ORBIT_EVENTS_MAX];
    size_t number;
    int time_direction;
    jlt_epoch began; /* when the integrator was started last, since the orbit's start */
    double clock;    /* of the integrator, at the current return, */
    double x[JLT_CHART_STATES_MAX]; /* which is here */
    jlt_fate start_fate; /* other than alive: the orbit ends where it starts */
    bool rests;          /* at the last return the orbit was found to come to rest */
    jlt_rest_watch rest;
    jlt_settling settling;
    bool settled; /* the orbit has settled on the section */
    double limit[JLT_CHART_STATES_MAX]; /* when rests: the equilibrium */
    bool accepted;   /* restart the integrator at x: it is elsewhere, or differs from x by turns */
    jlt_section_conditions watched; /* the model's conditions since the start */
};

static const struct {
    const char *name;
    jlt_status status;
} fates[JLT_FATE_COUNT] = {
    [JLT_FATE_ALIVE] = { "alive", JLT_OK },
    [JLT_FATE_POLE_PLUS] = { "pole+", JLT_ERR_DOMAIN },
    [JLT_FATE_POLE_MINUS] = { "pole-", JLT_ERR_DOMAIN },
    [JLT_FATE_INVALID] = { "invalid", JLT_ERR_DOMAIN },
    [JLT_FATE_EQUILIBRIUM] = { "equilibrium", JLT_ERR_DOMAIN },
    [JLT_FATE_LEFT_DOMAIN] = { "left_domain", JLT_ERR_DOMAIN },
    [JLT_FATE_BUDGET] = { "budget", JLT_ERR_BUDGET },
    [JLT_FATE_NONFINITE] = { "nonfinite", JLT_ERR_NONFINITE },
    [JLT_FATE_NO_CONVERGENCE] = { "no_convergence", JLT_ERR_NO_CONVERGENCE },
    [JLT_FATE_NO_PROGRESS] = { "no_progress", JLT_ERR_NO_PROGRESS },
};

const char *jlt_section_fate_name(jlt_fate fate)
{
    return (unsigned)fate < JLT_FATE_COUNT ? fates[fate].name : "unknown";
}

void jlt_section_fate_text(char text[JLT_FATE_TEXT_MAX], const jlt_observed *observed, jlt_fate fate, unsigned lost)
{
    if (fate == JLT_FATE_INVALID && observed != NULL)
        snprintf(text, JLT_FATE_TEXT_MAX, "lost_%s", jlt_observed_condition(observed, lost));
    else strcpy(text, jlt_section_fate_name(fate));
}

jlt_fate jlt_section_fate_at_pole(int side)
{
    return side > 0 ? JLT_FATE_POLE_PLUS : side < 0 ? JLT_FATE_POLE_MINUS : JLT_FATE_LEFT_DOMAIN;
}

jlt_status jlt_section_fate_status(jlt_fate fate)
{
    return fates[fate].status;
}

bool jlt_section_failed(jlt_fate fate)
{
    return fate >= JLT_FATE_NONFINITE;
}

bool jlt_section_fate_of(jlt_fate *fate, jlt_status status)
{
    unsigned last = JLT_FATE_COUNT;

    while (--last > JLT_FATE_EQUILIBRIUM)
        if (fates[last].status == status) break;
    *fate = (jlt_fate)last;
    return last > JLT_FATE_EQUILIBRIUM;
}

/* The distance from the nearest section, in units of its errors. */
static double distance_in_errors(const jlt_section *self, const jlt_stepper *stepper)
{
    double least = INFINITY;

    for (unsigned e = 0; e < self->crossings; e++)
        least = fmin(least, fabs(jlt_locate_value(&self->events[e], stepper->x)) / jlt_locate_unit(&self->events[e], stepper));
    return least / jlt_locate_noise(stepper->asked);
}

static int watch(void *context, jlt_orbit *orbit)
{
    jlt_section *self = context;
    const jlt_stepper *stepper = jlt_orbit_stepper(orbit);

    jlt_section_conditions_step(&self->watched, orbit);
    self->settled = jlt_settling_step(&self->settling, distance_in_errors(self, stepper),
                                      fabs(jlt_epoch_time(&self->began, jlt_stepper_time(stepper))));
    if (jlt_rest_is_ahead(stepper, self->events->column, self->events->level)) return self->settled;
    return self->settled || jlt_rest_watch_step(&self->rest, stepper, self->limit);
}

/* Add one event for each condition: their least value has kinks, which no polynomial follows. */
static jlt_status add_conditions(jlt_section *self, const jlt_observed *observed)
{
    const unsigned count = jlt_observed_conditions(observed);

    if (self->event_count + count > JLT_ORBIT_EVENTS_MAX) return JLT_ERR_UNSUPPORTED;
    for (unsigned i = 0; i < count; i++) {
        self->conditions[i] = (jlt_observed_one){ observed, i };
        self->events[self->event_count++] =
            (jlt_event){ .value = jlt_observed_condition_value, .values = jlt_observed_condition_values,
                         .context = &self->conditions[i], .loss = true };
    }
    return JLT_OK;
}

jlt_status jlt_section_create(jlt_section **out, const jlt_flow *flow)
{
    JLT_OWNED(jlt_section) *self = NULL;

    *out = NULL;
    if (flow == NULL || flow->chart == NULL || flow->field == NULL || flow->chart->states != flow->field->dim) return JLT_ERR_ARG;
    if ((int)flow->direction < -1 || (int)flow->direction > 1 || !(flow->t_max >= 0)) return JLT_ERR_ARG;
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    self->flow = *flow;
    if (self->flow.method == NULL) self->flow.method = jlt_method_find(NULL);
    if (self->flow.max_steps == 0) self->flow.max_steps = 100000;
    self->flow.t_max = self->flow.t_max == 0 ? INFINITY : ldexp(self->flow.t_max, -self->flow.units.time);
    JLT_PASS(jlt_orbit_create(&self->orbit, self->flow.method, self->flow.field,
                              &(jlt_options){ .tolerance = flow->tolerance,
                                              .max_steps = self->flow.max_steps,
                                              .invariants = flow->kept,
                                              .project = flow->kept.count > 0,
                                              .interrupt = flow->interrupt }));
    self->crossings = self->event_count = jlt_chart_events(flow->chart, self->events, flow->direction);
    if (flow->end_where_invalid) JLT_PASS(add_conditions(self, flow->observed));
    self->watched.observed = flow->observed;
    self->watched.seeks_least = flow->seeks_least;
    self->watched.looks_within = self->event_count == self->crossings;
    jlt_orbit_observe(self->orbit, watch, self);
    *out = self;
    self = NULL; /* ownership moved to the caller */
    return JLT_OK;
}

void jlt_section_destroy(jlt_section *self)
{
    if (self == NULL) return;
    jlt_orbit_destroy(self->orbit);
    free(self);
}

/* Make x, at the fraction theta of the last step, the point of the current return. */
static void arrive(jlt_section *self, double theta, const double *x)
{
    memcpy(self->x, x, self->flow.chart->states * sizeof *x);
    jlt_chart_turn_back(self->flow.chart, self->x);
    jlt_section_conditions_arrive(&self->watched, theta, x);
}

/* Units are usually the table's own, and ldexp takes longer than all else in `fill`. */
static double scaled(double value, int exponent) { return exponent == 0 ? value : ldexp(value, exponent); }

/* Fill a row, in the table's units, from t and x in the flow's. */
static void fill(jlt_return *row, const jlt_section *self, double t, const double *x, bool on_section)
{
    const jlt_chart *chart = self->flow.chart;

    row->number = self->number;
    row->direction = 0;
    row->fate = JLT_FATE_ALIVE;
    row->lost = self->watched.so_far.condition;
    row->unbounded = JLT_CHART_STATES_MAX;
    row->interrupted = false;
    row->t = scaled(t, self->flow.units.time);
    for (unsigned k = 0; k < chart->states; k++) row->x[k] = scaled(x[k], self->flow.units.state[k]);
    row->residual = scaled(x[chart->column] - chart->level, self->flow.units.state[chart->column]);
    row->least = self->watched.so_far.value;
    row->q[1] = 0; /* pictures of a section of one coordinate show this as the second */
    if (on_section) {
        chart->lower(chart, row->q, NULL, x);
        return;
    }
    for (unsigned k = 0; k < chart->dim; k++) row->q[k] = NAN;
}

static void set_fate(jlt_return *row, const jlt_section *self, const double *x, jlt_fate fate)
{
    row->fate = fate;
    if (fate == JLT_FATE_INVALID) jlt_observed_least(self->flow.observed, &row->lost, x);
}

static jlt_status begin(jlt_section *self, jlt_return *row, const double *x, int time_direction)
{
    const jlt_chart *chart = self->flow.chart;
    double turned[JLT_CHART_STATES_MAX];
    jlt_status st;

    memcpy(turned, x, chart->states * sizeof *x);
    jlt_chart_turn_back(chart, turned);
    x = turned;
    st = jlt_orbit_start(self->orbit, 0, x, time_direction);
    if (!jlt_guard_finite(x, chart->states)) return JLT_ERR_NONFINITE;
    self->start_fate = JLT_FATE_ALIVE;
    if (st != JLT_OK && !jlt_section_fate_of(&self->start_fate, st)) return st;
    self->number = 0;
    self->began = (jlt_epoch){ 0, 0 };
    self->clock = 0;
    self->accepted = self->rests = false;
    self->rest = (jlt_rest_watch){ 0 };
    self->settling = (jlt_settling){ 0 };
    self->time_direction = time_direction;
    jlt_section_conditions_begin(&self->watched);
    arrive(self, 0, x);
    if (jlt_rest_is_still(self->flow.field, x, time_direction)) self->start_fate = JLT_FATE_EQUILIBRIUM;
    if (self->event_count > self->crossings && self->watched.so_far.value <= 0) self->start_fate = JLT_FATE_INVALID;
    if (row == NULL) return JLT_OK;
    fill(row, self, 0, x, x[chart->column] == chart->level);
    set_fate(row, self, x, self->start_fate);
    return JLT_OK;
}

jlt_status jlt_section_start(jlt_section *self, jlt_return *row, const double *q, int time_direction)
{
    double x[JLT_CHART_STATES_MAX];
    const jlt_status st = self->flow.chart->lift(self->flow.chart, x, NULL, q);

    return st != JLT_OK ? st : begin(self, row, x, time_direction);
}

jlt_status jlt_section_start_state(jlt_section *self, jlt_return *row, const double *x, int time_direction)
{
    double counted[JLT_CHART_STATES_MAX];

    for (unsigned k = 0; k < self->flow.chart->states; k++) counted[k] = ldexp(x[k], -self->flow.units.state[k]);
    return begin(self, row, counted, time_direction);
}

/* Make *row the end of the orbit at (t, x). */
static void end(jlt_section *self, jlt_return *row, double t, const double *x, jlt_fate fate)
{
    self->number++;
    jlt_section_conditions_end(&self->watched);
    fill(row, self, t, x, false);
    set_fate(row, self, x, fate);
    if (!jlt_section_failed(fate)) return;
    const unsigned unbounded = jlt_field_unbounded(self->flow.field, x, t);
    if (unbounded < self->flow.chart->states) row->unbounded = unbounded;
}

/* Whether an orbit at rest is at a pole: a method that controls the lifted root's error relative to the root comes as near to a
 * pole as one likes. */
static bool is_pole(const jlt_section *self)
{
    const int root = self->flow.field->root;
    return self->flow.chart->side != NULL && root >= 0 && self->limit[root] < 1e-12;
}

static void end_at_pole(jlt_section *self, jlt_return *row, const jlt_outcome *outcome)
{
    const jlt_chart *chart = self->flow.chart;

    end(self, row, jlt_epoch_time(&self->began, outcome->t), outcome->x, JLT_FATE_LEFT_DOMAIN);
    if (chart->side != NULL) row->fate = jlt_section_fate_at_pole(chart->side(chart, row->x));
}

/* Make *row the end that the outcome reports, other than a crossing of the section. */
static void end_by(jlt_section *self, jlt_return *row, const jlt_outcome *outcome)
{
    const double t = jlt_epoch_time(&self->began, outcome->t);

    switch (outcome->end) {
    case JLT_END_TIME: end(self, row, t, outcome->x, JLT_FATE_BUDGET); return;
    case JLT_END_EVENT:
        jlt_section_conditions_arrive(&self->watched, outcome->crossing.theta, outcome->x);
        jlt_section_conditions_turn(&self->watched);
        end(self, row, t, outcome->x, JLT_FATE_INVALID);
        row->lost = outcome->crossing.event - self->crossings;
        return;
    case JLT_END_OBSERVER:
        if (self->settled && !jlt_rest_ends(jlt_orbit_stepper(self->orbit), self->limit))
            end(self, row, t, outcome->x, JLT_FATE_BUDGET);
        else if (is_pole(self)) end_at_pole(self, row, outcome);
        else end(self, row, t, self->limit, JLT_FATE_EQUILIBRIUM);
        return;
    case JLT_END_POLE: end_at_pole(self, row, outcome); return;
    case JLT_END_INTERRUPT:
        end(self, row, t, outcome->x, JLT_FATE_ALIVE);
        row->interrupted = true;
    }
}

jlt_status jlt_section_next(jlt_section *self, jlt_return *row)
{
    jlt_status st = JLT_OK;
    const jlt_stepper *stepper = jlt_orbit_stepper(self->orbit);
    jlt_outcome outcome = { .t = 0, .x = self->x };
    jlt_fate fate;

    if (self->start_fate != JLT_FATE_ALIVE) {
        end(self, row, 0, self->x, self->start_fate);
        return JLT_OK;
    }
    if (self->rests) {
        end(self, row, jlt_epoch_time(&self->began, self->clock), self->limit, JLT_FATE_EQUILIBRIUM);
        return JLT_OK;
    }
    if (self->accepted) {
        jlt_section_conditions_turn(&self->watched);
        jlt_epoch_move(&self->began, &self->clock);
        st = jlt_orbit_start(self->orbit, 0, self->x, self->time_direction);
    }
    self->accepted = false;
    const jlt_crossing_search search = { self->flow.chart, self->flow.direction, self->events, self->crossings, self->event_count,
                                         self->flow.field->dim, self->flow.max_steps };
    if (st == JLT_OK)
        st = jlt_chart_crossing_find(&search, self->orbit, self->clock + self->time_direction * self->flow.t_max,
                                     self->time_direction, &outcome);
    if (st != JLT_OK) {
        if (!jlt_section_fate_of(&fate, st)) return st;
        end(self, row, jlt_epoch_time(&self->began, outcome.t), outcome.x, fate);
    } else if (outcome.end == JLT_END_EVENT && outcome.crossing.event < self->crossings) {
        self->number++;
        self->clock = outcome.t;
        arrive(self, outcome.crossing.theta, outcome.x);
        fill(row, self, jlt_epoch_time(&self->began, outcome.t), self->x, true);
        row->direction = outcome.crossing.direction;
        self->accepted = self->flow.chart->turn != 0; /* self->x was turned back */
        self->rest = (jlt_rest_watch){ 0 };
        self->settling = (jlt_settling){ 0 };
        self->rests = jlt_rest_is_slower(self->flow.field, self->x, stepper->size, jlt_rest_slow(stepper->asked),
                                         stepper->direction)
                      && jlt_rest_ends(stepper, self->limit);
    } else {
        end_by(self, row, &outcome);
    }
    return JLT_OK;
}

void jlt_section_accept(jlt_section *self, jlt_return *row, double t, const double *x)
{
    const unsigned column = self->flow.chart->column;
    double f[JLT_CHART_STATES_MAX];

    self->number++;
    self->began = (jlt_epoch){ t, 0 };
    self->clock = 0;
    self->accepted = true;
    jlt_section_conditions_turn(&self->watched);
    self->flow.field->call(x, self->flow.field->p, f);
    arrive(self, 0, x);
    fill(row, self, t, x, true);
    row->direction = (f[column] > 0) - (f[column] < 0);
}

void jlt_section_resume(jlt_section *self, size_t number, double t, const double *x)
{
    self->number = number;
    self->began = (jlt_epoch){ t, 0 };
    self->clock = 0;
    self->accepted = true;
    memcpy(self->x, x, self->flow.chart->states * sizeof *x);
}

void jlt_section_note(jlt_section *self, double least, unsigned which)
{
    jlt_section_conditions_note(&self->watched, (jlt_section_least){ least, which });
}

void jlt_section_end(jlt_section *self, jlt_return *row, double t, const double *x, jlt_fate fate, unsigned lost)
{
    end(self, row, t, x, fate);
    if (fate == JLT_FATE_INVALID) row->lost = lost;
}

void jlt_section_cost(const jlt_section *self, size_t *steps, size_t *evaluations)
{
    const jlt_stepper *stepper = jlt_orbit_stepper(self->orbit);

    *steps = stepper->steps + stepper->rejected;
    *evaluations = stepper->evaluations;
}
