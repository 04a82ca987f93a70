#include "scene/course.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "kernel/observed.h"
#include "top/conserved.h"
#include "top/rod.h"

enum { INTEGRALS_MAX = 8 };

struct jlt_course {
    const jlt_tier *tier; /* NULL: the model's own kernel */
    jlt_tier_view view; /* in the course's units, as everything below is that is integrated or watched */
    jlt_units units;
    const jlt_quantity *quantities; /* (states,): of the asked model */
    bool has_tiers;
    unsigned states;
    int direction; /* of time so far: 0, +1, -1 */
    double t;

    jlt_instance *watch; /* the asked model's kernel: integrals */
    double first[INTEGRALS_MAX], drift[INTEGRALS_MAX];

    jlt_instance *instance; /* the tier's kernel */
    jlt_field field;
    jlt_conserved conserved;
    jlt_orbit *orbit;
    jlt_rod rod;

    jlt_observed *observed; /* of the asked model's states */
    double *seen; /* what it observes there */
    double least, lost_at;
    const char *lost; /* the condition, NULL: none */

    double params[JLT_PLAN_PARAMS_MAX]; /* of the asked model, in the course's units */
    double start[JLT_PLAN_STATES_MAX];
    double x[JLT_PLAN_STATES_MAX];
    double y[JLT_FIELD_DIM_MAX];
    double row[JLT_PLAN_STATES_MAX]; /* x in the table's units */
};

const jlt_instance *jlt_course_kernel(const jlt_course *self)
{
    return self->instance != NULL ? self->instance : self->watch;
}

unsigned jlt_course_integrals(const jlt_course *self)
{
    const unsigned count = self->watch->descriptor->integral_count;
    if (self->watch->descriptor->integral_values.call == NULL) return 0;
    return count < INTEGRALS_MAX ? count : INTEGRALS_MAX;
}

const char *jlt_course_integral(const jlt_course *self, unsigned index)
{
    return self->watch->descriptor->integrals[index].name;
}

static void integrals(const jlt_course *self, double *values, const double *x)
{
    double all[JLT_PLAN_STATES_MAX];

    if (jlt_course_integrals(self) == 0) return;
    self->watch->descriptor->integral_values.call(x, self->watch->block, all);
    memcpy(values, all, jlt_course_integrals(self) * sizeof *values);
}

static void extract(const jlt_course *self, double *x, const double *y)
{
    if (self->tier == NULL) memcpy(x, y, self->states * sizeof *x);
    else if (self->tier->extract != NULL) self->tier->extract(&self->view, x, y);
}

unsigned jlt_course_observes(const jlt_course *self, const jlt_quantity **quantities)
{
    if (quantities != NULL) *quantities = jlt_observed_quantities(self->observed);
    return jlt_observed_count(self->observed);
}

static void note_conditions(jlt_course *self, double t, const double *x)
{
    /* NaN at a pole where the level does not tell the rotation: nothing is known there. */
    unsigned condition = 0;
    const double value = jlt_observed_least(self->observed, &condition, x);

    if (value < self->least) self->least = value;
    if (value <= 0 && isnan(self->lost_at)) {
        self->lost_at = t;
        self->lost = jlt_observed_condition(self->observed, condition);
    }
}

static int watch_conditions(void *context, jlt_orbit *orbit)
{
    jlt_course *self = context;
    const jlt_stepper *stepper = jlt_orbit_stepper(orbit);
    double x[JLT_PLAN_STATES_MAX];

    extract(self, x, stepper->x);
    note_conditions(self, self->view.mirror * jlt_stepper_time(stepper), x);
    return 0;
}

