#include "dynamics/branch.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "core/memory.h"
#include "dynamics/linear.h"
#include "dynamics/section_batch.h"

/* Set bend: F maps r v to lambda r v + bend[0] (lambda^2 - lambda) r^2 v + bend[1] (lambda^2 - other) r^2 w, to second order. */
static void set_bend(jlt_branch *self, const jlt_chart *chart, const double v[2], const double w[2], double other)
{
    const double cross = v[0] * w[1] - v[1] * w[0], r = self->seed / self->lambda, square = self->lambda * self->lambda;
    double start[2], off[2];
    jlt_image image = { .q = { 0 } };

    for (unsigned k = 0; k < 2; k++) start[k] = self->q[k] + r * self->v[k];
    jlt_chart_wrap(chart, start);
    const bool returns = jlt_map_point(self->map, &image, start, self->returns, self->time_direction) == JLT_OK;
    jlt_chart_difference(chart, off, image.q, self->q);
    jlt_chart_scaled(chart, off, off);
    for (unsigned k = 0; k < 2; k++) off[k] = returns ? off[k] - self->seed * v[k] : NAN;
    self->bend[0] = (off[0] * w[1] - off[1] * w[0]) / cross / (r * r * (square - self->lambda));
    self->bend[1] = (v[0] * off[1] - v[1] * off[0]) / cross / (r * r * (square - other));
}

jlt_status jlt_branch_init(jlt_branch *out, jlt_map *map, const jlt_periodic *saddle, bool stable, int side, double seed)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    jlt_branch self = { .map = map, .time_direction = stable ? -1 : 1, .seed = seed };
    double multiplier, beside, turn, slope[4], v[2], w[2];

    if (chart->dim != 2 || (side != 1 && side != -1)) return JLT_ERR_ARG;
    if (!(seed >= JLT_BRANCH_SEED_LEAST && seed <= JLT_BRANCH_SEED_MOST)) return JLT_ERR_ARG;
    if (saddle->type != JLT_ORBIT_SADDLE && saddle->type != JLT_ORBIT_FLIP_SADDLE) return JLT_ERR_ARG;
    multiplier = stable ? saddle->re[1] : saddle->re[0];
    beside = stable ? saddle->re[0] : saddle->re[1];
    jlt_chart_scaled_slope(chart, slope, saddle->slope);
    jlt_linear_eigenvector(v, slope, multiplier);
    jlt_linear_eigenvector(w, slope, beside);
    turn = fabs(v[0]) > fabs(v[1]) ? v[0] : v[1];
    if ((turn < 0) != (side < 0)) v[0] = -v[0], v[1] = -v[1];
    jlt_chart_unscaled(chart, self.v, v);
    jlt_chart_unscaled(chart, self.w, w);
    self.returns = saddle->period;
    self.lambda = stable ? 1 / multiplier : multiplier;
    beside = stable ? 1 / beside : beside;
    if (multiplier < 0) {
        self.returns *= 2;
        self.lambda *= self.lambda;
        beside *= beside;
    }
    memcpy(self.q, saddle->points, sizeof self.q);
    set_bend(&self, chart, v, w, beside);
    *out = self;
    return JLT_OK;
}

static bool is_parameter(double sigma) { return sigma >= 0 && isfinite(sigma); }

/* n, the number of F that lead to gamma(sigma). */
static double times(const jlt_branch *self, double sigma)
{
    return ceil(sigma) + (self->near ? ceil(log(2) / (2 * log(self->lambda))) : 0);
}

/* Distance from the saddle from where F^n leads to gamma(sigma). */
static double distance(const jlt_branch *self, double sigma) { return self->seed * pow(self->lambda, sigma - times(self, sigma)); }

double jlt_branch_blur(const jlt_branch *self, double tolerance) { return tolerance / (self->seed * log(self->lambda)); }

double jlt_branch_bent_sigma(const jlt_branch *self, double sigma)
{
    return sigma - log1p(self->bend[0] * distance(self, sigma)) / log(self->lambda);
}

/* Returns n. Out: start, from where F^n leads to gamma(sigma); rate, its derivative by sigma. */
static size_t begin(const jlt_branch *self, double start[2], double rate[2], double sigma)
{
    const double r = distance(self, sigma);

    for (unsigned k = 0; k < 2; k++) {
        const double bend = self->bent ? self->bend[0] * self->v[k] + self->bend[1] * self->w[k] : 0;
        start[k] = self->q[k] + r * (self->v[k] + r * bend);
        rate[k] = r * log(self->lambda) * (self->v[k] + 2 * r * bend);
    }
    jlt_chart_wrap(jlt_map_flow(self->map)->chart, start);
    return (size_t)times(self, sigma);
}

