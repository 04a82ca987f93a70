#include "dynamics/section.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct jlt_section {
    jlt_flow flow;
    jlt_orbit *orbit;
    jlt_event events[2];
    unsigned event_count;
    size_t number;
    int time_direction;
    double t_start;  /* of the current return */
    double x[JLT_CHART_STATES_MAX]; /* there */
    bool at_rest;
    bool accepted;   /* the orbit's own integrator has not been there */
    double contact;
};

static const char *const fate_names[] = { "alive", "pole+", "pole-", "lost_contact", "budget" };

const char *jlt_section_fate_name(jlt_fate fate)
{
    return (unsigned)fate < sizeof fate_names / sizeof *fate_names ? fate_names[fate] : "unknown";
}

/* As an event the reaction needs the field, which the integrator's value function is not given. */
static double contact_value(void *context, const double *x)
{
    const jlt_section *self = context;
    double f[JLT_CHART_STATES_MAX];

    self->flow.field->call(x, self->flow.field->p, f);
    return self->flow.chart->contact(self->flow.chart, x, f);
}

static int watch_contact(void *context, jlt_orbit *orbit)
{
    jlt_section *self = context;
    const jlt_stepper *stepper = jlt_orbit_stepper(orbit);
    const double contact = self->flow.chart->contact(self->flow.chart, stepper->x, stepper->f);

    if (contact < self->contact) self->contact = contact;
    return 0;
}

jlt_status jlt_section_create(jlt_section **out, const jlt_flow *flow)
{
    jlt_status st = JLT_OK;
    jlt_section *self = NULL;

    *out = NULL;
    if (flow->chart == NULL || flow->field == NULL || flow->chart->states != flow->field->dim) return JLT_ERR_ARG;
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    self->flow = *flow;
    if (self->flow.method == NULL) self->flow.method = jlt_method_find(NULL);
    if (self->flow.max_steps == 0) self->flow.max_steps = 100000;
    self->flow.t_max = self->flow.t_max == 0 ? INFINITY : ldexp(self->flow.t_max, -self->flow.units.time);
    JLT_TRY(jlt_orbit_create(&self->orbit, self->flow.method, self->flow.field,
                             &(jlt_options){ .tolerance = flow->tolerance,
                                             .max_steps = self->flow.max_steps,
                                             .interrupt = flow->interrupt }));
    self->events[0] = (jlt_event){ .column = flow->chart->column,
                                   .level = flow->chart->level,
                                   .direction = flow->direction };
    self->event_count = 1;
    if (flow->chart->contact != NULL) {
        jlt_orbit_observe(self->orbit, watch_contact, self);
        if (flow->end_at_contact_loss) {
            self->events[1] = (jlt_event){ .value = contact_value, .context = self, .direction = JLT_BOTH };
            self->event_count = 2;
        }
    }
    *out = self;
    self = NULL; /* ownership moved to the caller */
done:
    jlt_section_destroy(self);
    return st;
}

void jlt_section_destroy(jlt_section *self)
{
    if (self == NULL) return;
    jlt_orbit_destroy(self->orbit);
    free(self);
}

/* f: the field at x. */
static double speed(const jlt_section *self, const double *x, const double *f)
{
    double fastest = 0;

    for (unsigned i = 0; i < self->flow.chart->states; i++) fastest = fmax(fastest, fabs(f[i]) / fmax(1, fabs(x[i])));
    return fastest;
}

double jlt_section_speed(const jlt_section *self, const double *x)
{
    double f[JLT_CHART_STATES_MAX];

    self->flow.field->call(x, self->flow.field->p, f);
    return speed(self, x, f);
}

/* Take x for the point of the current return; f gets the field there. Returns the normal reaction. */
static double arrive(jlt_section *self, const double *x, double *f)
{
    static const double still = 1e-12; /* a crossing there is rounding error */
    const jlt_chart *chart = self->flow.chart;

    self->flow.field->call(x, self->flow.field->p, f);
    self->at_rest = speed(self, x, f) < still;
    memcpy(self->x, x, chart->states * sizeof *x);
    return chart->contact != NULL ? chart->contact(chart, x, f) : INFINITY;
}

