#include "dynamics/surface_crossing.h"

#include <math.h>
#include <string.h>

enum { ANGLES = 4, LOOKS = 64 };

/* The integrals whose levels the section fixes, at x, shape (level_count,); slopes: their derivatives by a state. */
static void integrals_at(const jlt_system *self, double *values, double *slopes, unsigned state, const double *x)
{
    const jlt_descriptor *d = self->instance->descriptor;
    const jlt_section_chart *section = self->surface->section;
    double all[JLT_CHART_INTEGRALS_MAX], gradients[JLT_CHART_INTEGRALS_MAX * JLT_CHART_STATES_MAX];

    if (section->level_count == 0) return;
    d->integral_values.call(x, self->field.p, all);
    d->integral_gradients.call(x, self->field.p, gradients);
    for (unsigned k = 0; k < section->level_count; k++) {
        const char *name = self->surface->table->integrals[section->integrals[k]].name;
        unsigned i = 0;
        while (i + 1 < d->integral_count && strcmp(d->integrals[i].name, name) != 0) i++;
        values[k] = all[i];
        slopes[k] = gradients[i * d->state_count + state];
    }
}

/* Whether x with another value of one state lies over the same point, on the same levels, and is crossed in the flow's
 * direction. */
static bool is_over(const jlt_system *self, const double *x, const double *q, unsigned state, double value)
{
    static const double same = 1e-9;
    double other[JLT_CHART_STATES_MAX], f[JLT_CHART_STATES_MAX], back[JLT_CHART_COORDINATES_MAX], slopes[JLT_CHART_INTEGRALS_MAX];
    double here[JLT_CHART_INTEGRALS_MAX], there[JLT_CHART_INTEGRALS_MAX];

    memcpy(other, x, self->field.dim * sizeof *x);
    other[state] = value;
    if (!(fabs(value - x[state]) > same * fmax(1, fabs(x[state])))) return false;
    self->flow.chart->lower(self->flow.chart, back, NULL, other);
    integrals_at(self, here, slopes, state, x);
    integrals_at(self, there, slopes, state, other);
    for (unsigned k = 0; k < self->surface->section->level_count; k++)
        if (!(fabs(there[k] - here[k]) <= same * fmax(1, fabs(here[k])))) return false;
    if (!(jlt_chart_distance(self->flow.chart, back, q) <= same)) return false;
    self->field.call(other, self->field.p, f);
    const double rate = f[self->flow.chart->column];
    return self->flow.direction == JLT_BOTH ? fabs(rate) > 0 : self->flow.direction == JLT_RISING ? rate > 0 : rate < 0;
}

/* Whether the flow crosses another state over the same point on the same levels, which differs in one state alone: in its sign, or
 * by the other root of an integral that is quadratic in it. The lift took one of the two. */
static bool has_other_root(const jlt_system *self, const double *x, const double *q, unsigned state)
{
    double beyond[JLT_CHART_STATES_MAX], values[JLT_CHART_INTEGRALS_MAX], slopes[JLT_CHART_INTEGRALS_MAX],
        farther[JLT_CHART_INTEGRALS_MAX];
    bool found = is_over(self, x, q, state, -x[state]);

    memcpy(beyond, x, self->field.dim * sizeof *x);
    beyond[state] += 1;
    integrals_at(self, values, slopes, state, x);
    integrals_at(self, values, farther, state, beyond);
    for (unsigned k = 0; k < self->surface->section->level_count && !found; k++)
        found = is_over(self, x, q, state, x[state] - 2 * slopes[k] / (farther[k] - slopes[k]));
    return found;
}

bool jlt_surface_crossing_met(const jlt_system *self, const jlt_chart_section *section)
{
    const jlt_chart *chart = self->flow.chart;
    const size_t all = jlt_chart_section_probes(section, ANGLES);
    unsigned seen = 0;

    if (self->instance->descriptor->integral_count > JLT_CHART_INTEGRALS_MAX) return true;
    for (size_t i = 0; i < all && seen < LOOKS; i++) {
        double q[JLT_CHART_COORDINATES_MAX], x[JLT_CHART_STATES_MAX];
        jlt_chart_section_probe(section, q, i, ANGLES);
        if (chart->lift(chart, x, NULL, q) != JLT_OK) continue;
        for (unsigned k = 0; k < section->plain; k++)
            if (k != chart->column && has_other_root(self, x, q, k)) return false;
        seen++;
    }
    return true;
}

bool jlt_surface_crossing_ends_at_poles(const jlt_system *self, const jlt_chart_section *section)
{
    const jlt_chart *chart = self->flow.chart;
    const size_t all = jlt_chart_section_probes(section, ANGLES);

    if (section->plain == chart->states) return true;
    if (chart->side == NULL) return false;
    for (size_t i = 0; i < all; i++) {
        double q[JLT_CHART_COORDINATES_MAX], x[JLT_CHART_STATES_MAX], f[JLT_CHART_STATES_MAX];
        jlt_chart_section_probe(section, q, i, ANGLES);
        if (chart->lift(chart, x, NULL, q) != JLT_OK) continue;
        for (unsigned k = 0; k < section->plain; k++)
            if (x[k] == 0) x[k] = 1; /* any state will do, but the rate may vanish where one is 0 */
        /* Poles lie where the table says, in its units. */
        for (unsigned k = 0; k < chart->states; k++) x[k] = ldexp(x[k], self->flow.units.state[k]);
        (void)chart->side(chart, x);
        for (unsigned k = 0; k < chart->states; k++) x[k] = ldexp(x[k], -self->flow.units.state[k]);
        self->field.call(x, self->field.p, f);
        for (unsigned k = section->plain; k < chart->states; k++)
            if (fabs(f[k]) > 0) return false;
        return true;
    }
    return true;
}
