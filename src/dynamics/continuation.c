#include "dynamics/continuation.h"

#include <math.h>
#include <string.h>

#include "dynamics/linear.h"
#include "ext/eigen.h"

enum { U = JLT_CHART_DIM_MAX + 1, NEWTON = 12, LOCATE = 40 };

/* One run's constants. */
typedef struct {
    const jlt_family *family;
    jlt_continuation_options options;
    size_t period;
    unsigned d;
} runner;

/* F(u) = P^period(q) - q with its Jacobian (d, d + 1). */
typedef struct {
    double f[JLT_CHART_DIM_MAX], jacobian[JLT_CHART_DIM_MAX * U], slope[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX];
    double scale;
} equation;

const char *jlt_continuation_bifurcation_name(jlt_bifurcation kind)
{
    static const char *const names[] = { "", "fold", "period doubling", "branch point", "torus" };
    return (unsigned)kind < sizeof names / sizeof *names ? names[kind] : "unknown";
}

static jlt_status image_at(const runner *self, jlt_image *image, const double *u, bool with_slope)
{
    jlt_map *map;
    jlt_status st = self->family->map_at(self->family->context, &map, u[self->d] * self->options.scale);

    if (st != JLT_OK) return st;
    return with_slope ? jlt_map_apply(map, image, u, self->period, 1) : jlt_map_point(map, image, u, self->period, 1);
}

static jlt_status evaluate(const runner *self, equation *out, const double *u)
{
    const unsigned d = self->d;
    const double h = 1e-5;
    double shifted[U], difference[JLT_CHART_DIM_MAX];
    jlt_image image, above, below;
    jlt_map *map;
    jlt_status st = JLT_OK;
    unsigned i, j;

    memcpy(shifted, u, sizeof *u * (d + 1));
    shifted[d] = u[d] + h;
    JLT_TRY(image_at(self, &above, shifted, false));
    shifted[d] = u[d] - h;
    JLT_TRY(image_at(self, &below, shifted, false));
    JLT_TRY(image_at(self, &image, u, true));
    JLT_TRY(self->family->map_at(self->family->context, &map, u[d] * self->options.scale));
    jlt_chart_difference(jlt_map_flow(map)->chart, out->f, image.q, u);
    jlt_chart_difference(jlt_map_flow(map)->chart, difference, above.q, below.q);
    memcpy(out->slope, image.slope, sizeof out->slope);
    out->scale = 1;
    for (i = 0; i < d; i++) {
        for (j = 0; j < d; j++) {
            out->jacobian[i * (d + 1) + j] = image.slope[i * d + j] - (i == j);
            out->scale = fmax(out->scale, fabs(image.slope[i * d + j]));
        }
        out->jacobian[i * (d + 1) + d] = difference[i] / (2 * h);
    }
done:
    return st;
}

/* The bordered matrix [J; t] and its determinant. */
static double border(double *matrix, const equation *at, const double *tangent, unsigned d)
{
    memcpy(matrix, at->jacobian, sizeof *matrix * d * (d + 1));
    memcpy(matrix + d * (d + 1), tangent, sizeof *matrix * (d + 1));
    return jlt_linear_determinant(matrix, d + 1);
}

/* Unit null vector of J on the side of `last`. Where last is orthogonal to it, the border is singular. */
static jlt_status tangent_at(double *tangent, const equation *at, const double *last, unsigned d)
{
    double matrix[U * U], right[U] = { 0 }, sum = 0;
    unsigned i;
    jlt_status st;

    border(matrix, at, last, d);
    right[d] = 1;
    st = jlt_eigen_least_squares(tangent, matrix, right, d + 1, d + 1, 1e-14);
    if (st != JLT_OK) return st;
    for (i = 0; i <= d; i++) sum += tangent[i] * tangent[i];
    if (!(sum > 0)) return JLT_ERR_NO_CONVERGENCE;
    for (i = 0; i <= d; i++) tangent[i] /= sqrt(sum);
    return JLT_OK;
}

