#include "dynamics/periodic.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dynamics/linear.h"
#include "dynamics/newton.h"
#include "dynamics/scale.h"

enum { D = JLT_CHART_DIM_MAX };

static const double same_point = 1e-7;     /* scaled distances under this are one point */
static const double degenerate = 1e-7;     /* multipliers closer to +-1 than this are not classified */
/* A product of two multipliers' distances from 1 below which a residual of 1e-13 leaves points open by 1e-4, and so their type. */
static const double open_points = 1e-9;
static const double settled = 1e-8;        /* largest step left to Newton's method, relative to what the orbit runs through, */
static const double closed = 1e-6;         /* and largest distance by which a point is missed, relative to the same */
static const double standstill = 1e-6;     /* orbits that move less, relative to the state, only touch the section */
/* An orbit counts as lying in the section if at most this part of its velocity crosses it: at the edge of a level, where a state
 * varies as the square root of coordinates, a residual of 1e-10 in these leaves an error of 1e-5. */
static const double in_section = 2e-5;

const char *jlt_periodic_type_name(jlt_orbit_type type)
{
    static const char *const names[] = { "centre",    "saddle",    "flip saddle",
                                         "attracting", "repelling", "degenerate" };
    return (unsigned)type < sizeof names / sizeof *names ? names[type] : "unknown";
}

/* Where DP stretches a lot (`doubt` is not 0), whether the step that is left, and the residual, are small relative to the orbit:
 * there a residual as large as the map's errors does not show an orbit, least of all relative to a start whose motion ran far off,
 * or in a coordinate much smaller than 1; and the step is 0 in directions that count as those of a family. */
static jlt_status check_step(jlt_map *map, const jlt_newton *newton)
{
    const unsigned d = newton->chart->dim;
    double size[D] = { 0 }, step[D] = { 0 }, miss[D] = { 0 }, moves[D + 1], left[D], missed[D];

    if (newton->doubt == 0) return JLT_OK;
    for (size_t i = 0; i < newton->period; i++) {
        const double *q = newton->points + i * d;
        JLT_PASS(jlt_scale_moves(moves, map, q));
        jlt_chart_unscaled(newton->chart, left, newton->delta + i * d);
        jlt_chart_unscaled(newton->chart, missed, newton->now.miss + i * d);
        for (unsigned k = 0; k < d; k++) {
            size[k] = fmax(size[k], newton->chart->period[k] != 0 ? 1 : fmax(fabs(q[k]), moves[k]));
            step[k] = fmax(step[k], fabs(left[k]));
            miss[k] = fmax(miss[k], fabs(missed[k]));
        }
    }
    for (unsigned k = 0; k < d; k++)
        if (!(newton->doubt * step[k] <= settled * size[k])
            || !(miss[k] <= closed * size[k] + ldexp(DBL_EPSILON, newton->chart->unit[k])))
            return JLT_ERR_NO_CONVERGENCE;
    return JLT_OK;
}

/* Newton's method on points, in place, by the map alone, one trial after another. */
static jlt_status iterate(jlt_map *map, double *points, size_t period, const unsigned char *held)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    jlt_newton newton;

    JLT_PASS(jlt_newton_create(&newton, jlt_map_flow(map), points, period, held));
    while (jlt_newton_next(&newton, jlt_shooting_of(&newton.then, map, newton.trial, period))) { }
    memcpy(points, newton.points, period * chart->dim * sizeof *points);
    jlt_status st = newton.status;
    if (st == JLT_OK) st = check_step(map, &newton);
    jlt_newton_clear(&newton);
    return st;
}

size_t jlt_periodic_primitive(const jlt_chart *chart, const double *points, size_t period)
{
    for (size_t p = 1; p < period; p++)
        if (period % p == 0 && jlt_chart_distance(chart, points, points + p * chart->dim) < same_point) return p;
    return period;
}

static bool is_symmetric(const jlt_chart *chart, const double *points, size_t period)
{
    double image[D];

    if (!chart->reversible) return false;
    jlt_chart_mirror(chart, image, points);
    for (size_t k = 0; k < period; k++)
        if (jlt_chart_distance(chart, image, points + k * chart->dim) < same_point) return true;
    return false;
}

/* error: of DP. It moves a double multiplier +-1 by its square root, but hardly the product of two distances from +-1. */
static jlt_orbit_type classify(const double *re, const double *im, unsigned d, double error)
{
    unsigned i, inside = 0, outside = 0;

    for (i = 0; i < d; i++) {
        const double modulus = hypot(re[i], im[i]), one = copysign(1, re[i]), distance = hypot(re[i] - one, im[i]);
        if (distance < degenerate) return JLT_ORBIT_DEGENERATE;
        for (unsigned k = 0; k < i; k++)
            if (distance * hypot(re[k] - one, im[k]) < (one > 0 ? fmax(error, open_points) : error)) return JLT_ORBIT_DEGENERATE;
        if (modulus < 1 - degenerate) inside++;
        else if (modulus > 1 + degenerate) outside++;
    }
    if (inside == d) return JLT_ORBIT_ATTRACTING;
    if (outside == d) return JLT_ORBIT_REPELLING;
    if (inside == 0 && outside == 0) return JLT_ORBIT_CENTRE;
    return im[0] == 0 && re[0] < 0 ? JLT_ORBIT_FLIP_SADDLE : JLT_ORBIT_SADDLE;
}

