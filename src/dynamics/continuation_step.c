#include "dynamics/continuation_step.h"

#include <math.h>
#include <string.h>

#include "dynamics/linear.h"
#include "dynamics/scale.h"
#include "ext/eigen.h"
#include "integrate/step_control.h"

enum { U = JLT_CONTINUATION_U, NEWTON = 12, HALVINGS = 12 };

static const double same_point = 1e-7;
static const double returns = 1e-8;   /* Largest residual of an orbit, relative to |DP| and to the length of its way: is_orbit. */
static const double steep = 1e6;      /* |DP| above which a residual that errors of the map may cause hides errors of the orbit, */
static const double settled = 1e-8;   /* unless the last step was as small as this, scaled, and as errors of DP may make it */

/* The image of q at value + *off, scaled; where that is outside the model's domain, at the value itself, and *off becomes 0. */
static jlt_status image_beside(const jlt_continuation_runner *self, jlt_image *image, const double *q, double value, double *off)
{
    const jlt_family *family = self->family;
    jlt_map *map;
    jlt_status st;

    st = (family->map_near != NULL ? family->map_near : family->map_at)(family->context, &map,
                                                                        (value + *off) * self->options.scale);
    if (st == JLT_OK) st = jlt_map_point(map, image, q, self->period, 1);
    if (st != JLT_ERR_DOMAIN) return st;
    *off = 0;
    JLT_PASS(family->map_at(family->context, &map, value * self->options.scale));
    return jlt_map_point(map, image, q, self->period, 1);
}

bool jlt_continuation_step_is_at(double u, double limit) { return fabs(u - limit) <= 1e-14 * fmax(1, fabs(u)); }

/* The value at u; at an end of the range, the end itself. */
static double value_at(const jlt_continuation_options *range, double u)
{
    if (jlt_continuation_step_is_at(u, range->low / range->scale)) return range->low;
    return jlt_continuation_step_is_at(u, range->high / range->scale) ? range->high : u * range->scale;
}

double jlt_continuation_step_length(const jlt_continuation_runner *self, const double *u)
{
    double square = 0;

    for (unsigned k = 0; k < self->d; k++) square += self->chart.period[k] != 0 ? 0 : u[k] * u[k];
    return fmax(1, sqrt(square));
}

jlt_status jlt_continuation_step_evaluate(const jlt_continuation_runner *self, jlt_continuation_equation *out, const double *u)
{
    const unsigned d = self->d;
    const double range = (self->options.high - self->options.low) / self->options.scale, value = u[d] * self->options.scale;
    double difference[JLT_CHART_DIM_MAX], q[JLT_CHART_DIM_MAX];
    jlt_image image, above, below;
    jlt_map *map;

    JLT_PASS(self->family->map_at(self->family->context, &map, value));
    jlt_chart_unscaled(&self->chart, q, u);
    JLT_PASS(jlt_map_apply(map, &image, q, self->period, 1));
    jlt_chart_scaled_slope(&self->chart, out->slope, image.slope);
    out->scale = 1;
    for (unsigned i = 0; i < d * d; i++) out->scale = fmax(out->scale, fabs(out->slope[i]));
    /* A central difference errs by up^2 times the third derivative, which grows as scale^3, the derivative itself as scale. */
    double up = 1e-5 * fmin(1, range > 0 ? range : 1) / cbrt(out->scale * out->scale);
    if (fmin(value - self->options.low, self->options.high - value) < up * self->options.scale)
        up /= 100; /* the model may end there: a one-sided difference errs by `up` times the second derivative */
    double down = -up;
    JLT_PASS(image_beside(self, &above, q, u[d], &up));
    JLT_PASS(image_beside(self, &below, q, u[d], &down));
    jlt_chart_difference(&self->chart, out->f, image.q, q);
    jlt_chart_scaled(&self->chart, out->f, out->f);
    jlt_chart_difference(&self->chart, difference, above.q, below.q);
    jlt_chart_scaled(&self->chart, difference, difference);
    out->noise = fmax(1e-10, self->tolerance) * jlt_continuation_step_length(self, u) / self->length;
    out->T = image.T;
    for (unsigned i = 0; i < d; i++) {
        for (unsigned j = 0; j < d; j++) out->jacobian[i * (d + 1) + j] = out->slope[i * d + j] - (i == j);
        out->jacobian[i * (d + 1) + d] = difference[i] / (up - down);
    }
    return up > down ? JLT_OK : JLT_ERR_DOMAIN; /* the model may end on both sides of the value */
}

