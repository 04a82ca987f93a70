#include "dynamics/map_return.h"

#include <math.h>

#include "core/guard.h"
#include "dynamics/linear.h"
#include "integrate/rest.h"

jlt_status jlt_map_return_start(double *varied, double *flux, const jlt_flow *flow, const double *q, int time_direction)
{
    const jlt_chart *chart = flow->chart;
    const unsigned n = chart->states, d = chart->dim;
    double tangent[JLT_CHART_STATES_MAX * JLT_CHART_DIM_MAX], f[JLT_CHART_STATES_MAX];

    JLT_PASS(chart->lift(chart, varied, tangent, q));
    for (unsigned k = 0; k < d; k++)
        for (unsigned i = 0; i < n; i++) varied[n * (1 + k) + i] = ldexp(tangent[i * d + k], chart->unit[k]);
    varied[n * (1 + d)] = 0;
    if (jlt_rest_is_still(flow->field, varied, time_direction)) return JLT_ERR_DOMAIN;
    flow->field->call(varied, flow->field->p, f);
    *flux = chart->flux(chart, varied, f);
    return JLT_OK;
}

static void project(const jlt_chart *chart, double *slope, double *q, const double *end, const double *f)
{
    const unsigned n = chart->states, d = chart->dim, c = chart->column;
    double lowering[JLT_CHART_DIM_MAX * JLT_CHART_STATES_MAX];

    chart->lower(chart, q, lowering, end);
    for (unsigned k = 0; k < d; k++) {
        const double *y = end + n * (1 + k);
        for (unsigned i = 0; i < d; i++) {
            double sum = 0;
            for (unsigned j = 0; j < n; j++)
                if (j != c) sum += lowering[i * n + j] * (y[j] - f[j] / f[c] * y[c]);
            slope[i * d + k] = ldexp(sum, -chart->unit[i]);
        }
    }
}

/* Product of the rows' lengths: Hadamard's bound on the determinant, to which its rounding errors are relative. */
static double hadamard(const double *slope, unsigned d)
{
    double product = 1;
    for (unsigned i = 0; i < d; i++) product *= jlt_linear_length(slope + i * d, d);
    return product;
}

jlt_status jlt_map_return_end(jlt_map_return *out, double *q, double *slope, const jlt_flow *flow, const double *varied,
                              double flux)
{
    const jlt_chart *chart = flow->chart;
    const unsigned n = chart->states, d = chart->dim;
    double told[JLT_CHART_STATES_MAX];

    flow->field->call(varied, flow->field->p, out->f);
    const double after = chart->flux(chart, varied, out->f);
    project(chart, slope, q, varied, out->f);
    if (!jlt_guard_finite(slope, d * d)) return JLT_ERR_NONFINITE;
    for (unsigned i = 0; i < n; i++) told[i] = ldexp(varied[i], flow->units.state[i]);
    if (!jlt_chart_follows(chart, told)) return JLT_ERR_NO_CONVERGENCE;
    out->determinant = jlt_linear_determinant(slope, d);
    out->size = hadamard(slope, d);
    /* A crossing in the other direction reverses the sign of the flux; volume is counted positive. */
    out->flux_determinant = fabs(flux / after) * exp(varied[n * (1 + d)]);
    return isfinite(out->flux_determinant) ? JLT_OK : JLT_ERR_NONFINITE; /* infinite where the coordinates fold */
}

/* Every step errs by one tolerance in every component, relative to its size or that of the start; errors grow as tangent vectors
 * do, at most by the ratio of the largest to the smallest of these. The rate f_c across the section, on which flux and return time
 * depend, errs by its gradient times the states' errors, a large part of f_c on a slow crossing; along the flow, tangent vectors
 * then err by f/f_c times as much. */
double jlt_map_return_bound(const jlt_map_return *self, const jlt_map_return_steps *steps, const jlt_flow *flow,
                            const double *varied, const double *slope)
{
    const jlt_chart *chart = flow->chart;
    const unsigned n = chart->states, d = chart->dim, c = chart->column;
    const double across = fabs(self->f[c]), size = self->size > 0 ? self->size : 1;
    const double part = fmax(fabs(self->determinant), self->flux_determinant) / size;
    double q[JLT_CHART_DIM_MAX], lowering[JLT_CHART_DIM_MAX * JLT_CHART_STATES_MAX], fastest = 0, aside = 0, all = 1;

    chart->lower(chart, q, lowering, varied);
    for (unsigned i = 0; i < n; i++) fastest = fmax(fastest, fabs(self->f[i]));
    for (unsigned k = 0; k < d; k++) aside = fmax(aside, fabs(varied[n * (1 + k) + c]));
    const double rate = steps->error * steps->growth * steps->gradient / across, lean = fastest / across;
    const double tangent = steps->error * steps->growth * (1 + lean) + aside * lean * rate;
    for (unsigned i = 0; i < d; i++) {
        const double length = jlt_linear_length(slope + i * d, d);
        double largest = 0;
        if (!(length > 0)) return INFINITY;
        for (unsigned j = 0; j < n; j++) largest = fmax(largest, fabs(lowering[i * n + j]));
        all *= 1 + ldexp(largest, -chart->unit[i]) * tangent / length;
    }
    return (all - 1) + part * (steps->error * steps->swing + rate);
}

void jlt_map_return_restore(double *slope, const jlt_chart *chart)
{
    for (unsigned i = 0; i < chart->dim; i++)
        for (unsigned k = 0; k < chart->dim; k++)
            slope[i * chart->dim + k] = ldexp(slope[i * chart->dim + k], chart->unit[i] - chart->unit[k]);
}
