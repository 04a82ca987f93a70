#include "dynamics/newton.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dynamics/linear.h"
#include "ext/eigen.h"
#include "integrate/stepper.h"

enum { D = JLT_CHART_DIM_MAX, ITERATIONS = 40, HALVINGS = 6 };

static const double longest_step = 0.5;    /* scaled */
static const double accepted = 1e-10;      /* largest residual of a converged orbit, relative to |DP| of one return, */
static const double accepted_most = 1e-9;  /* absolute, */
static const double fallen = 1e-6;         /* and relative to the first one, unless errors of the map may cause it */
static const double null_cutoff = 1e-11;   /* singular values of I - DP below this, relative to I or to I - DP if that is larger,
                                              count as 0: the orbit belongs to a family. But none above this: */
static const double contracting = 1e-2;    /* in a direction that contracts, I - DP is about 1, */
static const double stretching = 1e6;      /* |I - DP| above which a small residual may leave a large step, */
static const double drowned = 1e14;        /* which rounding errors exceed where |I - DP| is above this */

/* With delta_(i+1) = A_i delta_i + r_i and delta_p = delta_0: (I - A_(p-1)..A_0) delta_0 = sum of the propagated r_i. */
static jlt_status step(double *delta, double *length, const jlt_shooting *at, unsigned d, size_t period, const unsigned char *held)
{
    double product[D * D] = { 0 }, carried[D] = { 0 }, system[D * D], free_delta[D];
    unsigned columns[D], count = 0, i, j;

    for (i = 0; i < d; i++) product[i * d + i] = 1;
    for (size_t k = 0; k < period; k++) {
        const double *slope = at->slopes + k * d * d;
        double next[D];
        for (i = 0; i < d; i++) {
            next[i] = at->miss[k * d + i];
            for (j = 0; j < d; j++) next[i] += slope[i * d + j] * carried[j];
        }
        memcpy(carried, next, d * sizeof *next);
        jlt_linear_multiply(product, slope, product, d);
    }
    for (j = 0; j < d; j++)
        if (held == NULL || !held[j]) columns[count++] = j;
    if (count == 0) return JLT_ERR_ARG;
    for (i = 0; i < d; i++)
        for (j = 0; j < count; j++) system[i * count + j] = (i == columns[j]) - product[i * d + columns[j]];
    *length = jlt_linear_length(system, d * count);
    JLT_PASS(jlt_eigen_least_squares(free_delta, system, carried, d, count,
                                     fmin(null_cutoff * fmax(1, *length), contracting) / *length));
    memset(delta, 0, d * sizeof *delta);
    for (j = 0; j < count; j++) delta[columns[j]] = free_delta[j];
    for (size_t k = 0; k + 1 < period; k++)
        for (i = 0; i < d; i++) {
            double *next = delta + (k + 1) * d + i;
            *next = at->miss[k * d + i];
            for (j = 0; j < d; j++) *next += at->slopes[(k * d + i) * d + j] * delta[k * d + j];
        }
    return JLT_OK;
}

jlt_status jlt_newton_create(jlt_newton *out, const jlt_flow *flow, const double *points, size_t period, const unsigned char *held)
{
    const jlt_chart *chart = flow->chart;
    const size_t size = period * chart->dim;
    jlt_status st = JLT_ERR_NOMEM;

    *out = (jlt_newton){ .chart = chart, .held = held, .period = period };
    out->noise = flow->tolerance != 0 ? flow->tolerance : JLT_ORBIT_TOLERANCE;
    out->points = calloc(3 * size, sizeof *out->points);
    if (out->points == NULL) goto done;
    out->trial = out->points + size;
    out->delta = out->trial + size;
    memcpy(out->points, points, size * sizeof *points);
    memcpy(out->trial, points, size * sizeof *points);
    JLT_TRY(jlt_shooting_create(&out->now, chart->dim, period));
    JLT_TRY(jlt_shooting_create(&out->then, chart->dim, period));
done:
    if (st != JLT_OK) jlt_newton_clear(out);
    return st;
}

void jlt_newton_clear(jlt_newton *self)
{
    free(self->points);
    jlt_shooting_clear(&self->now);
    jlt_shooting_clear(&self->then);
    *self = (jlt_newton){ 0 };
}

static bool end(jlt_newton *self, jlt_status status)
{
    self->status = status;
    return false;
}

/* End the search: with OK if the best points are an orbit. */
static bool judge(jlt_newton *self, jlt_status otherwise)
{
    const bool is_small = self->now.residual <= fmin(accepted * self->now.scale, accepted_most);
    const bool fell = self->now.residual <= fmax(fallen * self->first, self->noise * self->now.scale);

    return end(self, is_small && fell ? JLT_OK : otherwise);
}

static bool try_step(jlt_newton *self)
{
    const unsigned d = self->chart->dim;
    double move[D];

    for (size_t k = 0; k < self->period; k++) {
        jlt_chart_unscaled(self->chart, move, self->delta + k * d);
        for (unsigned i = 0; i < d; i++) {
            const double to = self->points[k * d + i] + self->factor * move[i];
            self->trial[k * d + i] = fabs(to) < JLT_STEPPER_SCALE_LEAST ? 0 : to; /* of less no digit may be right */
        }
        jlt_chart_wrap(self->chart, self->trial + k * d);
    }
    return true;
}

static bool new_step(jlt_newton *self)
{
    const unsigned d = self->chart->dim;
    double longest = 0, length;

    if (self->iteration++ == ITERATIONS || !(self->now.residual > 0)) return judge(self, JLT_ERR_NO_CONVERGENCE);
    const jlt_status st = step(self->delta, &length, &self->now, d, self->period, self->held);
    if (st != JLT_OK) return end(self, st);
    self->doubt = length > drowned ? INFINITY : length > stretching ? fmax(1, 10 * self->noise * length) : 0;
    for (size_t k = 0; k < self->period; k++) longest = fmax(longest, jlt_linear_length(self->delta + k * d, d));
    self->factor = longest > longest_step ? longest_step / longest : 1;
    self->halving = 0;
    return try_step(self);
}

bool jlt_newton_next(jlt_newton *self, jlt_status looked)
{
    const jlt_shooting last = self->now;

    if (!self->has_begun && looked != JLT_OK) return end(self, looked);
    if (self->has_begun && (looked != JLT_OK || !(self->then.residual < self->now.residual))) {
        self->factor /= 2; /* that a trial has no image says nothing of the first points, which have theirs */
        return ++self->halving < HALVINGS ? try_step(self)
                                          : judge(self, looked == JLT_ERR_NOMEM ? looked : JLT_ERR_NO_CONVERGENCE);
    }
    if (!self->has_begun) self->first = self->then.residual;
    self->has_begun = true;
    memcpy(self->points, self->trial, self->period * self->chart->dim * sizeof *self->points);
    self->now = self->then;
    self->then = last;
    return new_step(self);
}