/* Whether an error of DP, whose norm is `length`, may move an eigenvalue by as much (L. Elsner,
 * Linear Algebra Appl. 71, 1985). */
static bool may_move(double by, double length, double error, unsigned d)
{
    return pow(2 * length + error, 1 - 1.0 / d) * pow(error, 1.0 / d) >= by;
}

/* Replace the multipliers that the error of DP may change by more than a thousandth. A single one follows from the determinant,
 * which the divergence gives. Several become NaN; if all do, so does the trace, and the type is DEGENERATE unless all multipliers
 * are small, or none can come to the unit circle. */
static void leave_known(jlt_periodic *orbit, double length, double error, unsigned d)
{
    double rest = orbit->determinant;
    const double largest = hypot(orbit->re[0], orbit->im[0]);
    unsigned known = 0;

    for (; known < d && hypot(orbit->re[known], orbit->im[known]) > 1e3 * error; known++)
        rest /= orbit->im[known] != 0 ? hypot(orbit->re[known], orbit->im[known]) : orbit->re[known];
    for (unsigned i = known; i < d; i++) {
        orbit->re[i] = known + 1 == d ? rest : NAN;
        orbit->im[i] = known + 1 == d ? 0 : NAN;
    }
    if (known > 0) return;
    orbit->trace = NAN;
    if (1e3 * error >= 1 && may_move(1 - largest, length, error, d)) orbit->type = JLT_ORBIT_DEGENERATE;
}

/* Two multipliers whose product is the determinant: the smaller of two real ones keeps its digits through it, and a pair keeps its
 * angle, where errors of DP would make a centre attract. */
static void multiply_to(jlt_periodic *orbit)
{
    const double modulus = hypot(orbit->re[0], orbit->im[0]);

    if (orbit->im[0] == 0 && orbit->re[0] != 0) orbit->re[1] = orbit->determinant / orbit->re[0];
    if (orbit->im[0] == 0) return;
    for (unsigned i = 0; i < 2; i++) {
        orbit->re[i] *= sqrt(orbit->determinant) / modulus;
        orbit->im[i] *= sqrt(orbit->determinant) / modulus;
    }
    orbit->trace = 2 * orbit->re[0];
}

jlt_status jlt_periodic_measure(jlt_map *map, jlt_periodic *io)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    const double tolerance = jlt_map_flow(map)->tolerance;
    const unsigned d = chart->dim;
    jlt_periodic orbit = *io;
    JLT_CLEARED(jlt_shooting_clear) jlt_shooting at = { 0 };
    double *slope;
    unsigned i;

    if (io->period == 0 || io->period > JLT_PERIODIC_MAX) return JLT_ERR_ARG;
    JLT_PASS(jlt_shooting_create(&at, d, orbit.period));
    JLT_PASS(jlt_shooting_of(&at, map, orbit.points, orbit.period));
    slope = at.slopes; /* of the whole orbit, in place of the first return's */
    for (size_t k = 1; k < orbit.period; k++) jlt_linear_multiply(slope, at.slopes + k * d * d, slope, d);
    for (i = 0; d == 2 && i < 4; i++) orbit.slope[i] = ldexp(slope[i], chart->scale[i / 2] - chart->scale[i % 2]);
    for (orbit.trace = 0, i = 0; i < d; i++) orbit.trace += slope[i * d + i];
    orbit.T = at.T;
    orbit.residual = at.residual;
    orbit.defect = at.defect;
    orbit.determinant = exp(at.expansion);
    orbit.determinant_slope = at.determinant;
    /* Of DP: at least what its determinant is off by allows, where tangent vectors grew and shrank again and left their errors. */
    const double length = jlt_linear_length(slope, d * d), off = fabs(orbit.determinant_slope - orbit.determinant);
    const double least = (tolerance != 0 ? tolerance : JLT_ORBIT_TOLERANCE) * fmax(1, length);
    const double error = length > least ? fmax(least, off / pow(length, d - 1)) : least;
    JLT_PASS(jlt_linear_eigenvalues(orbit.re, orbit.im, slope, d));
    /* With one coordinate, a small multiplier keeps its digits through the divergence alone; DP gives its sign. */
    if (d == 1) {
        const bool turns_over = slope[0] < -orbit.determinant / 2 && slope[0] > -2 * orbit.determinant;
        orbit.trace = orbit.re[0] = turns_over ? -orbit.determinant : orbit.determinant;
    }
    if (d == 2) multiply_to(&orbit);
    orbit.symmetric = is_symmetric(chart, orbit.points, orbit.period);
    orbit.type = classify(orbit.re, orbit.im, d, error);
    if (d > 2 || (d == 2 && !(fabs(orbit.determinant_slope / orbit.determinant - 1) <= 1e-3)))
        leave_known(&orbit, length, error, d);
    *io = orbit;
    return JLT_OK;
}