/* The tier's kernel bound to its parameters, and an orbit from the start; told: the tier's view in the table's units. */
static jlt_status open_orbit(jlt_course *self, const jlt_candidate *chosen, const jlt_tier_view *told,
                             const jlt_question *question, const jlt_course_options *options)
{
    jlt_status st = JLT_OK;
    double params[JLT_PLAN_PARAMS_MAX];
    jlt_options to_orbit = { .tolerance = options->tolerance, .max_steps = options->max_steps,
                             .interrupt = options->interrupt, .project = options->project };

    if (chosen->tier == NULL) {
        JLT_TRY(jlt_instance_create_in(&self->instance, chosen->descriptor, question->params, &self->units));
        memcpy(self->y, self->start, self->states * sizeof *self->y);
    } else {
        JLT_TRY(jlt_tier_params(params, &self->view));
        JLT_TRY(jlt_instance_create(&self->instance, chosen->descriptor, params));
        JLT_TRY(jlt_tier_params(self->instance->params, told)); /* for headers */
        chosen->tier->embed(&self->view, self->y, self->start);
    }
    JLT_TRY(jlt_field_of(&self->field, chosen->descriptor, self->instance->block));
    if (options->project) JLT_TRY(jlt_conserved_of(&to_orbit.invariants, &self->conserved, chosen->descriptor, &self->field));
    JLT_TRY(jlt_orbit_create(&self->orbit, options->method != NULL ? options->method : jlt_method_find(NULL), &self->field,
                             &to_orbit));
    if (jlt_observed_conditions(self->observed) > 0) jlt_orbit_observe(self->orbit, watch_conditions, self);
done:
    return st;
}

jlt_status jlt_course_create(jlt_course **out, const jlt_plan *plan, const jlt_question *question,
                             const jlt_course_options *options)
{
    jlt_status st = JLT_OK;
    const jlt_candidate *chosen = &plan->candidates[plan->chosen];
    const jlt_descriptor *model = question->model;
    jlt_tier_view told = { 0 };
    jlt_course *self = NULL;

    *out = NULL;
    if (model->state_count > JLT_PLAN_STATES_MAX || plan->reduced->integral_count > JLT_PLAN_STATES_MAX)
        return JLT_ERR_UNSUPPORTED;
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    self->states = model->state_count;
    self->view.mirror = 1;
    self->least = INFINITY;
    self->lost_at = NAN;
    self->tier = chosen->tier;
    self->quantities = model->states;
    self->has_tiers = jlt_tier_has(model);
    if (self->has_tiers)
        JLT_TRY(jlt_tier_open(&told, &self->view, &self->units, self->params, chosen->tier, chosen->descriptor, model, question->params,
                              question->start));
    jlt_units_count(self->start, question->start, model->states, self->states, &self->units);
    memcpy(self->x, self->start, self->states * sizeof *self->x);
    JLT_TRY(jlt_instance_create_in(&self->watch, plan->reduced, question->params, &self->units));
    integrals(self, self->first, self->start);
    JLT_TRY(jlt_observed_create(&self->observed, model, question->params, &self->units));
    st = JLT_ERR_NOMEM;
    self->seen = calloc(jlt_observed_count(self->observed) + 1, sizeof *self->seen);
    if (self->seen == NULL) goto done;
    st = JLT_OK;
    note_conditions(self, 0, self->start);
    if (chosen->tier != NULL && chosen->tier->model == NULL) JLT_TRY(jlt_rod_open(&self->rod, &self->view.top, self->start));
    if (chosen->descriptor != NULL) JLT_TRY(open_orbit(self, chosen, &told, question, options));
    *out = self;
    self = NULL;
done:
    jlt_course_destroy(self);
    return st;
}

void jlt_course_destroy(jlt_course *self)
{
    if (self == NULL) return;
    jlt_orbit_destroy(self->orbit);
    jlt_instance_destroy(self->instance);
    jlt_instance_destroy(self->watch);
    jlt_observed_destroy(self->observed);
    free(self->seen);
    free(self);
}

/* A row's numbers in the table's units. */
static void restore(jlt_course *self, jlt_course_row *row, double t)
{
    const jlt_units *units = &self->units;

    jlt_units_restore(self->row, self->x, self->quantities, self->states, units);
    row->t = ldexp(t, units->time);
    row->lost_at = ldexp(row->lost_at, units->time);
    for (unsigned i = 0; i < 2; i++) {
        row->attitude.centre[i] = ldexp(row->attitude.centre[i], units->length);
        row->attitude.contact[i] = ldexp(row->attitude.contact[i], units->length);
    }
}

