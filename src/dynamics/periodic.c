#include "dynamics/periodic.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dynamics/linear.h"
#include "ext/eigen.h"

enum { D = JLT_CHART_DIM_MAX, ITERATIONS = 40, HALVINGS = 6 };

static const double same_point = 1e-7;     /* distances under this are one point */
static const double degenerate = 1e-7;     /* multipliers closer to +-1 than this are not classified */
static const double longest_step = 0.5;    /* of Newton, in section coordinates */
static const double accepted = 1e-10;      /* largest residual of a converged orbit, relative to |DP| of one return, */
static const double accepted_most = 1e-9;  /* and absolute */
static const double standstill = 1e-6;     /* orbits that move less, relative to the state, only touch the section */
static const double null_cutoff = 1e-11;   /* singular values of I - DP under this are a family of orbits */

const char *jlt_periodic_type_name(jlt_orbit_type type)
{
    static const char *const names[] = { "centre",    "saddle",    "flip saddle",
                                         "attracting", "repelling", "degenerate" };
    return (unsigned)type < sizeof names / sizeof *names ? names[type] : "unknown";
}

static double norm(const double *v, unsigned count)
{
    double sum = 0;
    unsigned i;

    for (i = 0; i < count; i++) sum += v[i] * v[i];
    return sqrt(sum);
}

/* What one pass over the orbit knows: each return's derivative and what misses to the next point. */
typedef struct {
    double *slopes, *miss; /* (period, d, d) and (period, d), in one block */
    double residual, scale;
    double T, expansion, determinant, defect;
} shooting;

static jlt_status make_room(shooting *out, unsigned d, size_t period)
{
    out->slopes = calloc(period, (size_t)d * (d + 1) * sizeof *out->slopes);
    out->miss = out->slopes != NULL ? out->slopes + period * d * d : NULL;
    return out->slopes != NULL ? JLT_OK : JLT_ERR_NOMEM;
}

static jlt_status shoot(jlt_map *map, shooting *out, const double *points, size_t period)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    const unsigned d = chart->dim;
    jlt_image image;
    jlt_status st;
    size_t i;

    out->residual = out->T = out->expansion = out->defect = 0;
    out->scale = out->determinant = 1;
    for (i = 0; i < period; i++) {
        st = jlt_map_apply(map, &image, points + i * d, 1, 1);
        if (st != JLT_OK) return st;
        memcpy(out->slopes + i * d * d, image.slope, sizeof *image.slope * d * d);
        jlt_chart_difference(chart, out->miss + i * d, image.q, points + (i + 1) % period * d);
        out->residual = fmax(out->residual, norm(out->miss + i * d, d));
        out->scale = fmax(out->scale, norm(image.slope, d * d));
        out->T += image.T;
        out->expansion += image.expansion;
        out->determinant *= image.determinant;
        if (fabs(image.defect) > fabs(out->defect)) out->defect = image.defect;
    }
    return JLT_OK;
}

