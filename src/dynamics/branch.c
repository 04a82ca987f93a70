#include "dynamics/branch.h"

#include <math.h>
#include <string.h>

#include "dynamics/linear.h"

jlt_status jlt_branch_init(jlt_branch *out, jlt_map *map, const jlt_periodic *saddle, size_t point, bool stable,
                           int side, double seed)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    jlt_periodic orbit = *saddle;
    jlt_branch self = { .map = map, .time_direction = stable ? -1 : 1, .seed = seed };
    double multiplier, turn;
    jlt_status st;

    if (chart->dim != 2 || (side != 1 && side != -1) || !(seed >= 1e-8 && seed <= 1e-2)) return JLT_ERR_ARG;
    if (saddle->type != JLT_ORBIT_SADDLE && saddle->type != JLT_ORBIT_FLIP_SADDLE) return JLT_ERR_ARG;
    if (point != 0) {
        st = jlt_periodic_rotate(map, &orbit, point);
        if (st != JLT_OK) return st;
    }
    multiplier = stable ? orbit.re[1] : orbit.re[0];
    jlt_linear_eigenvector(self.v, orbit.slope, multiplier);
    turn = fabs(self.v[0]) > fabs(self.v[1]) ? self.v[0] : self.v[1];
    if ((turn < 0) != (side < 0)) self.v[0] = -self.v[0], self.v[1] = -self.v[1];
    self.returns = orbit.period;
    self.lambda = stable ? 1 / multiplier : multiplier;
    if (multiplier < 0) {
        self.returns *= 2;
        self.lambda *= self.lambda;
    }
    memcpy(self.q, orbit.points, sizeof self.q);
    *out = self;
    return JLT_OK;
}

jlt_status jlt_branch_point(const jlt_branch *self, double q[2], double *tangent, double sigma)
{
    const jlt_chart *chart = jlt_map_flow(self->map)->chart;
    const double n = ceil(sigma), offset = self->seed * pow(self->lambda, sigma - n), rate = offset * log(self->lambda);
    double start[2] = { self->q[0] + offset * self->v[0], self->q[1] + offset * self->v[1] };
    jlt_image image;
    jlt_status st;

    if (!(sigma >= 0)) return JLT_ERR_ARG;
    jlt_chart_wrap(chart, start);
    if (n == 0) {
        memcpy(q, start, sizeof start);
        if (tangent != NULL) tangent[0] = rate * self->v[0], tangent[1] = rate * self->v[1];
        return JLT_OK;
    }
    if (tangent == NULL) st = jlt_map_point(self->map, &image, start, (size_t)n * self->returns, self->time_direction);
    else st = jlt_map_apply(self->map, &image, start, (size_t)n * self->returns, self->time_direction);
    if (st != JLT_OK) return st;
    memcpy(q, image.q, sizeof start);
    if (tangent != NULL) {
        tangent[0] = rate * (image.slope[0] * self->v[0] + image.slope[1] * self->v[1]);
        tangent[1] = rate * (image.slope[2] * self->v[0] + image.slope[3] * self->v[1]);
    }
    return JLT_OK;
}