/* Make the bordered matrix [J; t], and return its determinant. */
static double border(double *matrix, const jlt_continuation_equation *at, const double *tangent, unsigned d)
{
    memcpy(matrix, at->jacobian, sizeof *matrix * d * (d + 1));
    memcpy(matrix + d * (d + 1), tangent, sizeof *matrix * (d + 1));
    return jlt_linear_determinant(matrix, d + 1);
}

/* Zero the columns of held coordinates, so that the least-squares solutions below do not change these. */
static void leave_out(const jlt_continuation_runner *self, double *matrix)
{
    for (unsigned j = 0; j < self->d; j++)
        for (unsigned i = 0; self->held[j] && i <= self->d; i++) matrix[i * (self->d + 1) + j] = 0;
}

/* Unit null vector of J on the side of `last`. Where last is orthogonal to it, the border is singular. */
static jlt_status tangent_at(const jlt_continuation_runner *self, double *tangent, const jlt_continuation_equation *at,
                             const double *last)
{
    const unsigned d = self->d;
    double matrix[U * U], right[U] = { 0 };

    border(matrix, at, last, d);
    leave_out(self, matrix);
    right[d] = 1;
    JLT_PASS(jlt_eigen_least_squares(tangent, matrix, right, d + 1, d + 1, 1e-14));
    const double length = jlt_linear_length(tangent, d + 1);
    if (!(length > 0)) return JLT_ERR_NO_CONVERGENCE;
    for (unsigned i = 0; i <= d; i++) tangent[i] /= length;
    return JLT_OK;
}

/* The unit of the map's errors at u, at most 1: the largest of the coordinates and of jlt_scale_moves, 1 if there are angles, and 0
 * if u has no image. On the section of an angle the errors, `noise` times this, are at least the tolerance. */
static double size_at(const jlt_continuation_runner *self, const double *u, double noise)
{
    const unsigned d = self->d;
    double q[JLT_CHART_DIM_MAX], moves[JLT_CHART_DIM_MAX + 1];
    jlt_map *map;

    jlt_chart_unscaled(&self->chart, q, u);
    if (self->family->map_at(self->family->context, &map, u[d] * self->options.scale) != JLT_OK ||
        jlt_scale_moves(moves, map, q) != JLT_OK) return 0;
    double size = self->chart.turn != 0 ? self->tolerance / noise : ldexp(moves[d], -self->chart.column_scale);
    jlt_chart_scaled(&self->chart, moves, moves);
    for (unsigned k = 0; k < d; k++) size = fmax(size, self->chart.period[k] != 0 ? 1 : fmax(fabs(u[k]), moves[k]));
    return fmin(size, 1);
}

/* Newton's method on F = 0, tangent . (u - start) = 0 from start = u, in place; *at is left at the last u. Out: *iterations, unless
 * NULL. Errors: NO_CONVERGENCE, also if a Newton step changes a component of u by more than 0.2 (times its length, over that of
 * the start); as evaluate. */
static jlt_status correct(const jlt_continuation_runner *self, double *u, jlt_continuation_equation *at, const double *tangent,
                          unsigned *iterations)
{
    const unsigned d = self->d;
    double matrix[U * U], right[U], delta[U], start[U], last = INFINITY, moved = INFINITY;

    memcpy(start, u, sizeof *u * (d + 1));
    for (unsigned k = 0; k < NEWTON; k++) {
        double residual = 0;
        JLT_PASS(jlt_continuation_step_evaluate(self, at, u));
        for (unsigned i = 0; i < d; i++) residual = fmax(residual, fabs(at->f[i]));
        if (iterations != NULL) *iterations = k;
        /* Iterate until the residual is rounding, or has ceased to fall and is no larger than the map's own error. */
        const bool known = at->scale <= steep || moved * fmax(1, 10 * self->tolerance * at->scale) <= settled;
        const double noise = at->noise * at->scale;
        if (known && (residual < 1e-15 * at->scale ||
                      (residual < noise && residual > last / 8 && residual < noise * size_at(self, u, at->noise)))) return JLT_OK;
        last = residual;
        border(matrix, at, tangent, d);
        leave_out(self, matrix);
        right[d] = 0;
        for (unsigned i = 0; i < d; i++) right[i] = -at->f[i];
        for (unsigned i = 0; i <= d; i++) right[d] -= tangent[i] * (u[i] - start[i]);
        JLT_PASS(jlt_eigen_least_squares(delta, matrix, right, d + 1, d + 1, 1e-14));
        moved = 0;
        for (unsigned i = 0; i <= d; i++) {
            u[i] += delta[i];
            moved = fmax(moved, fabs(delta[i]));
        }
        if (moved > 0.2 * jlt_continuation_step_length(self, u) / self->length) return JLT_ERR_NO_CONVERGENCE;
    }
    return JLT_ERR_NO_CONVERGENCE;
}

