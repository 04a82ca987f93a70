#include "dynamics/chart.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "kernel/region.h"

double jlt_chart_reduce(double value, double period)
{
    double reduced;

    if (period == 0) return value;
    reduced = remainder(value, period);
    return reduced == -period / 2 ? period / 2 : reduced;
}

static jlt_status plane_lift(const jlt_chart *self, double *x, double *tangent, const double *q)
{
    unsigned i, k;

    for (k = 0; k < self->dim; k++)
        if (!isfinite(q[k])) return JLT_ERR_NONFINITE;
    if (tangent != NULL) memset(tangent, 0, sizeof *tangent * self->states * self->dim);
    for (i = 0, k = 0; i < self->states; i++) {
        if (i == self->column) {
            x[i] = self->level;
            continue;
        }
        x[i] = q[k];
        if (tangent != NULL) tangent[i * self->dim + k] = 1;
        k++;
    }
    return jlt_chart_holds(self, x) ? JLT_OK : JLT_ERR_DOMAIN;
}

static void plane_lower(const jlt_chart *self, double *q, double *slope, const double *x)
{
    unsigned i, k;

    if (slope != NULL) memset(slope, 0, sizeof *slope * self->states * self->dim);
    for (i = 0, k = 0; i < self->states; i++) {
        if (i == self->column) continue;
        q[k] = jlt_chart_reduce(x[i], self->period[k]);
        if (slope != NULL) slope[k * self->states + i] = 1;
        k++;
    }
}

static double plane_flux(const jlt_chart *self, const double *x, const double *f)
{
    (void)x;
    return f[self->column];
}

int jlt_chart_pole_side(const jlt_chart *self, const jlt_descriptor *table, unsigned plain, double *x)
{
    unsigned state;
    const int side = jlt_descriptor_pole_side(&state, table, x);

    if (side != 0) x[state] = side > 0 ? table->states[state].high : table->states[state].low;
    for (unsigned i = plain; i < self->states; i++) x[i] = 0;
    return side;
}

jlt_status jlt_chart_plane(jlt_chart *out, unsigned states, unsigned column, double level, const char *const *names,
                           const int *signs)
{
    unsigned i, k;

    if (states < 2 || states > JLT_CHART_STATES_MAX || column >= states || !isfinite(level)) return JLT_ERR_ARG;
    for (i = 0; signs != NULL && i < states; i++)
        if (signs[i] != 1 && signs[i] != -1) return JLT_ERR_ARG;
    memset(out, 0, sizeof *out);
    out->dim = states - 1;
    out->states = states;
    out->column = column;
    out->level = level;
    out->turns_over = signs != NULL && signs[column] < 0;
    out->reversible = out->turns_over && jlt_chart_is_mirrored(out);
    for (i = 0, k = 0; i < states; i++) {
        if (i == column) continue;
        out->names[k] = names[i];
        out->mirror[k] = signs != NULL ? signs[i] : 1;
        k++;
    }
    if (out->dim == 1) out->names[1] = "";
    out->lift = plane_lift;
    out->lower = plane_lower;
    out->flux = plane_flux;
    return JLT_OK;
}

bool jlt_chart_is_mirrored(const jlt_chart *self)
{
    return fabs(jlt_chart_reduce(2 * self->level, self->turn)) <= 16 * DBL_EPSILON * fabs(self->level);
}

void jlt_chart_set_periods(jlt_chart *self, const double *periods)
{
    unsigned i, k;

    self->turn = periods[self->column];
    self->reversible = self->turns_over && jlt_chart_is_mirrored(self);
    for (i = 0, k = 0; i < self->states; i++)
        if (i != self->column) self->period[k++] = periods[i];
}

unsigned jlt_chart_events(const jlt_chart *self, jlt_event *events, jlt_direction direction)
{
    const unsigned count = self->turn != 0 ? JLT_CHART_EVENTS_MAX : 1;

    for (unsigned k = 0; k < count; k++) {
        const int turns = (int)k - (count > 1);
        events[k] = (jlt_event){ .column = self->column, .level = self->level + turns * self->turn,
                                 .direction = turns == 0 ? direction : JLT_BOTH };
    }
    return count;
}