/* Newton from u on F = 0, tangent . (u - start) = 0. *iterations may be NULL. */
static jlt_status correct(const runner *self, double *u, equation *at, const double *tangent, unsigned *iterations)
{
    const unsigned d = self->d;
    double matrix[U * U], right[U], delta[U], start[U], last = INFINITY;
    jlt_status st = JLT_OK;
    unsigned i, k;

    memcpy(start, u, sizeof *u * (d + 1));
    for (k = 0; k < NEWTON; k++) {
        double residual = 0, moved = 0;
        JLT_TRY(evaluate(self, at, u));
        for (i = 0; i < d; i++) residual = fmax(residual, fabs(at->f[i]));
        if (iterations != NULL) *iterations = k;
        /* On to rounding: until the residual is that, or falls no more. */
        if (residual < 1e-15 * at->scale || (residual < 1e-10 * at->scale && residual > last / 8)) return JLT_OK;
        last = residual;
        border(matrix, at, tangent, d);
        right[d] = 0;
        for (i = 0; i < d; i++) right[i] = -at->f[i];
        for (i = 0; i <= d; i++) right[d] -= tangent[i] * (u[i] - start[i]);
        JLT_TRY(jlt_eigen_least_squares(delta, matrix, right, d + 1, d + 1, 1e-14));
        for (i = 0; i <= d; i++) {
            u[i] += delta[i];
            moved = fmax(moved, fabs(delta[i]));
        }
        if (moved > 0.2) return JLT_ERR_NO_CONVERGENCE;
    }
    st = JLT_ERR_NO_CONVERGENCE;
done:
    return st;
}

/* The measured point at u. */
static jlt_status measure(const runner *self, jlt_continuation_point *out, const double *u, const double *tangent,
                          double arc, jlt_bifurcation kind)
{
    const unsigned d = self->d;
    jlt_map *map;
    jlt_image image;
    jlt_continuation_point point = { .value = u[d] * self->options.scale, .arc = arc, .kind = kind };
    jlt_status st = JLT_OK;
    size_t k;

    JLT_TRY(self->family->map_at(self->family->context, &map, point.value));
    point.orbit.period = self->period;
    memcpy(point.orbit.points, u, d * sizeof *u);
    jlt_chart_wrap(jlt_map_flow(map)->chart, point.orbit.points);
    for (k = 0; k + 1 < self->period; k++) {
        JLT_TRY(jlt_map_point(map, &image, point.orbit.points + k * d, 1, 1));
        memcpy(point.orbit.points + (k + 1) * d, image.q, d * sizeof *u);
    }
    JLT_TRY(jlt_periodic_measure(map, &point.orbit));
    memcpy(point.tangent, tangent, sizeof *tangent * (d + 1));
    *out = point;
done:
    return st;
}

/* Test functions at a point, in the order of jlt_bifurcation from FOLD. NaN: does not apply. */
static void test_functions(double test[4], const equation *at, const double *tangent, bool symmetric, unsigned d)
{
    double matrix[U * U], shifted[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX];
    unsigned i;

    test[0] = tangent[d];
    memcpy(shifted, at->slope, sizeof shifted);
    for (i = 0; i < d; i++) shifted[i * d + i] += 1;
    test[1] = jlt_linear_determinant(shifted, d);
    test[2] = border(matrix, at, tangent, d);
    test[3] = NAN;
    if (d == 2 && !symmetric && fabs(at->slope[0] + at->slope[3]) < 2)
        test[3] = jlt_linear_determinant(at->slope, d) - 1;
}

/* A point of the branch in working form. */
typedef struct {
    double u[U], tangent[U], test[4], arc;
    equation at;
    bool symmetric;
} place;