/* With delta_(i+1) = A_i delta_i + r_i and delta_p = delta_0: (I - A_(p-1)..A_0) delta_0 = sum of the propagated r_i. */
static jlt_status newton_step(double delta[][D], const shooting *at, unsigned d, size_t period,
                              const unsigned char *held)
{
    double product[D * D] = { 0 }, carried[D] = { 0 }, system[D * D], free_delta[D];
    unsigned columns[D], count = 0, i, j;
    jlt_status st;
    size_t k;

    for (i = 0; i < d; i++) product[i * d + i] = 1;
    for (k = 0; k < period; k++) {
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
    st = jlt_eigen_least_squares(free_delta, system, carried, d, count, null_cutoff);
    if (st != JLT_OK) return st;
    memset(delta[0], 0, sizeof *delta);
    for (j = 0; j < count; j++) delta[0][columns[j]] = free_delta[j];
    for (k = 0; k + 1 < period; k++)
        for (i = 0; i < d; i++) {
            delta[k + 1][i] = at->miss[k * d + i];
            for (j = 0; j < d; j++) delta[k + 1][i] += at->slopes[(k * d + i) * d + j] * delta[k][j];
        }
    return JLT_OK;
}

/* Newton with steps halved until the residual falls, or cannot fall any more. */
static jlt_status iterate(jlt_map *map, double *points, size_t period, const unsigned char *held)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    const unsigned d = chart->dim;
    double delta[JLT_PERIODIC_MAX][D], trial[JLT_PERIODIC_MAX * D];
    shooting now = { 0 }, then = { 0 };
    jlt_status st = JLT_OK;
    unsigned iteration, halving, i;
    size_t k;

    JLT_TRY(make_room(&now, d, period));
    JLT_TRY(make_room(&then, d, period));
    JLT_TRY(shoot(map, &now, points, period));
    for (iteration = 0; iteration < ITERATIONS && now.residual > 0; iteration++) {
        double longest = 0, factor;
        JLT_TRY(newton_step(delta, &now, d, period, held));
        for (k = 0; k < period; k++) longest = fmax(longest, norm(delta[k], d));
        factor = longest > longest_step ? longest_step / longest : 1;
        for (halving = 0; halving < HALVINGS; halving++, factor /= 2) {
            for (k = 0; k < period; k++) {
                for (i = 0; i < d; i++) trial[k * d + i] = points[k * d + i] + factor * delta[k][i];
                jlt_chart_wrap(chart, trial + k * d);
            }
            st = shoot(map, &then, trial, period);
            if (st == JLT_OK && then.residual < now.residual) break;
        }
        if (halving == HALVINGS) break;
        memcpy(points, trial, sizeof *points * period * d);
        const shooting last = now;
        now = then;
        then = last;
    }
    st = now.residual <= fmin(accepted * now.scale, accepted_most) ? JLT_OK : st != JLT_OK ? st : JLT_ERR_NO_CONVERGENCE;
done:
    free(now.slopes);
    free(then.slopes);
    return st;
}

static size_t primitive(const jlt_chart *chart, const double *points, size_t period)
{
    size_t p;

    for (p = 1; p < period; p++)
        if (period % p == 0 && jlt_chart_distance(chart, points, points + p * chart->dim) < same_point) return p;
    return period;
}

static bool is_symmetric(const jlt_chart *chart, const double *points, size_t period)
{
    double image[D];
    size_t k;

    if (!chart->reversible) return false;
    jlt_chart_mirror(chart, image, points);
    for (k = 0; k < period; k++)
        if (jlt_chart_distance(chart, image, points + k * chart->dim) < same_point) return true;
    return false;
}

static jlt_orbit_type classify(const double *re, const double *im, unsigned d)
{
    unsigned i, inside = 0, outside = 0;

    for (i = 0; i < d; i++) {
        const double modulus = hypot(re[i], im[i]);
        if (fabs(fabs(re[i]) - 1) < degenerate && fabs(im[i]) < degenerate) return JLT_ORBIT_DEGENERATE;
        if (modulus < 1 - degenerate) inside++;
        else if (modulus > 1 + degenerate) outside++;
    }
    if (inside == d) return JLT_ORBIT_ATTRACTING;
    if (outside == d) return JLT_ORBIT_REPELLING;
    if (inside == 0 && outside == 0) return JLT_ORBIT_CENTRE;
    return im[0] == 0 && re[0] < 0 ? JLT_ORBIT_FLIP_SADDLE : JLT_ORBIT_SADDLE;
}

