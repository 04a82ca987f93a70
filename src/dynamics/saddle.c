#include "dynamics/saddle.h"

#include <math.h>
#include <string.h>

#include "dynamics/linear.h"
#include "ext/eigen.h"

static const double keeps = 0.1; /* the least determinant of a map that nearly keeps volume */
static const double far = 1e-3; /* a move of a return, of reach, by far more than those of returns at a saddle */

static double tolerance_of(const jlt_flow *flow) { return flow->tolerance != 0 ? flow->tolerance : JLT_ORBIT_TOLERANCE; }

/* An orbit that errors of about the tolerance move off a separatrix passes the saddle at the square root of the tolerance. */
static double near_of(const jlt_flow *flow, double reach) { return sqrt(tolerance_of(flow)) * fmax(reach, 1); }

/* Whether a return begins at a saddle, nearer than `near`. move: of the return; slope: DP; both in units of the coordinates' sizes.
 * Where DP stretches by more than errors allow, it is not known how far the saddle is. */
static bool is_at_saddle(const double *move, const double *slope, double determinant, const jlt_flow *flow, double near)
{
    static const double stretches = 1.1;
    const unsigned d = flow->chart->dim;
    const double length = jlt_linear_length(slope, d * d);
    double fixed[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX], off[JLT_CHART_DIM_MAX], re[JLT_CHART_DIM_MAX], im[JLT_CHART_DIM_MAX];

    if (!(determinant > keeps) || !(1e3 * length * tolerance_of(flow) < 1)) return false;
    if (!(jlt_linear_length(move, d) < near * (1 + length))) return false;
    for (unsigned i = 0; i < d * d; i++) fixed[i] = slope[i] - (i % (d + 1) == 0);
    if (jlt_eigen_least_squares(off, fixed, move, d, d, 1e-14) != JLT_OK || !(jlt_linear_length(off, d) < near)) return false;
    if (jlt_linear_eigenvalues(re, im, slope, d) != JLT_OK) return false;
    return hypot(re[0], im[0]) > stretches && hypot(re[d - 1], im[d - 1]) < 1 / stretches;
}

/* The move between two points, shape (dim,), in units of the coordinates' sizes; returns its length. */
static double move_between(double *move, const jlt_flow *flow, const double *after, const double *before)
{
    jlt_chart_difference(flow->chart, move, after, before);
    jlt_chart_scaled(flow->chart, move, move);
    return jlt_linear_length(move, flow->chart->dim);
}

/* The coordinates' sizes are those of the orbit's start, which may be near a saddle: hence reach. */
void jlt_saddle_note(jlt_saddle_watch *self, const jlt_flow *flow, const double *before, const jlt_map_batch_return *made,
                     size_t number)
{
    double move[JLT_CHART_DIM_MAX], slope[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX];
    const double length = move_between(move, flow, made->q, before);

    self->reach = fmax(self->reach, length);
    self->has_left |= self->at > 0 && length > far * fmax(self->reach, 1);
    if (self->at > 0) return;
    jlt_chart_scaled_slope(flow->chart, slope, made->slope);
    if (is_at_saddle(move, slope, made->flux_determinant, flow, near_of(flow, self->reach))) self->at = number;
}

/* Once the orbit has gone from where it moved least, compute DP there. A map that contracts volume there most likely contracts it
 * elsewhere too: few passages are examined after that. */
static jlt_status judge(jlt_saddle_search *self, jlt_map **map, const jlt_flow *flow, int time_direction)
{
    jlt_status st = *map != NULL ? JLT_OK : jlt_map_create(map, flow);
    jlt_image image;

    if (st == JLT_OK) st = jlt_map_apply(*map, &image, self->point, 1, time_direction);
    if (st != JLT_OK) return st == JLT_ERR_NOMEM ? st : JLT_OK;
    jlt_saddle_note(&self->watch, flow, self->point,
                    &(jlt_map_batch_return){ self->next, image.slope, image.flux_determinant, image.T, image.expansion },
                    self->number);
    self->watch.has_left = self->watch.at > 0;
    if (!(image.flux_determinant > keeps)) self->rests_until = 2 * self->number;
    return JLT_OK;
}

jlt_status jlt_saddle_search_note(jlt_saddle_search *self, jlt_map **map, const jlt_flow *flow, const double *before,
                                  const double *after, size_t number, int time_direction)
{
    const size_t size = flow->chart->dim * sizeof *before;
    double move[JLT_CHART_DIM_MAX];

    if (self->watch.at > 0) return JLT_OK;
    const double length = move_between(move, flow, after, before);
    self->watch.reach = fmax(self->watch.reach, length);
    const double reach = fmax(self->watch.reach, 1), near = near_of(flow, reach);
    if (self->number > 0 && length > fmax(far * reach, 10 * self->nearest)) {
        const bool is_near = self->nearest < sqrt(near / reach) * reach;
        if (is_near && self->number >= self->rests_until) JLT_PASS(judge(self, map, flow, time_direction));
        self->number = 0;
    }
    if (self->number > 0 && !(length < self->nearest)) return JLT_OK;
    self->nearest = length;
    self->number = number;
    memcpy(self->point, before, size);
    memcpy(self->next, after, size);
    return JLT_OK;
}