bool jlt_chart_counts(const jlt_chart *self, const jlt_crossing *crossing, jlt_direction direction)
{
    return self->turn == 0 || direction == JLT_BOTH || crossing->direction == (int)direction;
}

void jlt_chart_turn_back(const jlt_chart *self, double *x)
{
    if (self->turn == 0) return;
    const double off = jlt_chart_reduce(x[self->column] - self->level, self->turn);
    /* An orbit on the section stays on it: where all states are small, rounding of turns is no small distance from it. */
    const bool is_on = fabs(off) <= 16 * DBL_EPSILON * (fabs(self->level) + fabs(self->turn));
    x[self->column] = is_on ? self->level : self->level + off;
}

bool jlt_chart_is_coordinate(const jlt_chart *self, unsigned state)
{
    for (unsigned i = 0; i < self->solved_count; i++)
        if (self->solved[i] == state) return false;
    return state != self->column && state < self->states - self->roots;
}

void jlt_chart_wrap_state(const jlt_chart *self, double *x)
{
    jlt_chart_turn_back(self, x);
    for (unsigned i = 0, k = 0; i < self->states; i++)
        if (jlt_chart_is_coordinate(self, i)) x[i] = jlt_chart_reduce(x[i], self->period[k++]);
}

bool jlt_chart_follows(const jlt_chart *self, const double *x) { return self->follows == NULL || self->follows(self, x); }

bool jlt_chart_holds(const jlt_chart *self, const double *x)
{
    for (unsigned i = 0; self->bounds != NULL && i < self->states; i++)
        if (!(x[i] > self->bounds[i].low && x[i] < self->bounds[i].high)) return false;
    return self->domain == NULL || jlt_region_holds(self->domain->conditions, self->domain->values, self->domain->p, x);
}

void jlt_chart_difference(const jlt_chart *self, double *out, const double *q, const double *p)
{
    for (unsigned k = 0; k < self->dim; k++) out[k] = jlt_chart_reduce(q[k] - p[k], self->period[k]);
}

void jlt_chart_wrap(const jlt_chart *self, double *q)
{
    for (unsigned k = 0; k < self->dim; k++) q[k] = jlt_chart_reduce(q[k], self->period[k]);
}

void jlt_chart_scaled(const jlt_chart *self, double *out, const double *q)
{
    for (unsigned k = 0; k < self->dim; k++) out[k] = ldexp(q[k], -self->scale[k]);
}

void jlt_chart_unscaled(const jlt_chart *self, double *out, const double *q)
{
    for (unsigned k = 0; k < self->dim; k++) out[k] = ldexp(q[k], self->scale[k]);
}

void jlt_chart_scaled_slope(const jlt_chart *self, double *out, const double *slope)
{
    for (unsigned i = 0; i < self->dim; i++)
        for (unsigned j = 0; j < self->dim; j++)
            out[i * self->dim + j] = ldexp(slope[i * self->dim + j], self->scale[j] - self->scale[i]);
}

double jlt_chart_speed(const jlt_chart *self, const double *x, const double *f)
{
    double q[JLT_CHART_DIM_MAX], slope[JLT_CHART_DIM_MAX * JLT_CHART_STATES_MAX];
    const double across = ldexp(f[self->column], -self->column_scale);
    double sum = across * across;

    self->lower(self, q, slope, x);
    for (unsigned k = 0; k < self->dim; k++) {
        double rate = 0;
        for (unsigned i = 0; i < self->states; i++) rate += slope[k * self->states + i] * f[i];
        rate = ldexp(rate, -self->scale[k]);
        sum += rate * rate;
    }
    return sqrt(sum);
}

double jlt_chart_distance(const jlt_chart *self, const double *q, const double *p)
{
    double difference[JLT_CHART_DIM_MAX], sum = 0;

    jlt_chart_difference(self, difference, q, p);
    jlt_chart_scaled(self, difference, difference);
    for (unsigned k = 0; k < self->dim; k++) sum += difference[k] * difference[k];
    return sqrt(sum);
}

void jlt_chart_mirror(const jlt_chart *self, double *out, const double *q)
{
    for (unsigned k = 0; k < self->dim; k++) out[k] = self->mirror[k] * q[k];
    jlt_chart_wrap(self, out);
}