/* t and x in the flow's units; the row gets them in the table's. */
static void fill(jlt_return *row, const jlt_section *self, double t, const double *x, bool on_section)
{
    const jlt_chart *chart = self->flow.chart;
    unsigned k;

    memset(row, 0, sizeof *row);
    row->number = self->number;
    row->t = ldexp(t, self->flow.units.time);
    for (k = 0; k < chart->states; k++) row->x[k] = ldexp(x[k], self->flow.units.state[k]);
    row->residual = ldexp(x[chart->column] - chart->level, self->flow.units.state[chart->column]);
    row->contact = ldexp(self->contact, self->flow.units.contact);
    if (on_section) {
        chart->lower(chart, row->q, NULL, x);
        return;
    }
    for (k = 0; k < chart->dim; k++) row->q[k] = NAN;
}

static jlt_status begin(jlt_section *self, jlt_return *row, const double *x, int time_direction)
{
    const jlt_chart *chart = self->flow.chart;
    const jlt_status st = jlt_orbit_start(self->orbit, 0, x, time_direction);
    double f[JLT_CHART_STATES_MAX];

    if (st != JLT_OK) return st;
    self->number = 0;
    self->t_start = 0;
    self->accepted = false;
    self->time_direction = time_direction;
    self->contact = arrive(self, x, f);
    if (row != NULL) {
        fill(row, self, 0, x, x[chart->column] == chart->level);
        if (self->event_count == 2 && !(self->contact > 0)) row->fate = JLT_FATE_LOST_CONTACT;
    }
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

/* The end of an orbit at rest. */
static void stay(jlt_section *self, jlt_return *row)
{
    self->number++;
    fill(row, self, self->t_start, self->x, false);
    row->fate = JLT_FATE_BUDGET;
}

jlt_status jlt_section_next(jlt_section *self, jlt_return *row)
{
    const jlt_chart *chart = self->flow.chart;
    double f[JLT_CHART_STATES_MAX];
    jlt_outcome outcome;
    jlt_status st;

    if (self->at_rest) {
        stay(self, row);
        return JLT_OK;
    }
    if (self->accepted) {
        self->accepted = false;
        st = jlt_orbit_start(self->orbit, self->t_start, self->x, self->time_direction);
        if (st != JLT_OK) return st;
    }
    st = jlt_orbit_next(self->orbit, self->t_start + self->time_direction * self->flow.t_max, self->events,
                        self->event_count, &outcome);
    if (st != JLT_OK && st != JLT_ERR_BUDGET) return st;
    self->number++;
    self->t_start = outcome.t;
    if (st == JLT_ERR_BUDGET || outcome.end == JLT_END_TIME) {
        fill(row, self, outcome.t, outcome.x, false);
        row->fate = JLT_FATE_BUDGET;
        return JLT_OK;
    }
    if (outcome.end == JLT_END_EVENT && outcome.crossing.event == 0) {
        fill(row, self, outcome.t, outcome.x, true);
        row->direction = outcome.crossing.direction;
        (void)arrive(self, outcome.x, f);
        return JLT_OK;
    }
    fill(row, self, outcome.t, outcome.x, false);
    if (outcome.end == JLT_END_EVENT) row->fate = JLT_FATE_LOST_CONTACT;
    else if (outcome.end == JLT_END_POLE)
        row->fate = chart->side == NULL || chart->side(chart, row->x) > 0 ? JLT_FATE_POLE_PLUS : JLT_FATE_POLE_MINUS;
    else row->interrupted = true;
    return JLT_OK;
}

void jlt_section_accept(jlt_section *self, jlt_return *row, double t, const double *x)
{
    const unsigned column = self->flow.chart->column;
    double f[JLT_CHART_STATES_MAX];

    if (self->at_rest) {
        stay(self, row);
        return;
    }
    self->number++;
    self->t_start = t;
    self->accepted = true;
    self->contact = fmin(self->contact, arrive(self, x, f));
    fill(row, self, t, x, true);
    row->direction = (f[column] > 0) - (f[column] < 0);
}

void jlt_section_cost(const jlt_section *self, size_t *steps, size_t *evaluations)
{
    const jlt_stepper *stepper = jlt_orbit_stepper(self->orbit);

    *steps = stepper->steps + stepper->rejected;
    *evaluations = stepper->evaluations;
}
