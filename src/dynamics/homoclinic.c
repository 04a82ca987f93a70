#include "dynamics/homoclinic.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* Segments p + a u and r + b w meet at a, b in [0, 1]. */
static bool segments_cross(const jlt_chart *chart, double *a, double *b, const double *p, const double *p_next,
                           const double *r, const double *r_next)
{
    double u[2], w[2], gap[2], cross;

    jlt_chart_difference(chart, u, p_next, p);
    jlt_chart_difference(chart, w, r_next, r);
    jlt_chart_difference(chart, gap, r, p);
    cross = u[0] * w[1] - u[1] * w[0];
    if (cross == 0) return false;
    *a = (gap[0] * w[1] - gap[1] * w[0]) / cross;
    *b = (gap[0] * u[1] - gap[1] * u[0]) / cross;
    return *a >= 0 && *a < 1 && *b >= 0 && *b < 1;
}

/* Newton on gamma_u(sigma_u) = gamma_s(sigma_s). Fills q, angle, residual, both sigmas. */
static jlt_status refine(jlt_homoclinic *io, const jlt_branch *unstable, const jlt_branch *stable, int iterations)
{
    const jlt_chart *chart = jlt_map_flow(unstable->map)->chart;
    double u[2], s[2], du[2], ds[2], gap[2], cross;
    jlt_homoclinic best = *io;
    double su = io->sigma_unstable, ss = io->sigma_stable;
    jlt_status st;
    int i;

    best.residual = INFINITY;
    for (i = 0; i < iterations; i++) {
        st = jlt_branch_point(unstable, u, du, su);
        if (st == JLT_OK) st = jlt_branch_point(stable, s, ds, ss);
        if (st != JLT_OK) return st;
        jlt_chart_difference(chart, gap, s, u);
        if (!(hypot(gap[0], gap[1]) < best.residual)) break;
        cross = du[0] * ds[1] - du[1] * ds[0];
        best.residual = hypot(gap[0], gap[1]);
        best.sigma_unstable = su;
        best.sigma_stable = ss;
        memcpy(best.q, u, sizeof u);
        best.angle = atan2(cross, du[0] * ds[0] + du[1] * ds[1]);
        if (best.angle > pi / 2) best.angle -= pi;
        if (best.angle <= -pi / 2) best.angle += pi;
        /* u + du x = s + ds y */
        su += (gap[0] * ds[1] - gap[1] * ds[0]) / cross;
        ss += (gap[0] * du[1] - gap[1] * du[0]) / cross;
        if (!(su >= 0 && ss >= 0 && isfinite(su) && isfinite(ss))) break;
    }
    if (!isfinite(best.residual)) return JLT_ERR_NO_CONVERGENCE;
    *io = best;
    return JLT_OK;
}

/* The same crossing by another map, from branches whose seeds are so many times as large: sigma moves by the logarithm. */
static double angle_again(const jlt_homoclinic *point, const jlt_branch *unstable, const jlt_branch *stable, jlt_map *map,
                          double seeds)
{
    jlt_branch u = *unstable, s = *stable;
    jlt_homoclinic other = *point;

    u.map = s.map = map;
    u.seed *= seeds;
    s.seed *= seeds;
    other.sigma_unstable -= log(seeds) / log(u.lambda);
    other.sigma_stable -= log(seeds) / log(s.lambda);
    if (other.sigma_unstable < 0 || other.sigma_stable < 0) return NAN;
    return refine(&other, &u, &s, 8) == JLT_OK ? other.angle : NAN;
}

/* Twice the largest change by another tolerance, another seed, and both: where all that is left is rounding, one of them alone may
 * happen to change little. */
static double angle_error(const jlt_homoclinic *point, const jlt_branch *unstable, const jlt_branch *stable, jlt_map *coarse)
{
    const double others[] = { angle_again(point, unstable, stable, coarse, 2), angle_again(point, unstable, stable, coarse, 1),
                              angle_again(point, unstable, stable, unstable->map, 2) };
    double largest = 0;

    for (int i = 0; i < 3; i++) {
        const double change = fabs(remainder(others[i] - point->angle, pi));
        if (isnan(change) || change > largest) largest = change;
    }
    return 2 * largest;
}

static int compare(const void *left, const void *right)
{
    const jlt_homoclinic *a = left, *b = right;

    return a->sigma_unstable < b->sigma_unstable ? -1 : a->sigma_unstable > b->sigma_unstable;
}