/* Everything a row says of the states in self->x at t, both in the course's units. */
static void fill(jlt_course *self, jlt_course_row *row, jlt_end end, double t)
{
    double now[INTEGRALS_MAX];

    *row = (jlt_course_row){ .end = end, .x = self->row, .drift = self->drift, .observed = self->seen };
    if (self->has_tiers) row->side = jlt_tier_settle(self->x, end == JLT_END_POLE);
    integrals(self, now, self->x);
    for (unsigned i = 0; i < jlt_course_integrals(self); i++)
        self->drift[i] = fabs(now[i] - self->first[i]) / fmax(1, fabs(self->first[i]));
    jlt_observed_values(self->observed, self->seen, self->x);
    note_conditions(self, t, self->x);
    row->least = self->least;
    row->lost_at = self->lost_at;
    row->lost = self->lost;
    if (self->tier != NULL && self->tier->orient != NULL) {
        row->has_attitude = true;
        self->tier->orient(&self->view, &row->attitude, self->y);
    }
    restore(self, row, t);
}

static jlt_status along_orbit(jlt_course *self, double t, jlt_course_row *row)
{
    jlt_status st = JLT_OK;
    const int mirror = self->view.mirror;
    const jlt_tier_edge *end = self->tier != NULL ? self->tier->edge : NULL;
    jlt_event edge = { .context = &self->view };
    jlt_outcome outcome = { 0 };

    if (end != NULL) {
        edge.value = end->value;
        edge.longest_step = end->longest_step;
    }
    if (end != NULL && self->direction == 0 && !(edge.value(edge.context, self->y) > 0)) {
        fill(self, row, JLT_END_TIME, 0);
        row->edge = end->meaning;
        return JLT_ERR_DOMAIN;
    }
    if (self->direction == 0) {
        self->direction = t < 0 ? -1 : 1;
        JLT_TRY(jlt_orbit_start(self->orbit, 0, self->y, self->direction * mirror));
    }
    st = jlt_orbit_next(self->orbit, mirror * t, &edge, end != NULL, &outcome);
    if (outcome.x != NULL) {
        memcpy(self->y, outcome.x, self->field.dim * sizeof *self->y);
        extract(self, self->x, self->y);
        self->t = mirror * outcome.t;
        fill(self, row, outcome.end, self->t);
    }
    if (st == JLT_OK && outcome.end == JLT_END_EVENT) {
        row->end = JLT_END_TIME;
        row->edge = end->meaning;
        st = JLT_ERR_DOMAIN;
    } else if (st == JLT_ERR_DOMAIN) {
        row->edge = self->has_tiers ? jlt_tier_near_pole : "the orbit comes to the edge of its table's domain";
    }
done:
    return st;
}

jlt_status jlt_course_to(jlt_course *self, double t, jlt_course_row *row)
{
    jlt_status st = JLT_OK;

    row->x = NULL; /* until a point is reached */
    row->lost_at = NAN;
    row->lost = NULL;
    t = ldexp(t, -self->units.time);
    if (self->direction != 0 && self->direction * (t - self->t) < 0) return JLT_ERR_ARG;
    if (t == self->t) {
        if (self->direction == 0) memcpy(self->x, self->start, self->states * sizeof *self->x);
        fill(self, row, JLT_END_TIME, t);
        return JLT_OK;
    }
    if (self->orbit != NULL) return along_orbit(self, t, row);
    JLT_TRY(jlt_rod_at(&self->rod, self->x, t));
    self->direction = t < 0 ? -1 : 1;
    self->t = t;
    fill(self, row, JLT_END_TIME, t);
done:
    return st;
}

void jlt_course_cost(const jlt_course *self, size_t *steps, size_t *evaluations)
{
    *steps = *evaluations = 0;
    if (self->orbit == NULL) return;
    const jlt_stepper *stepper = jlt_orbit_stepper(self->orbit);
    *steps = stepper->steps;
    *evaluations = stepper->evaluations;
}
