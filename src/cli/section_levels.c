#include "cli/section_levels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dynamics/drift.h"
#include "kernel/descriptor.h"

static const double ordinary = 1000; /* steps of a return, each with an error of one tolerance on the same side */
static const double rounding = 1e-15;

static double tolerance_of(const jlt_section_levels *self)
{
    return self->system->flow.tolerance != 0 ? self->system->flow.tolerance : JLT_ORBIT_TOLERANCE;
}

jlt_status jlt_section_levels_open(jlt_section_levels *out, const jlt_system *system, const double *q)
{
    const jlt_descriptor *d = system->instance->descriptor;
    jlt_section_levels self = { .system = system };
    bool turns = false;

    for (unsigned i = 0; i < d->integral_count && self.count < JLT_INVARIANTS_MAX; i++) {
        if (!jlt_descriptor_proves(d, "integral", d->integrals[i].name)) continue;
        if (system->flow.chart->turn != 0) JLT_PASS(jlt_drift_turns(&turns, system, q, i));
        if (!turns) self.watched[self.count++] = i;
    }
    self.now = malloc((1 + d->integral_count) * (3 + (size_t)d->state_count) * sizeof *self.now);
    if (self.now == NULL) return JLT_ERR_NOMEM;
    self.first.values = self.now + d->integral_count;
    self.last.values = self.first.values + d->integral_count;
    self.gradients = self.last.values + d->integral_count;
    *out = self;
    return JLT_OK;
}

void jlt_section_levels_close(jlt_section_levels *self) { free(self->now); }

/* An error of one tolerance in every state at x changes integral i by the tolerance times this; value: of the integral there. */
static double terms(const jlt_section_levels *self, const double *x, unsigned i, double value)
{
    const jlt_descriptor *d = self->system->instance->descriptor;
    const jlt_flow *flow = &self->system->flow;
    double sum = fabs(value);

    d->integral_gradients.call(x, self->system->told->prepared, self->gradients);
    for (unsigned j = 0; j < d->state_count; j++) {
        const double small = ldexp(jlt_field_small(flow->field, j, self->size), flow->units.state[j]);
        sum += fabs(self->gradients[i * d->state_count + j]) * fmax(fabs(x[j]), small);
    }
    return sum;
}

static double size_of(const jlt_flow *flow, const double *start)
{
    double counted[JLT_CHART_STATES_MAX];

    for (unsigned k = 0; k < flow->chart->states; k++) counted[k] = ldexp(start[k], -flow->units.state[k]);
    return jlt_field_size_at(flow->field, counted);
}

/* Whether integrals have values at this row, with the errors of ordinary returns: not at a pole, where many integrals have no
 * value, nor where steps were many or the method failed. */
static bool can_be_told(const jlt_return *at)
{
    return at->fate == JLT_FATE_ALIVE || at->fate == JLT_FATE_INVALID || at->fate == JLT_FATE_LEFT_DOMAIN;
}

/* Whether a watched integral has changed since `row` by more than errors explain. */
static bool changes_since(jlt_section_levels *self, const jlt_section_levels_row *row, size_t orbit, const jlt_return *at)
{
    const jlt_chart *chart = self->system->flow.chart;
    const double returns = (double)(at->number - row->number), error = fmax(tolerance_of(self), rounding) * returns;
    bool changes = false;

    for (unsigned k = 0; k < self->count; k++) {
        const unsigned i = self->watched[k];
        const double change = fabs(self->now[i] - row->values[i]);
        if (!(change > ordinary * error * fabs(self->now[i]))) continue; /* without gradients, for speed */
        const double all = fmax(terms(self, at->x, i, self->now[i]), terms(self, row->x, i, row->values[i]));
        if (!(change > ordinary * error * all)) continue;
        changes = true;
        if (!(change > self->worst.share * error * all)) continue;
        self->worst.share = change / (error * all);
        self->worst.change = change;
        self->worst.integral = i;
        self->worst.orbit = orbit;
        self->worst.number = at->number;
        self->worst.returns = at->number - row->number;
        memcpy(self->worst.from, row->x, chart->states * sizeof *row->x);
        memcpy(self->worst.to, at->q, chart->dim * sizeof *at->q);
    }
    return changes;
}

static void keep(jlt_section_levels_row *row, const jlt_section_levels *self, const jlt_return *at)
{
    memcpy(row->values, self->now, self->system->instance->descriptor->integral_count * sizeof *self->now);
    memcpy(row->x, at->x, self->system->flow.chart->states * sizeof *at->x);
    row->number = at->number;
}

bool jlt_section_levels_note(jlt_section_levels *self, size_t orbit, const jlt_return *at)
{
    bool changes = false;

    if (self->count == 0 || !can_be_told(at)) return false;
    self->system->instance->descriptor->integral_values.call(at->x, self->system->told->prepared, self->now);
    if (at->number == 0) {
        self->size = size_of(&self->system->flow, at->x);
        keep(&self->first, self, at);
    } else {
        changes = changes_since(self, &self->last, orbit, at);
        /* Returns that lie close to the singularity tell nothing of each other. */
        if (self->last.number > 0) changes |= changes_since(self, &self->first, orbit, at);
    }
    keep(&self->last, self, at);
    return changes;
}

/* Make the worst return again, from the row that it was compared with, at a tolerance. Out: *coordinate, the one that differs
 * most. Returns by how much; NaN: there is no return. */
static double differs(unsigned *coordinate, const jlt_section_levels *self, double tolerance, int time_direction)
{
    const jlt_chart *chart = self->system->flow.chart;
    jlt_flow flow = self->system->flow;
    JLT_OWNED(jlt_section) *section = NULL;
    double difference[JLT_CHART_DIM_MAX];
    jlt_return at;

    *coordinate = 0;
    flow.tolerance = tolerance;
    if (jlt_section_create(&section, &flow) != JLT_OK ||
        jlt_section_start_state(section, &at, self->worst.from, time_direction) != JLT_OK) return NAN;
    while (at.number < self->worst.returns)
        if (jlt_section_next(section, &at) != JLT_OK || at.fate != JLT_FATE_ALIVE || at.interrupted) return NAN;
    jlt_chart_difference(chart, difference, at.q, self->worst.to);
    for (unsigned k = 1; k < chart->dim; k++)
        if (fabs(difference[k]) > fabs(difference[*coordinate])) *coordinate = k;
    return fabs(difference[*coordinate]);
}

void jlt_section_levels_tell(const jlt_section_levels *self, int time_direction)
{
    unsigned k;

    if (!(self->worst.share > 0)) return; /* also where no orbit was begun, and nothing opened */
    const double tolerance = tolerance_of(self), other = tolerance > rounding ? tolerance / 10 : 10 * tolerance;
    fprintf(stderr, "jellett: on its way to return %zu orbit %zu changes %s by %.2g, as errors of %.2g tolerances in every state "
            "%swould (a pass close to a singularity?)", self->worst.number, self->worst.orbit,
            self->system->instance->descriptor->integrals[self->worst.integral].name, self->worst.change, self->worst.share,
            self->worst.returns > 1 ? "and return " : "");
    const double difference = differs(&k, self, other, time_direction);
    if (difference > 0)
        fprintf(stderr, "; with --tol %.2g this return differs by %.2g in %s", other, difference,
                self->system->flow.chart->names[k]);
    fputc('\n', stderr);
}