jlt_status jlt_continuation_step_measure(const jlt_continuation_runner *self, jlt_continuation_point *out, const double *u,
                                         const double *tangent, double arc, jlt_bifurcation kind)
{
    const unsigned d = self->d;
    jlt_map *map;
    jlt_image image;
    jlt_continuation_point point = { .value = value_at(&self->options, u[d]), .arc = arc, .kind = kind };

    JLT_PASS(self->family->map_at(self->family->context, &map, point.value));
    point.orbit.period = self->period;
    jlt_chart_unscaled(&self->chart, point.orbit.points, u);
    jlt_chart_wrap(jlt_map_flow(map)->chart, point.orbit.points);
    for (size_t k = 0; k + 1 < self->period; k++) {
        JLT_PASS(jlt_map_point(map, &image, point.orbit.points + k * d, 1, 1));
        memcpy(point.orbit.points + (k + 1) * d, image.q, d * sizeof *u);
    }
    JLT_PASS(jlt_periodic_measure(map, &point.orbit));
    memcpy(point.tangent, tangent, sizeof *tangent * (d + 1));
    *out = point;
    return JLT_OK;
}

/* The least jlt_periodic_crossing at the points of the orbit at u; 0 if one has no image. Out: *way, jlt_periodic_way at u in the
 * orbit's time T. */
static double least_crossing(const jlt_continuation_runner *self, double *way, const double *u, double T)
{
    double q[JLT_CHART_DIM_MAX], least;
    jlt_image image;
    jlt_map *map;

    if (self->family->map_at(self->family->context, &map, u[self->d] * self->options.scale) != JLT_OK) return 0;
    jlt_chart_unscaled(&self->chart, q, u);
    least = jlt_periodic_crossing(jlt_map_flow(map), q);
    *way = jlt_periodic_way(jlt_map_flow(map), q, T);
    for (size_t k = 1; least > 0 && k < self->period; k++) {
        if (jlt_map_point(map, &image, q, 1, 1) != JLT_OK) return 0;
        memcpy(q, image.q, self->d * sizeof *q);
        least = fmin(least, jlt_periodic_crossing(jlt_map_flow(map), q));
    }
    return least;
}

/* Whether the residual is so small that u is an orbit. Where DP is large only because the orbit almost touches the section, and the
 * multipliers are not, the residual times |DP| is their error. Around an equilibrium any small turn comes back to within its size
 * times the distance of the multipliers from 1: one that passes for an orbit has a multiplier within 1e-7 of 1. */
static bool is_orbit(const jlt_continuation_runner *self, const jlt_continuation_equation *at, const double *u)
{
    double residual = 0, way = 0;
    const double crossing = least_crossing(self, &way, u, at->T);

    for (unsigned i = 0; i < self->d; i++) residual = fmax(residual, fabs(at->f[i]));
    return residual < at->noise * at->scale * crossing && residual <= fmax(returns, self->tolerance) * at->scale * way;
}

/* Test functions at a point, in the order of jlt_bifurcation from FOLD. NaN: does not apply. */
static void test_functions(double test[4], const jlt_continuation_equation *at, const double *tangent, bool symmetric, unsigned d)
{
    double matrix[U * U], shifted[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX];

    test[0] = tangent[d];
    memcpy(shifted, at->slope, sizeof *shifted * d * d);
    for (unsigned i = 0; i < d; i++) shifted[i * d + i] += 1;
    test[1] = jlt_linear_determinant(shifted, d);
    test[2] = border(matrix, at, tangent, d);
    test[3] = d == 2 && !symmetric ? jlt_linear_determinant(at->slope, d) - 1 : NAN;
}