/* From `from` by arclength `step` along its tangent. */
static jlt_status step_to(const runner *self, place *out, const place *from, double step, unsigned *iterations)
{
    const unsigned d = self->d;
    place next = { .arc = from->arc + fabs(step), .symmetric = from->symmetric };
    jlt_status st = JLT_OK;
    unsigned i;

    for (i = 0; i <= d; i++) next.u[i] = from->u[i] + step * from->tangent[i];
    JLT_TRY(correct(self, next.u, &next.at, from->tangent, iterations));
    JLT_TRY(tangent_at(next.tangent, &next.at, from->tangent, d));
    test_functions(next.test, &next.at, next.tangent, next.symmetric, d);
    *out = next;
done:
    return st;
}

/* Where test k vanishes between from and from + step, by bisection with the secant's guess. */
static jlt_status locate(const runner *self, place *out, const place *from, const place *to, double step, unsigned k)
{
    double a = 0, b = step, fa = from->test[k], fb = to->test[k];
    place best = *to;
    jlt_status st = JLT_OK;
    int i;

    for (i = 0; i < LOCATE && fabs(b - a) > 1e-10 * fmax(1, fabs(step)); i++) {
        double s = i % 2 == 0 ? (a * fb - b * fa) / (fb - fa) : (a + b) / 2;
        if (!(s > fmin(a, b) && s < fmax(a, b))) s = (a + b) / 2;
        JLT_TRY(step_to(self, &best, from, s, NULL));
        if (best.test[k] == 0) break;
        if ((best.test[k] > 0) == (fb > 0)) b = s, fb = best.test[k];
        else a = s, fa = best.test[k];
    }
    *out = best;
done:
    return st;
}

/* Report sign changes between two places, then the new place. */
static jlt_status report(const runner *self, const place *from, const place *to, double step, jlt_continuation_sink sink,
                         void *context)
{
    jlt_continuation_point point;
    jlt_status st = JLT_OK;
    unsigned k;
    place at;

    for (k = 0; k < 4; k++) {
        if (isnan(from->test[k]) || isnan(to->test[k]) || (from->test[k] > 0) == (to->test[k] > 0)) continue;
        st = locate(self, &at, from, to, step, k);
        if (st == JLT_ERR_NOMEM) return st;
        if (st != JLT_OK) continue;
        JLT_TRY(measure(self, &point, at.u, at.tangent, at.arc, (jlt_bifurcation)(JLT_BIFURCATION_FOLD + k)));
        JLT_TRY(sink(context, &point));
    }
    JLT_TRY(measure(self, &point, to->u, to->tangent, to->arc, JLT_BIFURCATION_NONE));
    JLT_TRY(sink(context, &point));
done:
    return st;
}

static jlt_continuation_options with_defaults(const jlt_continuation_options *asked)
{
    jlt_continuation_options options = *asked;

    if (options.scale == 0) options.scale = 1;
    if (options.step == 0) options.step = 0.01;
    if (options.step_min == 0) options.step_min = 1e-6;
    if (options.step_max == 0) options.step_max = 0.05;
    if (options.points_max == 0) options.points_max = 500;
    return options;
}

static jlt_status begin(const runner *self, place *out, const jlt_continuation_point *start, int direction)
{
    const unsigned d = self->d;
    place first = { .symmetric = start->orbit.symmetric };
    double guess[U], sum = 0;
    jlt_status st = JLT_OK;
    unsigned i;

    memcpy(first.u, start->orbit.points, sizeof *first.u * d);
    first.u[d] = start->value / self->options.scale;
    JLT_TRY(evaluate(self, &first.at, first.u));
    memcpy(guess, start->tangent, sizeof guess);
    for (i = 0; i <= d; i++) sum += guess[i] * guess[i];
    if (!(sum > 0)) guess[d] = direction;
    JLT_TRY(tangent_at(first.tangent, &first.at, guess, d));
    test_functions(first.test, &first.at, first.tangent, first.symmetric, d);
    *out = first;
done:
    return st;
}

