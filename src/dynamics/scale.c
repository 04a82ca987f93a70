#include "dynamics/scale.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"

enum { SAMPLES = 16 };

static const double pi = 3.14159265358979323846;
static const double ordinary = 64; /* sizes that differ from 1 by no more than this factor count as 1 */

/* The binary exponent of a size; 0 for sizes that count as 1, and for unknown ones. */
static int exponent_of(double size)
{
    return !(size > 0) || !isfinite(size) || (size >= 1 / ordinary && size <= ordinary) ? 0 : ilogb(size);
}

jlt_status jlt_scale_moves(double *out, jlt_map *map, const double *q)
{
    const jlt_flow *flow = jlt_map_flow(map);
    const jlt_chart *chart = flow->chart;
    const unsigned dim = chart->dim;
    double at[JLT_CHART_DIM_MAX + 1], low[JLT_CHART_DIM_MAX + 1], high[JLT_CHART_DIM_MAX + 1], times[SAMPLES];
    JLT_FREED double *x = jlt_memory_array(SAMPLES + 1, chart->states * sizeof *x);
    jlt_orbit *orbit = NULL;
    jlt_image image;
    size_t done = 0;
    jlt_status st = x != NULL ? jlt_map_point(map, &image, q, 1, 1) : JLT_ERR_NOMEM;

    if (st == JLT_OK) st = jlt_orbit_create(&orbit, flow->method, flow->field, &(jlt_options){ .tolerance = flow->tolerance });
    if (st == JLT_OK) st = chart->lift(chart, x, NULL, q);
    if (st == JLT_OK) st = jlt_orbit_start(orbit, 0, x, 1);
    for (unsigned i = 0; st == JLT_OK && i < SAMPLES; i++) times[i] = ldexp(image.T, -flow->units.time) * (i + 1) / SAMPLES;
    if (st == JLT_OK) st = jlt_orbit_sample(orbit, x + chart->states, &done, times, SAMPLES);
    for (unsigned k = 0; k <= dim; k++) low[k] = INFINITY, high[k] = -INFINITY;
    for (size_t i = 0; st == JLT_OK && i <= done; i++) {
        chart->lower(chart, at, NULL, x + i * chart->states);
        at[dim] = x[i * chart->states + chart->column];
        for (unsigned k = 0; k <= dim; k++) low[k] = fmin(low[k], at[k]), high[k] = fmax(high[k], at[k]);
    }
    for (unsigned k = 0; st == JLT_OK && k <= dim; k++) out[k] = (high[k] - low[k]) / 2;
    jlt_orbit_destroy(orbit);
    return st;
}

static int ascending(const void *left, const void *right)
{
    const double a = *(const double *)left, b = *(const double *)right;

    return (a > b) - (a < b);
}

/* The median of column k of rows of this width, 0 where it is at most `noise`; column: workspace, shape (count,). */
static double median(double *column, const double *rows, size_t count, unsigned width, unsigned k, double noise)
{
    if (count == 0) return 0;
    for (size_t i = 0; i < count; i++) column[i] = rows[i * width + k];
    qsort(column, count, sizeof *column, ascending);
    return column[count / 2] > noise ? column[count / 2] : 0;
}

jlt_status jlt_scale_find(jlt_system *system, const double *starts, size_t count, const double *extents)
{
    jlt_chart *chart = system->chart_base;
    const unsigned dim = chart->dim, width = dim + 1;
    JLT_FREED double *rows = jlt_memory_array(count + 1, width * sizeof *rows);
    JLT_FREED double *column = jlt_memory_array(count + 1, sizeof *column);
    jlt_map *map = NULL;
    const double tolerance = system->flow.tolerance != 0 ? system->flow.tolerance : JLT_ORBIT_TOLERANCE;
    double largest = 0; /* of all sizes; and of one start, in units of the flow */
    size_t known = 0;
    jlt_status st = rows != NULL && column != NULL ? jlt_map_create(&map, &system->flow) : JLT_ERR_NOMEM;

    for (size_t i = 0; st == JLT_OK && i < count; i++) {
        st = jlt_scale_moves(rows + known * width, map, starts + i * dim);
        known += st == JLT_OK;
        if (st != JLT_ERR_NOMEM) st = JLT_OK;
    }
    for (unsigned k = 0; st == JLT_OK && k <= dim; k++) {
        const double place = k == dim ? 0 : extents != NULL ? extents[k] : fabs(starts[k]);
        if ((k < dim ? chart->period[k] : chart->turn) != 0) continue;
        largest = fmax(largest, ldexp(fmax(median(column, rows, known, width, k, 0), place), k < dim ? -chart->unit[k] : 0));
    }
    const double least = extents != NULL ? 0 : largest > 0 && largest < 1 / ordinary ? largest : 1;
    for (unsigned k = 0; st == JLT_OK && k <= dim; k++) {
        const double period = k < dim ? chart->period[k] : chart->turn;
        const int unit = k < dim ? chart->unit[k] : 0;
        const double noise = ldexp(10 * tolerance * (extents != NULL && k < dim ? 1 : fmin(largest, 1)), unit);
        const double moved = median(column, rows, known, width, k, noise);
        const double size = period != 0 ? period / (2 * pi) : extents != NULL && k < dim ? fmax(moved, extents[k]) : moved;
        const double counted = ldexp(size, -unit);
        const int exponent = unit + exponent_of(period != 0 ? counted : fmax(counted, least));
        if (k < dim) chart->scale[k] = exponent;
        else chart->column_scale = exponent;
    }
    jlt_map_destroy(map);
    return st;
}

/* The Frobenius norm of a slope, shape (dim, dim), between coordinates counted in units of these exponents. */
static double norm(const double *slope, const int *exponent, unsigned dim)
{
    double length = 0;

    for (unsigned i = 0; i < dim; i++)
        for (unsigned j = 0; j < dim; j++) length = hypot(length, ldexp(slope[i * dim + j], exponent[j] - exponent[i]));
    return length;
}

jlt_status jlt_scale_for_tangents(jlt_system *system, const double *q)
{
    jlt_chart *chart = system->chart_base;
    int unit[JLT_CHART_DIM_MAX];
    jlt_map *map;
    jlt_image image;

    JLT_PASS(jlt_map_create(&map, &system->flow));
    const jlt_status st = jlt_map_apply(map, &image, q, 1, 1);
    jlt_map_destroy(map);
    for (unsigned k = 0; k < chart->dim; k++) unit[k] = chart->period[k] != 0 ? chart->scale[k] : chart->unit[k];
    if (st == JLT_OK && norm(image.slope, chart->scale, chart->dim) > ordinary * norm(image.slope, unit, chart->dim))
        memcpy(chart->scale, unit, chart->dim * sizeof *unit);
    return st == JLT_ERR_NOMEM ? st : JLT_OK;
}

void jlt_scale_copy(jlt_system *system, const jlt_system *from)
{
    memcpy(system->chart_base->scale, from->chart_base->scale, sizeof from->chart_base->scale);
    system->chart_base->column_scale = from->chart_base->column_scale;
}
