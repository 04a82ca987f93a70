#include "dynamics/drift.h"

#include <math.h>

#include "core/memory.h"

void jlt_drift_begin(jlt_drift *self, jlt_drift_end *end)
{
    *end = (jlt_drift_end){ .t = 0 };
    self->row = (jlt_drift_row){ .returns = 0 };
    self->last_due = 0;
    self->stopped = false;
}

jlt_status jlt_drift_note(jlt_drift *self, size_t returns, double t, size_t evaluations, const double *now)
{
    const bool due = (returns & (returns - 1)) == 0 || returns == self->returns;

    self->row.returns = returns;
    self->row.t = t;
    self->row.evaluations = evaluations;
    for (unsigned k = 0; k < self->count; k++) {
        const double drift = fabs(now[self->watched[k]] - self->first[k]) / self->sizes[k];
        if (!isfinite(drift)) return JLT_ERR_NONFINITE;
        self->row.drift[k] = fmax(self->row.drift[k], drift);
    }
    if (due) self->last_due = returns;
    self->stopped = !self->tell(self->context, &self->row, due);
    return JLT_OK;
}

void jlt_drift_finish(jlt_drift *self, const jlt_drift_end *end)
{
    if (end->name[0] != '\0' && self->row.returns > self->last_due) (void)self->tell(self->context, &self->row, true);
}

double jlt_drift_slope(const jlt_drift_row *rows, size_t count, unsigned k)
{
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;

    for (size_t i = 0; i < count; i++) {
        if (!(rows[i].drift[k] > 0) || rows[i].returns * 16 < rows[count - 1].returns) continue;
        const double u = log((double)rows[i].returns), v = log(rows[i].drift[k]);
        n++, x += u, y += v, xx += u * u, xy += u * v;
    }
    return n < 3 ? NAN : (n * xy - x * y) / (n * xx - x * x);
}

/* Set the watched integrals at the start, and their sizes: |F|, or 1 where that is 0 or no more than rounding of its terms. */
jlt_status jlt_drift_first(jlt_drift *self, const jlt_instance *instance, const double *x)
{
    static const double rounding = 1e-14; /* of some forty terms, half a unit in the last place each */
    const jlt_descriptor *d = instance->descriptor;
    const unsigned states = d->state_count;
    JLT_FREED double *values = malloc(d->integral_count * (1 + (size_t)states) * sizeof *values);

    if (values == NULL) return JLT_ERR_NOMEM;
    double *const gradients = values + d->integral_count;
    d->integral_values.call(x, instance->prepared, values);
    d->integral_gradients.call(x, instance->prepared, gradients);
    for (unsigned k = 0; k < self->count; k++) {
        const unsigned i = self->watched[k];
        double terms = 0;
        for (unsigned j = 0; j < states; j++) terms += fabs(gradients[i * states + j] * x[j]);
        self->first[k] = values[i];
        self->sizes[k] = fabs(values[i]) > rounding * terms ? fabs(values[i]) : 1;
    }
    return JLT_OK;
}

jlt_status jlt_drift_turns(bool *turns, const jlt_system *system, const double *q, unsigned integral)
{
    static const double same = 1e-9; /* relative to the size of the integral's terms; rounding is far below */
    const jlt_descriptor *d = system->instance->descriptor;
    const jlt_chart *chart = system->flow.chart;
    const unsigned n = d->state_count, c = chart->column;
    JLT_FREED double *values = malloc(d->integral_count * (2 + (size_t)n) * sizeof *values);
    double *turned = values + d->integral_count, *gradients = turned + d->integral_count;
    double x[JLT_CHART_STATES_MAX], size;

    *turns = false;
    if (values == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(chart->lift(chart, x, NULL, q));
    d->integral_values.call(x, system->field.p, values);
    x[c] += chart->turn;
    d->integral_values.call(x, system->field.p, turned);
    d->integral_gradients.call(x, system->field.p, gradients);
    size = fabs(values[integral]);
    for (unsigned j = 0; j < n; j++) size += fabs(gradients[integral * n + j] * x[j]);
    *turns = fabs(turned[integral] - values[integral]) > same * size;
    return JLT_OK;
}

jlt_status jlt_drift_section(jlt_drift *self, jlt_drift_end *end, const jlt_method *method)
{
    const jlt_descriptor *d = self->system->instance->descriptor;
    const jlt_kernel_function integrals = d->integral_values.call;
    const double *prepared = self->system->told->prepared;
    JLT_FREED double *now = malloc(d->integral_count * sizeof *now);
    jlt_flow flow = self->system->flow;
    JLT_OWNED(jlt_section) *section = NULL;
    jlt_return at;

    jlt_drift_begin(self, end);
    flow.method = method;
    if (now == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(jlt_section_create(&section, &flow));
    JLT_PASS(jlt_section_start(section, &at, self->q, 1));
    JLT_PASS(jlt_drift_first(self, self->system->told, at.x));
    for (size_t i = 1, steps, evaluations; i <= self->returns && !self->stopped; i++) {
        JLT_PASS(jlt_section_next(section, &at));
        if (at.interrupted) break;
        if (jlt_section_failed(at.fate)) return jlt_section_fate_status(at.fate);
        if (at.fate != JLT_FATE_ALIVE) {
            jlt_section_fate_text(end->name, self->system->observed, at.fate, at.lost);
            end->t = at.t;
            end->returns = i - 1;
            break;
        }
        integrals(at.x, prepared, now);
        jlt_section_cost(section, &steps, &evaluations);
        JLT_PASS(jlt_drift_note(self, i, at.t, evaluations, now));
    }
    jlt_drift_finish(self, end);
    return JLT_OK;
}