jlt_status jlt_continuation_run(jlt_continuation_end *end, const jlt_family *family,
                                const jlt_continuation_point *start, int direction,
                                const jlt_continuation_options *options, jlt_continuation_sink sink, void *context)
{
    runner self = { family, with_defaults(options), start->orbit.period, 0 };
    jlt_continuation_point point;
    jlt_map *map;
    place here, next;
    double step = self.options.step;
    size_t count = 1;
    jlt_status st = JLT_OK;

    if ((direction != 1 && direction != -1) || start->orbit.period == 0) return JLT_ERR_ARG;
    JLT_TRY(family->map_at(family->context, &map, start->value));
    self.d = jlt_map_flow(map)->chart->dim;
    JLT_TRY(begin(&self, &here, start, direction));
    JLT_TRY(measure(&self, &point, here.u, here.tangent, 0, JLT_BIFURCATION_NONE));
    JLT_TRY(sink(context, &point));
    *end = JLT_CONTINUATION_POINTS;
    while (count < self.options.points_max) {
        unsigned iterations = 0;
        double value;
        if (self.options.interrupt != NULL && *self.options.interrupt) {
            *end = JLT_CONTINUATION_INTERRUPT;
            break;
        }
        st = step_to(&self, &next, &here, step, &iterations);
        if (st == JLT_ERR_NOMEM) goto done;
        if (st != JLT_OK || iterations > 7) {
            st = JLT_OK;
            step /= 2;
            if (step >= self.options.step_min) continue;
            *end = JLT_CONTINUATION_STUCK;
            break;
        }
        value = next.u[self.d] * self.options.scale;
        if (value < self.options.low || value > self.options.high) {
            *end = JLT_CONTINUATION_RANGE;
            break;
        }
        JLT_TRY(report(&self, &here, &next, step, sink, context));
        count++;
        here = next;
        if (iterations < 6) step = fmin(1.4 * step, self.options.step_max);
    }
done:
    return st;
}

/* The direction of the other branch: at a period doubling the eigenvector of -1, at a branch point the null vector of the
 * rank-one Jacobian (2, 3) that is orthogonal to the tangent: the cross product of its longer row with the tangent. */
static void other_direction(double *direction, const equation *at, const jlt_continuation_point *point)
{
    const double *first = at->jacobian, *second = at->jacobian + 3, *row, *t = point->tangent;
    double length;

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
    length = sqrt(direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]);
    direction[0] /= length, direction[1] /= length, direction[2] /= length;
}

jlt_status jlt_continuation_switch(jlt_continuation_point *out, const jlt_family *family,
                                   const jlt_continuation_point *at, int side, double offset,
                                   const jlt_continuation_options *options)
{
    runner self = { family, with_defaults(options), at->orbit.period, 0 };
    double u[U] = { 0 }, direction[U] = { 0 };
    equation here;
    jlt_map *map;
    jlt_status st = JLT_OK;
    unsigned i;

    if ((side != 1 && side != -1) || !(offset > 0)) return JLT_ERR_ARG;
    if (at->kind != JLT_BIFURCATION_BRANCH && at->kind != JLT_BIFURCATION_DOUBLING) return JLT_ERR_ARG;
    JLT_TRY(family->map_at(family->context, &map, at->value));
    self.d = jlt_map_flow(map)->chart->dim;
    if (self.d != 2) return JLT_ERR_ARG;
    memcpy(u, at->orbit.points, 2 * sizeof *u);
    u[2] = at->value / self.options.scale;
    JLT_TRY(evaluate(&self, &here, u));
    other_direction(direction, &here, at);
    if (at->kind == JLT_BIFURCATION_DOUBLING) self.period *= 2;
    for (i = 0; i < 3; i++) {
        direction[i] *= side;
        u[i] += offset * direction[i];
    }
    JLT_TRY(correct(&self, u, &here, direction, NULL));
    JLT_TRY(measure(&self, out, u, direction, 0, JLT_BIFURCATION_NONE));
done:
    return st;
}
