#include "dynamics/chart_counted.h"

#include <math.h>

static const jlt_chart_counted *of(const jlt_chart *base) { return (const jlt_chart_counted *)(const void *)base; }

static void restore(double *out, const jlt_chart_counted *self, const double *x)
{
    for (unsigned i = 0; i < self->base.states; i++) out[i] = ldexp(x[i], self->unit[i]);
}

static jlt_status lift(const jlt_chart *base, double *x, double *tangent, const double *q)
{
    const jlt_chart_counted *self = of(base);
    const jlt_status st = self->told->lift(self->told, x, tangent, q);

    for (unsigned i = 0; st == JLT_OK && i < base->states; i++) {
        x[i] = ldexp(x[i], -self->unit[i]);
        for (unsigned k = 0; tangent != NULL && k < base->dim; k++)
            tangent[i * base->dim + k] = ldexp(tangent[i * base->dim + k], -self->unit[i]);
    }
    return st;
}

static void lower(const jlt_chart *base, double *q, double *slope, const double *x)
{
    const jlt_chart_counted *self = of(base);
    double told[JLT_CHART_STATES_MAX];

    restore(told, self, x);
    self->told->lower(self->told, q, slope, told);
    for (unsigned k = 0; slope != NULL && k < base->dim; k++)
        for (unsigned i = 0; i < base->states; i++)
            slope[k * base->states + i] = ldexp(slope[k * base->states + i], self->unit[i]);
}

static double flux(const jlt_chart *base, const double *x, const double *f)
{
    const jlt_chart_counted *self = of(base);
    double told[JLT_CHART_STATES_MAX], rate[JLT_CHART_STATES_MAX];

    restore(told, self, x);
    restore(rate, self, f);
    return self->told->flux(self->told, told, rate);
}

static int side(const jlt_chart *base, double *x) { return of(base)->told->side(of(base)->told, x); }

static bool follows(const jlt_chart *base, const double *x) { return of(base)->told->follows(of(base)->told, x); }

void jlt_chart_counted_init(jlt_chart_counted *out, const jlt_chart *told, const int *unit, const int *coordinate)
{
    *out = (jlt_chart_counted){ .base = *told, .told = told };
    out->base.bounds = NULL;
    out->base.domain = NULL;
    out->base.level = ldexp(told->level, -unit[told->column]);
    out->base.turn = ldexp(told->turn, -unit[told->column]);
    for (unsigned i = 0; i < told->states; i++) out->unit[i] = unit[i];
    for (unsigned k = 0; k < told->dim; k++) out->base.scale[k] = out->base.unit[k] = coordinate[k];
    out->base.lift = lift;
    out->base.lower = lower;
    out->base.flux = flux;
    out->base.side = told->side != NULL ? side : NULL;
    out->base.follows = told->follows != NULL ? follows : NULL;
}