/* The part of the velocity that crosses the section at q, whose state becomes x, its speed *speed; 0: negligible, or no state. */
static double crossing(double *x, double *speed, const jlt_flow *flow, const double *q)
{
    const jlt_chart *chart = flow->chart;
    double f[JLT_CHART_STATES_MAX];

    if (chart->lift(chart, x, NULL, q) != JLT_OK) return 0;
    flow->field->call(x, flow->field->p, f);
    *speed = jlt_chart_speed(chart, x, f);
    const double across = fabs(ldexp(f[chart->column], -chart->column_scale));
    return across > in_section * *speed ? across / *speed : 0;
}

double jlt_periodic_crossing(const jlt_flow *flow, const double *q)
{
    double x[JLT_CHART_STATES_MAX], speed;

    return crossing(x, &speed, flow, q);
}

double jlt_periodic_way(const jlt_flow *flow, const double *q, double T)
{
    double x[JLT_CHART_STATES_MAX], speed;

    if (!(crossing(x, &speed, flow, q) > 0)) return 0;
    return speed / jlt_field_time_rate(flow->field, x) * ldexp(T, -flow->units.time);
}

bool jlt_periodic_moves(const jlt_flow *flow, const jlt_periodic *orbit)
{
    const jlt_chart *chart = flow->chart;
    double q[D];

    for (size_t k = 1; k < orbit->period; k++)
        if (!(jlt_periodic_crossing(flow, orbit->points + k * chart->dim) > 0)) return false;
    jlt_chart_scaled(chart, q, orbit->points);
    return jlt_periodic_way(flow, orbit->points, orbit->T / (double)orbit->period) >
           standstill * fmax(1, jlt_linear_length(q, chart->dim));
}

jlt_status jlt_periodic_polish(jlt_map *map, jlt_periodic *out, const double *points, size_t period, const unsigned char *held)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    jlt_periodic orbit = { .period = period };

    if (period == 0 || period > JLT_PERIODIC_MAX) return JLT_ERR_ARG;
    memcpy(orbit.points, points, period * chart->dim * sizeof *points);
    JLT_PASS(iterate(map, orbit.points, period, held));
    orbit.period = jlt_periodic_primitive(chart, orbit.points, period);
    const jlt_status st = jlt_periodic_measure(map, &orbit); /* DOMAIN: the points went to an equilibrium, where nothing returns */
    if (st == JLT_ERR_DOMAIN || (st == JLT_OK && !jlt_periodic_moves(jlt_map_flow(map), &orbit))) return JLT_ERR_NO_CONVERGENCE;
    JLT_PASS(st);
    *out = orbit;
    return JLT_OK;
}

jlt_status jlt_periodic_find(jlt_map *map, jlt_periodic *out, const double *q, size_t period,
                             const unsigned char *held)
{
    const unsigned d = jlt_map_flow(map)->chart->dim;
    double points[JLT_PERIODIC_MAX * D];
    jlt_image image;

    if (period == 0 || period > JLT_PERIODIC_MAX) return JLT_ERR_ARG;
    memcpy(points, q, d * sizeof *q);
    for (size_t k = 0; k + 1 < period; k++) {
        JLT_PASS(jlt_map_point(map, &image, points + k * d, 1, 1));
        memcpy(points + (k + 1) * d, image.q, d * sizeof *q);
    }
    return jlt_periodic_polish(map, out, points, period, held);
}

jlt_status jlt_periodic_rotate(jlt_map *map, jlt_periodic *io, size_t first)
{
    const unsigned d = jlt_map_flow(map)->chart->dim;
    jlt_periodic orbit = *io;
    jlt_status st;

    if (first >= io->period) return JLT_ERR_ARG;
    for (size_t k = 0; k < io->period; k++)
        memcpy(orbit.points + k * d, io->points + (k + first) % io->period * d, d * sizeof *orbit.points);
    st = jlt_periodic_measure(map, &orbit);
    if (st == JLT_OK) *io = orbit;
    return st;
}

void jlt_periodic_mirror(const jlt_chart *chart, jlt_periodic *out, const jlt_periodic *orbit)
{
    *out = *orbit;
    for (size_t k = 0; k < orbit->period; k++)
        jlt_chart_mirror(chart, out->points + k * chart->dim, orbit->points + (orbit->period - k) % orbit->period * chart->dim);
}

bool jlt_periodic_same(const jlt_chart *chart, const jlt_periodic *a, const jlt_periodic *b, double distance)
{
    if (a->period != b->period) return false;
    for (size_t k = 0; k < a->period; k++)
        if (jlt_chart_distance(chart, a->points + k * chart->dim, b->points) < distance) return true;
    return false;
}
