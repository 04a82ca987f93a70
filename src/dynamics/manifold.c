#include "dynamics/manifold.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Parameter steps are not halved below this: the branch ends there. */
static const double smallest_step = 1e-9;

void jlt_manifold_clear(jlt_manifold *self)
{
    free(self->points);
    free(self->sigma);
    free(self->length);
    *self = (jlt_manifold){ .count = 0 };
}

static jlt_status reserve(jlt_manifold *self, size_t count)
{
    self->points = malloc(count * 2 * sizeof *self->points);
    self->sigma = malloc(count * sizeof *self->sigma);
    self->length = malloc(count * sizeof *self->length);
    return self->points != NULL && self->sigma != NULL && self->length != NULL ? JLT_OK : JLT_ERR_NOMEM;
}

static void append(jlt_manifold *self, const jlt_chart *chart, const double *q, double sigma)
{
    const size_t n = self->count;

    self->length[n] = n == 0 ? 0 : self->length[n - 1] + jlt_chart_distance(chart, q, self->points + 2 * (n - 1));
    memcpy(self->points + 2 * n, q, 2 * sizeof *q);
    self->sigma[n] = sigma;
    self->count++;
}

/* Angle by which the polygon turns at its last point when q comes next. */
static double turn_at(const jlt_manifold *self, const jlt_chart *chart, const double *q)
{
    double before[2], after[2];

    if (self->count < 2) return 0;
    jlt_chart_difference(chart, before, self->points + 2 * (self->count - 1), self->points + 2 * (self->count - 2));
    jlt_chart_difference(chart, after, q, self->points + 2 * (self->count - 1));
    jlt_chart_scaled(chart, before, before);
    jlt_chart_scaled(chart, after, after);
    return fabs(atan2(before[0] * after[1] - before[1] * after[0], before[0] * after[0] + before[1] * after[1]));
}

static jlt_manifold_options with_defaults(const jlt_manifold_options *asked)
{
    jlt_manifold_options options = asked != NULL ? *asked : (jlt_manifold_options){ .spacing = 0 };

    if (options.spacing == 0) options.spacing = 0.01;
    if (options.turn == 0) options.turn = 0.2;
    if (options.finest == 0) options.finest = JLT_MANIFOLD_FINEST;
    if (options.length_max == 0) options.length_max = 5;
    if (options.points_max == 0) options.points_max = 20000;
    return options;
}

jlt_status jlt_manifold_grow(jlt_manifold *out, const jlt_branch *branch, const jlt_manifold_options *asked)
{
    const jlt_flow *flow = jlt_map_flow(branch->map);
    const jlt_manifold_options options = with_defaults(asked);
    jlt_manifold self = { .end = JLT_MANIFOLD_POINTS };
    /* several fundamental domains where each stretches the branch by less than a tenth */
    const double longest = 0.25 * fmax(1, 0.1 / log(branch->lambda));
    double q[2], sigma = 0, step = 1. / 16, returns = 0;
    jlt_status st = JLT_OK;

    if (!(options.spacing > options.finest) || !(options.turn > 0) || options.points_max < 2) return JLT_ERR_ARG;
    JLT_TRY(reserve(&self, options.points_max));
    JLT_TRY(jlt_branch_point(branch, q, 0));
    append(&self, flow->chart, q, 0);
    while (self.count < options.points_max) {
        double distance, turn;
        returns += ceil(sigma + step) * (double)branch->returns;
        if (returns > (double)options.points_max * JLT_MANIFOLD_RETURNS_A_POINT) {
            self.end = JLT_MANIFOLD_RETURNS;
            break;
        }
        st = jlt_branch_point(branch, q, sigma + step);
        if (flow->interrupt != NULL && *flow->interrupt) {
            st = JLT_OK;
            self.end = JLT_MANIFOLD_INTERRUPT;
            break;
        }
        if (st == JLT_ERR_DOMAIN || st == JLT_ERR_EMPTY || st == JLT_ERR_BUDGET) {
            st = JLT_OK;
            self.end = JLT_MANIFOLD_POLE;
            if (step < smallest_step) break;
            step /= 2;
            continue;
        }
        if (st != JLT_OK) goto done;
        self.end = JLT_MANIFOLD_POINTS;
        distance = jlt_chart_distance(flow->chart, q, self.points + 2 * (self.count - 1));
        turn = turn_at(&self, flow->chart, q);
        if (distance > options.finest && (distance > options.spacing || turn > options.turn) && step >= smallest_step) {
            step /= 2;
            continue;
        }
        sigma += step;
        append(&self, flow->chart, q, sigma);
        if (self.length[self.count - 1] >= options.length_max) {
            self.end = JLT_MANIFOLD_LENGTH;
            break;
        }
        if (distance < options.spacing / 2 && turn < options.turn / 2 && step < longest) step *= 1.5;
    }
    *out = self;
    self = (jlt_manifold){ .count = 0 };
done:
    jlt_manifold_clear(&self);
    return st;
}

jlt_status jlt_manifold_reflect(jlt_manifold *out, const jlt_manifold *curve, const jlt_chart *chart)
{
    jlt_manifold self = { .count = curve->count, .end = curve->end };
    const jlt_status st = reserve(&self, curve->count + 1);

    if (st != JLT_OK) {
        jlt_manifold_clear(&self);
        return st;
    }
    for (size_t i = 0; i < curve->count; i++) jlt_chart_mirror(chart, self.points + 2 * i, curve->points + 2 * i);
    memcpy(self.sigma, curve->sigma, curve->count * sizeof *self.sigma);
    memcpy(self.length, curve->length, curve->count * sizeof *self.length);
    *out = self;
    return JLT_OK;
}