jlt_status jlt_periodic_measure(jlt_map *map, jlt_periodic *io)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    const unsigned d = chart->dim;
    jlt_periodic orbit = *io;
    shooting at = { 0 };
    double *slope;
    unsigned i;
    size_t k;
    jlt_status st = JLT_OK;

    if (io->period == 0 || io->period > JLT_PERIODIC_MAX) return JLT_ERR_ARG;
    JLT_TRY(make_room(&at, d, orbit.period));
    JLT_TRY(shoot(map, &at, orbit.points, orbit.period));
    slope = at.slopes; /* of the whole orbit, in place of the first return's */
    for (k = 1; k < orbit.period; k++) jlt_linear_multiply(slope, at.slopes + k * d * d, slope, d);
    if (d == 2) memcpy(orbit.slope, slope, sizeof orbit.slope);
    for (orbit.trace = 0, i = 0; i < d; i++) orbit.trace += slope[i * d + i];
    orbit.T = at.T;
    orbit.residual = at.residual;
    orbit.defect = at.defect;
    orbit.determinant = exp(at.expansion);
    orbit.determinant_slope = at.determinant;
    JLT_TRY(jlt_linear_eigenvalues(orbit.re, orbit.im, slope, d));
    /* The smaller of two real multipliers keeps its digits through the determinant. */
    if (d == 2 && orbit.im[0] == 0 && orbit.re[0] != 0) orbit.re[1] = orbit.determinant / orbit.re[0];
    orbit.symmetric = is_symmetric(chart, orbit.points, orbit.period);
    orbit.type = classify(orbit.re, orbit.im, d);
    *io = orbit;
done:
    free(at.slopes);
    return st;
}

/* Where the flow is tangent to the section an orbit that starts there returns at once, and every such point looks fixed:
 * the way |f| T of a true orbit is not small. */
static bool moves(jlt_map *map, const jlt_periodic *orbit)
{
    const jlt_flow *flow = jlt_map_flow(map);
    double x[JLT_CHART_STATES_MAX], f[JLT_CHART_STATES_MAX], rate = 1;

    if (flow->chart->lift(flow->chart, x, NULL, orbit->points) != JLT_OK) return false;
    flow->field->call(x, flow->field->p, f);
    if (flow->field->time_rate != NULL) flow->field->time_rate(x, flow->field->p, &rate);
    return norm(f, flow->chart->states) / rate * ldexp(orbit->T, -flow->units.time) / (double)orbit->period >
           standstill * fmax(1, norm(x, flow->chart->states));
}

jlt_status jlt_periodic_find(jlt_map *map, jlt_periodic *out, const double *q, size_t period,
                             const unsigned char *held)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    const unsigned d = chart->dim;
    jlt_periodic orbit = { .period = period };
    jlt_image image;
    jlt_status st = JLT_OK;
    size_t k;

    if (period == 0 || period > JLT_PERIODIC_MAX) return JLT_ERR_ARG;
    memcpy(orbit.points, q, d * sizeof *q);
    for (k = 0; k + 1 < period; k++) {
        JLT_TRY(jlt_map_point(map, &image, orbit.points + k * d, 1, 1));
        memcpy(orbit.points + (k + 1) * d, image.q, d * sizeof *q);
    }
    JLT_TRY(iterate(map, orbit.points, period, held));
    orbit.period = primitive(chart, orbit.points, period);
    JLT_TRY(jlt_periodic_measure(map, &orbit));
    st = moves(map, &orbit) ? JLT_OK : JLT_ERR_NO_CONVERGENCE;
    if (st == JLT_OK) *out = orbit;
done:
    return st;
}

jlt_status jlt_periodic_rotate(jlt_map *map, jlt_periodic *io, size_t first)
{
    const unsigned d = jlt_map_flow(map)->chart->dim;
    jlt_periodic orbit = *io;
    jlt_status st;
    size_t k;

    if (first >= io->period) return JLT_ERR_ARG;
    for (k = 0; k < io->period; k++)
        memcpy(orbit.points + k * d, io->points + (k + first) % io->period * d, d * sizeof *orbit.points);
    st = jlt_periodic_measure(map, &orbit);
    if (st == JLT_OK) *io = orbit;
    return st;
}

bool jlt_periodic_same(const jlt_chart *chart, const jlt_periodic *a, const jlt_periodic *b, double distance)
{
    size_t k;

    if (a->period != b->period) return false;
    for (k = 0; k < a->period; k++)
        if (jlt_chart_distance(chart, a->points + k * chart->dim, b->points) < distance) return true;
    return false;
}
