#include "dynamics/branch.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "core/memory.h"
#include "dynamics/linear.h"

jlt_status jlt_branch_init(jlt_branch *out, jlt_map *map, const jlt_periodic *saddle, bool stable, int side, double seed)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    jlt_branch self = { .map = map, .time_direction = stable ? -1 : 1, .seed = seed };
    double multiplier, turn, slope[4];

    if (chart->dim != 2 || (side != 1 && side != -1)) return JLT_ERR_ARG;
    if (!(seed >= JLT_BRANCH_SEED_LEAST && seed <= JLT_BRANCH_SEED_MOST)) return JLT_ERR_ARG;
    if (saddle->type != JLT_ORBIT_SADDLE && saddle->type != JLT_ORBIT_FLIP_SADDLE) return JLT_ERR_ARG;
    multiplier = stable ? saddle->re[1] : saddle->re[0];
    jlt_chart_scaled_slope(chart, slope, saddle->slope);
    jlt_linear_eigenvector(self.v, slope, multiplier);
    turn = fabs(self.v[0]) > fabs(self.v[1]) ? self.v[0] : self.v[1];
    if ((turn < 0) != (side < 0)) self.v[0] = -self.v[0], self.v[1] = -self.v[1];
    jlt_chart_unscaled(chart, self.v, self.v);
    self.returns = saddle->period;
    self.lambda = stable ? 1 / multiplier : multiplier;
    if (multiplier < 0) {
        self.returns *= 2;
        self.lambda *= self.lambda;
    }
    memcpy(self.q, saddle->points, sizeof self.q);
    *out = self;
    return JLT_OK;
}

static bool is_parameter(double sigma) { return sigma >= 0 && isfinite(sigma); }

/* Returns n = ceil(sigma). Out: start, from where F^n leads to gamma(sigma); *rate, of its distance from the saddle, by sigma. */
static size_t begin(const jlt_branch *self, double start[2], double *rate, double sigma)
{
    const double n = ceil(sigma), offset = self->seed * pow(self->lambda, sigma - n);

    *rate = offset * log(self->lambda);
    for (unsigned k = 0; k < 2; k++) start[k] = self->q[k] + offset * self->v[k];
    jlt_chart_wrap(jlt_map_flow(self->map)->chart, start);
    return (size_t)n;
}

static void turn(double *tangent, const jlt_branch *self, double rate, const double *slope)
{
    for (unsigned k = 0; k < 2; k++) tangent[k] = rate * (slope[2 * k] * self->v[0] + slope[2 * k + 1] * self->v[1]);
}

jlt_status jlt_branch_point(const jlt_branch *self, double q[2], double sigma)
{
    double start[2], rate;
    jlt_image image;

    if (!is_parameter(sigma)) return JLT_ERR_ARG;
    const size_t n = begin(self, start, &rate, sigma);
    if (n == 0) {
        memcpy(q, start, sizeof start);
        return JLT_OK;
    }
    JLT_PASS(jlt_map_point(self->map, &image, start, n * self->returns, self->time_direction));
    if (!jlt_chart_follows(jlt_map_flow(self->map)->chart, image.x)) return JLT_ERR_DOMAIN;
    memcpy(q, image.q, sizeof start);
    return JLT_OK;
}

jlt_status jlt_branch_points(const jlt_branch *const *branches, jlt_map_batch *maps, jlt_status *status, double *q, double *tangent,
                             const double *sigma, size_t count)
{
    JLT_FREED size_t *returns = calloc(count + 1, sizeof *returns);
    JLT_FREED int *directions = calloc(count + 1, sizeof *directions);
    jlt_map_images room = { 0 };
    double start[2], rate;
    jlt_status st = returns != NULL && directions != NULL ? jlt_map_batch_images(&room, 2, count + 1) : JLT_ERR_NOMEM;

    for (size_t i = 0; st == JLT_OK && i < count; i++) {
        returns[i] = is_parameter(sigma[i]) ? begin(branches[i], room.q + 2 * i, &rate, sigma[i]) * branches[i]->returns : 0;
        directions[i] = branches[i]->time_direction;
    }
    if (st == JLT_OK) st = jlt_map_batch_apply_each(maps, &room, room.q, count, returns, directions);
    for (size_t i = 0; st == JLT_OK && i < count; i++) {
        status[i] = is_parameter(sigma[i]) ? room.status[i] : JLT_ERR_ARG;
        if (status[i] != JLT_OK) continue;
        (void)begin(branches[i], start, &rate, sigma[i]);
        memcpy(q + 2 * i, room.q + 2 * i, sizeof start);
        turn(tangent + 2 * i, branches[i], rate, room.slope + 4 * i);
    }
    jlt_map_batch_images_clear(&room);
    return st;
}
