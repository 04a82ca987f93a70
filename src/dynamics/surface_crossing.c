#include "dynamics/surface_crossing.h"

#include <math.h>
#include <string.h>

enum { ANGLES = 4, LOOKS = 64, INTEGRALS = JLT_CHART_INTEGRALS_MAX, STATES = JLT_CHART_STATES_MAX };

/* A point of the section, and all integrals of the field there. */
typedef struct {
    const jlt_system *system;
    unsigned fixed[INTEGRALS]; /* the integrals whose levels the section fixes, shape (level_count,) */
    double q[JLT_CHART_COORDINATES_MAX], x[STATES], values[INTEGRALS], gradients[INTEGRALS * STATES];
    double size; /* jlt_field_size_at x */
} look;

static void find_fixed(look *self)
{
    const jlt_descriptor *d = self->system->instance->descriptor;
    const jlt_surface *surface = self->system->surface;

    for (unsigned k = 0; k < surface->section->level_count; k++) {
        const char *name = surface->table->integrals[surface->section->integrals[k]].name;
        unsigned i = 0;
        while (i + 1 < d->integral_count && strcmp(d->integrals[i].name, name) != 0) i++;
        self->fixed[k] = i;
    }
}

/* The size of the terms of the integral whose level the section fixes as number k. */
static double size_of_level(const look *self, unsigned k)
{
    const unsigned n = self->system->instance->descriptor->state_count;
    const double *gradient = self->gradients + self->fixed[k] * n;
    double size = fabs(self->values[self->fixed[k]]);

    for (unsigned i = 0; i < n; i++) size = fmax(size, fabs(gradient[i] * self->x[i]));
    return size;
}

static double size_of_state(const look *self, unsigned state)
{
    return fmax(self->size, fabs(self->x[state]));
}

/* Whether x with another value of one state lies over the same point, on the same levels, and is crossed in the flow's
 * direction. */
static bool is_over(const look *self, unsigned state, double value)
{
    static const double same = 1e-9;
    const jlt_system *system = self->system;
    const unsigned levels = system->surface->section->level_count;
    double other[STATES], f[STATES], back[JLT_CHART_COORDINATES_MAX], there[INTEGRALS];

    if (!(fabs(value - self->x[state]) > same * size_of_state(self, state))) return false;
    memcpy(other, self->x, system->field.dim * sizeof *other);
    other[state] = value;
    if (levels > 0) system->instance->descriptor->integral_values.call(other, system->field.p, there);
    for (unsigned k = 0; k < levels; k++)
        if (!(fabs(there[self->fixed[k]] - self->values[self->fixed[k]]) <= same * size_of_level(self, k))) return false;
    system->flow.chart->lower(system->flow.chart, back, NULL, other);
    if (!(jlt_chart_distance(system->flow.chart, back, self->q) <= same)) return false;
    system->field.call(other, system->field.p, f);
    const double rate = f[system->flow.chart->column];
    return system->flow.direction == JLT_BOTH ? fabs(rate) > 0 : system->flow.direction == JLT_RISING ? rate > 0 : rate < 0;
}

/* Whether the flow crosses another state over the same point on the same levels, which differs in one state alone: in its sign, or
 * by the other root of an integral that is quadratic in it. The lift took one of the two. */
static bool has_other_root(const look *self, unsigned state)
{
    const jlt_descriptor *d = self->system->instance->descriptor;
    const unsigned levels = self->system->surface->section->level_count;
    const double step = size_of_state(self, state);
    double beyond[STATES], farther[INTEGRALS * STATES];
    bool found = is_over(self, state, -self->x[state]);

    if (found || levels == 0) return found;
    memcpy(beyond, self->x, self->system->field.dim * sizeof *beyond);
    beyond[state] += step;
    d->integral_gradients.call(beyond, self->system->field.p, farther);
    for (unsigned k = 0; k < levels && !found; k++) {
        const unsigned at = self->fixed[k] * d->state_count + state;
        found = is_over(self, state, self->x[state] - 2 * step * self->gradients[at] / (farther[at] - self->gradients[at]));
    }
    return found;
}

/* The rate of the section's state at the lift of q; NaN: there is none. */
static double rate_at(const jlt_system *system, const double *q)
{
    const jlt_chart *chart = system->flow.chart;
    double x[STATES], f[STATES];

    if (chart->lift(chart, x, NULL, q) != JLT_OK) return NAN;
    system->field.call(x, system->field.p, f);
    return f[chart->column];
}

/* Whether an orbit comes back to a state that crosses the section the other way than the lift of its coordinates, another state.
 * None does where every lift is crossed in the flow's direction. */
static jlt_status find_stray(bool *found, const jlt_system *system, const jlt_chart_section *section)
{
    enum { ORBITS = 4, STEPS = 1000 };
    static const double same = 1e-9; /* of the rate at the start: less may be rounding */
    JLT_OWNED(jlt_section) *orbit = NULL;
    const size_t all = jlt_chart_section_probes(section, ANGLES);
    jlt_flow flow = system->flow;
    jlt_return row;
    unsigned followed = 0;

    flow.max_steps = STEPS;
    flow.observed = NULL;
    JLT_PASS(jlt_section_create(&orbit, &flow));
    *found = false;
    for (size_t i = 0; i < all && followed < ORBITS && !*found; i++) {
        double q[JLT_CHART_COORDINATES_MAX];
        jlt_chart_section_probe(section, q, i, ANGLES);
        const double rate = rate_at(system, q);
        if (!(flow.direction == JLT_BOTH ? fabs(rate) > 0 : (int)flow.direction * rate < 0)) continue;
        followed++;
        if (jlt_section_start(orbit, &row, q, 1) != JLT_OK) continue;
        JLT_PASS(jlt_section_next(orbit, &row));
        *found = row.fate == JLT_FATE_ALIVE && rate_at(system, row.q) * row.direction < -same * fabs(rate);
    }
    return JLT_OK;
}

jlt_status jlt_surface_crossing_met(const jlt_system *self, const jlt_chart_section *section)
{
    const jlt_descriptor *d = self->instance->descriptor;
    const jlt_chart *chart = self->flow.chart;
    const size_t all = jlt_chart_section_probes(section, ANGLES);
    look here;
    unsigned seen = 0;
    bool stray;

    if (d->integral_count > INTEGRALS) return JLT_OK;
    JLT_PASS(find_stray(&stray, self, section));
    if (stray) return JLT_ERR_ARG;
    here.system = self;
    find_fixed(&here);
    for (size_t i = 0; i < all && seen < LOOKS; i++) {
        jlt_chart_section_probe(section, here.q, i, ANGLES);
        if (chart->lift(chart, here.x, NULL, here.q) != JLT_OK) continue;
        here.size = jlt_field_size_at(&self->field, here.x);
        if (section->section->level_count > 0) {
            d->integral_values.call(here.x, self->field.p, here.values);
            d->integral_gradients.call(here.x, self->field.p, here.gradients);
        }
        for (unsigned k = 0; k < section->plain; k++)
            if (k != chart->column && has_other_root(&here, k)) return JLT_ERR_ARG;
        seen++;
    }
    return JLT_OK;
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