jlt_status jlt_continuation_step_to(const jlt_continuation_runner *self, jlt_continuation_place *out,
                                    const jlt_continuation_place *from, double step, unsigned *iterations)
{
    const unsigned d = self->d;
    jlt_continuation_place next = { .arc = from->arc + fabs(step), .symmetric = from->symmetric };

    for (unsigned i = 0; i <= d; i++) next.u[i] = from->u[i] + step * from->tangent[i];
    JLT_PASS(correct(self, next.u, &next.at, from->tangent, iterations));
    if (!is_orbit(self, &next.at, next.u)) return JLT_ERR_NO_CONVERGENCE;
    JLT_PASS(tangent_at(self, next.tangent, &next.at, from->tangent));
    test_functions(next.test, &next.at, next.tangent, next.symmetric, d);
    *out = next;
    return JLT_OK;
}

jlt_continuation_options jlt_continuation_step_defaults(const jlt_continuation_options *asked)
{
    jlt_continuation_options options = asked != NULL ? *asked : (jlt_continuation_options){ .scale = 0 };

    if (options.scale == 0) options.scale = 1;
    if (options.step == 0) options.step = 0.01;
    if (options.step_min == 0) options.step_min = 1e-6;
    if (options.step_max == 0) options.step_max = 0.05;
    if (options.points_max == 0) options.points_max = 500;
    if (options.low == 0 && options.high == 0) options.low = -INFINITY, options.high = INFINITY;
    return options;
}

bool jlt_continuation_step_allows(const jlt_continuation_options *options, int direction)
{
    return (direction == 1 || direction == -1) && options->scale > 0 && isfinite(options->scale) && options->step > 0
           && isfinite(options->step) && options->step_min > 0 && options->step_max > 0 && options->low <= options->high;
}

jlt_status jlt_continuation_step_open(jlt_continuation_runner *self, double value)
{
    jlt_map *map;

    JLT_PASS(self->family->map_at(self->family->context, &map, value));
    self->chart = *jlt_map_flow(map)->chart;
    self->d = self->chart.dim;
    self->tolerance = jlt_map_flow(map)->tolerance;
    self->length = 1;
    return JLT_OK;
}

jlt_status jlt_continuation_step_begin(jlt_continuation_runner *self, jlt_continuation_place *out,
                                       const jlt_continuation_point *start, int direction)
{
    const unsigned d = self->d;
    jlt_continuation_place first = { .symmetric = start->orbit.symmetric };
    double guess[U], mirror[JLT_CHART_DIM_MAX];
    const jlt_chart *chart = &self->chart;

    if (start->orbit.symmetric) {
        jlt_chart_mirror(chart, mirror, start->orbit.points);
        if (jlt_chart_distance(chart, mirror, start->orbit.points) < same_point)
            for (unsigned i = 0; i < d; i++) self->held[i] = chart->mirror[i] < 0;
    }
    jlt_chart_scaled(chart, first.u, start->orbit.points);
    first.u[d] = start->value / self->options.scale;
    self->length = jlt_continuation_step_length(self, first.u);
    JLT_PASS(jlt_continuation_step_evaluate(self, &first.at, first.u));
    memcpy(guess, start->tangent, sizeof guess);
    if (!(jlt_linear_length(guess, d + 1) > 0)) guess[d] = direction;
    JLT_PASS(tangent_at(self, first.tangent, &first.at, guess));
    test_functions(first.test, &first.at, first.tangent, first.symmetric, d);
    *out = first;
    return JLT_OK;
}

bool jlt_continuation_step_straight(const jlt_continuation_place *from, const jlt_continuation_place *to, double angle,
                                    unsigned d)
{
    double way[U];

    for (unsigned i = 0; i <= d; i++) way[i] = to->u[i] - from->u[i];
    const double length = jlt_linear_length(way, d + 1);
    return jlt_along(from->tangent, to->tangent, d + 1) >= cos(angle) &&
           fabs(jlt_along(way, from->tangent, d + 1)) >= length * cos(angle / 2) &&
           fabs(jlt_along(way, to->tangent, d + 1)) >= length * cos(angle / 2);
}

/* ---- the first point of the other branch, at a period doubling or a branch point ---- */

/* The direction of the other branch: at a period doubling the eigenvector of -1, at a branch point the null vector of the
 * rank-one Jacobian (2, 3) that is orthogonal to the tangent: the cross product of its longer row with the tangent. */