/* Integral of (x dy - y dx)/2 along a polygon from one parameter to another, relative to `origin`. */
static double swept(const jlt_manifold *curve, const jlt_chart *chart, const double *origin, const double *start,
                    double sigma_start, const double *end, double sigma_end)
{
    const bool forwards = sigma_end > sigma_start;
    const double low = fmin(sigma_start, sigma_end), high = fmax(sigma_start, sigma_end);
    double last[2], now[2], sum = 0;
    size_t i, k;

    jlt_chart_difference(chart, last, start, origin);
    for (k = 0; k <= curve->count; k++) {
        const double *q = end;
        if (k < curve->count) {
            i = forwards ? k : curve->count - 1 - k;
            if (curve->sigma[i] <= low || curve->sigma[i] >= high) continue;
            q = curve->points + 2 * i;
        }
        jlt_chart_difference(chart, now, q, origin);
        sum += (last[0] * now[1] - last[1] * now[0]) / 2;
        memcpy(last, now, sizeof last);
    }
    return sum;
}

static void measure_lobes(jlt_homoclinic *points, size_t count, const jlt_manifold *unstable, const jlt_manifold *stable,
                          const jlt_chart *chart)
{
    size_t i;

    for (i = 0; i < count; i++) {
        const jlt_homoclinic *a = &points[i], *b = &points[i + 1 < count ? i + 1 : i];
        points[i].lobe = NAN;
        if (a == b) continue;
        points[i].lobe = swept(unstable, chart, a->q, a->q, a->sigma_unstable, b->q, b->sigma_unstable) +
                         swept(stable, chart, a->q, b->q, b->sigma_stable, a->q, a->sigma_stable);
    }
}

typedef struct {
    jlt_homoclinic *points;
    size_t count, capacity;
} found_list;

/* How far along the branches a point may lie from where it is: they leave each other by the angle. */
static double blur(const jlt_homoclinic *point) { return point->residual / fabs(sin(point->angle)); }

/* As far as the residuals of both tell. */
static bool is_same(const jlt_homoclinic *a, const jlt_homoclinic *b, const jlt_chart *chart)
{
    const double along = fmax(fabs(a->sigma_unstable - b->sigma_unstable), fabs(a->sigma_stable - b->sigma_stable));

    return along < 1e-7 || (along < 1 && jlt_chart_distance(chart, a->q, b->q) < blur(a) + blur(b));
}

static jlt_status push(found_list *list, const jlt_homoclinic *point, const jlt_chart *chart)
{
    size_t i;

    for (i = 0; i < list->count; i++)
        if (is_same(&list->points[i], point, chart)) return JLT_OK;
    if (list->count == list->capacity) {
        const size_t capacity = list->capacity == 0 ? 16 : 2 * list->capacity;
        jlt_homoclinic *grown = realloc(list->points, capacity * sizeof *grown);
        if (grown == NULL) return JLT_ERR_NOMEM;
        list->points = grown;
        list->capacity = capacity;
    }
    list->points[list->count++] = *point;
    return JLT_OK;
}

jlt_status jlt_homoclinic_find(jlt_homoclinic **points, size_t *count, size_t *touching, const jlt_manifold *unstable,
                               const jlt_branch *unstable_branch, const jlt_manifold *stable,
                               const jlt_branch *stable_branch, jlt_map *coarse)
{
    const jlt_chart *chart = jlt_map_flow(unstable_branch->map)->chart;
    found_list list = { .count = 0 };
    jlt_status st = JLT_OK;
    size_t i, j;

    *points = NULL;
    *count = 0;
    if (touching != NULL) *touching = 0;
    for (i = 0; i + 1 < unstable->count; i++)
        for (j = 0; j + 1 < stable->count; j++) {
            jlt_homoclinic point = { .lobe = NAN };
            double a, b;
            if (!segments_cross(chart, &a, &b, unstable->points + 2 * i, unstable->points + 2 * i + 2,
                                stable->points + 2 * j, stable->points + 2 * j + 2)) continue;
            point.sigma_unstable = unstable->sigma[i] + a * (unstable->sigma[i + 1] - unstable->sigma[i]);
            point.sigma_stable = stable->sigma[j] + b * (stable->sigma[j + 1] - stable->sigma[j]);
            st = refine(&point, unstable_branch, stable_branch, 12);
            if (st == JLT_ERR_NOMEM) goto done;
            if (st != JLT_OK || point.residual > 1e-8) continue;
            point.angle_error = angle_error(&point, unstable_branch, stable_branch, coarse);
            if (!(fabs(point.angle) <= point.angle_error) && blur(&point) < JLT_MANIFOLD_FINEST) JLT_TRY(push(&list, &point, chart));
            else if (touching != NULL) ++*touching;
        }
    st = JLT_OK;
    if (list.count > 1) qsort(list.points, list.count, sizeof *list.points, compare);
    measure_lobes(list.points, list.count, unstable, stable, chart);
    *points = list.points;
    *count = list.count;
    list.points = NULL;
done:
    free(list.points);
    return st;
}