jlt_status jlt_branch_curve(const jlt_branch *const *branches, jlt_status *status, double *q, const double *sigma, size_t count)
{
    JLT_OWNED(jlt_section_batch) *batch = NULL;
    JLT_FREED size_t *moving = calloc(count + 1, sizeof *moving), *returns = calloc(count + 1, sizeof *returns);
    JLT_FREED double *starts = calloc(2 * count + 1, sizeof *starts);
    double rate[2];
    jlt_return row;
    size_t n = 0, most = 0;

    if (moving == NULL || returns == NULL || starts == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < count; i++) {
        status[i] = is_parameter(sigma[i]) ? JLT_OK : JLT_ERR_ARG;
        if (status[i] != JLT_OK) continue;
        returns[n] = begin(branches[i], q + 2 * i, rate, sigma[i]) * branches[i]->returns;
        if (returns[n] == 0) continue;
        if (returns[n] > most) most = returns[n];
        memcpy(starts + 2 * n, q + 2 * i, 2 * sizeof *q);
        moving[n++] = i;
    }
    if (n == 0) return JLT_OK;
    const jlt_branch *any = branches[0];
    const jlt_flow *flow = jlt_map_flow(any->map);
    const jlt_section_batch_options options = { .threads = any->threads, .backwards = any->time_direction < 0, .last_only = true };
    JLT_PASS(jlt_section_batch_create(&batch, flow, any->kernels, &options));
    JLT_PASS(jlt_section_batch_run_each(batch, starts, NULL, returns, n, most));
    for (size_t k = 0; k < n; k++) {
        const size_t i = moving[k];
        status[i] = jlt_section_batch_last(batch, &row, k);
        if (status[i] == JLT_OK && row.interrupted) status[i] = JLT_ERR_NO_CONVERGENCE;
        if (status[i] == JLT_OK) status[i] = jlt_section_fate_status(row.fate);
        if (status[i] == JLT_OK && !jlt_chart_follows(flow->chart, row.x)) status[i] = JLT_ERR_DOMAIN;
        if (status[i] == JLT_OK) memcpy(q + 2 * i, row.q, 2 * sizeof *q);
    }
    return JLT_OK;
}

jlt_status jlt_branch_point(const jlt_branch *self, double q[2], double sigma)
{
    jlt_status status = JLT_OK;

    JLT_PASS(jlt_branch_curve(&self, &status, q, &sigma, 1));
    return status;
}

jlt_status jlt_branch_points(const jlt_branch *const *branches, jlt_map_batch *maps, jlt_status *status, double *q, double *tangent,
                             const double *sigma, size_t count)
{
    JLT_FREED size_t *returns = calloc(count + 1, sizeof *returns);
    JLT_FREED int *directions = calloc(count + 1, sizeof *directions);
    jlt_map_images room = { 0 };
    double start[2], rate[2];
    jlt_status st = returns != NULL && directions != NULL ? jlt_map_batch_images(&room, 2, count + 1) : JLT_ERR_NOMEM;

    for (size_t i = 0; st == JLT_OK && i < count; i++) {
        returns[i] = is_parameter(sigma[i]) ? begin(branches[i], room.q + 2 * i, rate, sigma[i]) * branches[i]->returns : 0;
        directions[i] = branches[i]->time_direction;
    }
    if (st == JLT_OK) st = jlt_map_batch_apply_each(maps, &room, room.q, count, returns, directions);
    for (size_t i = 0; st == JLT_OK && i < count; i++) {
        status[i] = is_parameter(sigma[i]) ? room.status[i] : JLT_ERR_ARG;
        if (status[i] != JLT_OK) continue;
        (void)begin(branches[i], start, rate, sigma[i]);
        memcpy(q + 2 * i, room.q + 2 * i, sizeof start);
        for (unsigned k = 0; k < 2; k++)
            tangent[2 * i + k] = room.slope[4 * i + 2 * k] * rate[0] + room.slope[4 * i + 2 * k + 1] * rate[1];
    }
    jlt_map_batch_images_clear(&room);
    return st;
}