static void other_direction(double *direction, const jlt_continuation_equation *at, const jlt_continuation_point *point)
{
    const double *first = at->jacobian, *second = at->jacobian + 3, *row, *t = point->tangent;

    if (point->kind == JLT_BIFURCATION_DOUBLING) {
        jlt_linear_eigenvector(direction, at->slope, -1);
        direction[2] = 0;
        return;
    }
    row = fabs(first[0]) + fabs(first[1]) + fabs(first[2]) > fabs(second[0]) + fabs(second[1]) + fabs(second[2]) ? first
                                                                                                               : second;
    direction[0] = row[1] * t[2] - row[2] * t[1];
    direction[1] = row[2] * t[0] - row[0] * t[2];
    direction[2] = row[0] * t[1] - row[1] * t[0];
    const double length = jlt_linear_length(direction, 3);
    direction[0] /= length, direction[1] /= length, direction[2] /= length;
}

/* The unit vector along which points of the other branch lie off the branch at hand, whose unit tangent is given: the part of the
 * direction across that tangent. */
static void across(double *normal, const double *direction, const double *tangent)
{
    const double along = jlt_along(direction, tangent, 3);

    for (unsigned i = 0; i < 3; i++) normal[i] = direction[i] - along * tangent[i];
    const double length = jlt_linear_length(normal, 3);
    for (unsigned i = 0; i < 3; i++) normal[i] /= length;
}

/* Whether an orbit found at `way` from a doubling is of the branch that begins there in this direction: the way differs from it by
 * 0.15 rad at most, as where the tangent turns by 0.3 rad; and points half a period apart, which differ by twice the offset on that
 * branch, are not those of the orbit at hand, gone through twice. */
static bool is_doubled(const jlt_chart *chart, const jlt_periodic *orbit, const double *way, const double *direction, double offset)
{
    double apart[JLT_CHART_DIM_MAX];

    jlt_chart_difference(chart, apart, orbit->points + orbit->period / 2 * chart->dim, orbit->points);
    jlt_chart_scaled(chart, apart, apart);
    return jlt_along(way, direction, 3) >= jlt_linear_length(way, 3) * cos(0.15) && jlt_linear_length(apart, chart->dim) > offset;
}

jlt_status jlt_continuation_switch(jlt_continuation_point *out, const jlt_family *family,
                                   const jlt_continuation_point *at, int side, double offset,
                                   const jlt_continuation_options *options)
{
    jlt_continuation_runner self = { .family = family, .options = jlt_continuation_step_defaults(options),
                                     .period = at->orbit.period };
    const bool doubling = at->kind == JLT_BIFURCATION_DOUBLING;
    double u[U] = { 0 }, origin[U], direction[U] = { 0 }, normal[U] = { 0 }, way[U];
    jlt_continuation_equation here;
    jlt_continuation_point point;

    if ((side != 1 && side != -1) || !(offset > 0) || (at->kind != JLT_BIFURCATION_BRANCH && !doubling)) return JLT_ERR_ARG;
    JLT_PASS(jlt_continuation_step_open(&self, at->value));
    if (self.d != 2) return JLT_ERR_ARG;
    jlt_chart_scaled(&self.chart, u, at->orbit.points);
    u[2] = at->value / self.options.scale;
    JLT_PASS(jlt_continuation_step_evaluate(&self, &here, u));
    other_direction(direction, &here, at);
    if (doubling) self.period *= 2;
    memcpy(origin, u, sizeof origin);
    for (unsigned i = 0; i < 3; i++) direction[i] *= side;
    across(normal, direction, at->tangent);
    for (unsigned halving = 0; halving < HALVINGS; halving++, offset /= 2) {
        for (unsigned i = 0; i < 3; i++) u[i] = origin[i] + offset * direction[i];
        jlt_status st = correct(&self, u, &here, normal, NULL);
        if (st == JLT_OK) st = jlt_continuation_step_measure(&self, &point, u, direction, 0, JLT_BIFURCATION_NONE);
        if (st == JLT_ERR_NOMEM) return st;
        for (unsigned i = 0; i < 3; i++) way[i] = u[i] - origin[i];
        if (st != JLT_OK || point.value < self.options.low || point.value > self.options.high) continue;
        if (doubling && !is_doubled(&self.chart, &point.orbit, way, direction, offset)) continue;
        *out = point;
        return JLT_OK;
    }
    return JLT_ERR_NO_CONVERGENCE;
}
