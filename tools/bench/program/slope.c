#include "bench.h"

#include <math.h>
#include <string.h>

#include "dynamics/map.h"
#include "dynamics/surface.h"
#include "kernel/descriptor.h"
#include "top/top.h"

/* A reference has rows orbit, eta, gamma3, image (2), time, DP (2, 2). */
enum { COLUMNS = 10, START = 1, SLOPE = 6 };

/* DP at q with differences of step h. */
typedef jlt_status (*derivative)(jlt_map *map, double *slope, const double *q, double h);

static jlt_status variational(jlt_map *map, double *slope, const double *q, double h)
{
    jlt_image image;
    const jlt_status st = jlt_map_apply(map, &image, q, 1, 1);

    (void)h;
    if (st == JLT_OK) memcpy(slope, image.slope, 4 * sizeof *slope);
    return st;
}

/* (P(q + up e_j) - P(q - down e_j))/(up + down) by columns j. */
static jlt_status differences(jlt_map *map, double *slope, const double *q, double up, double down)
{
    jlt_status st = JLT_OK;
    jlt_image there = { 0 }, back = { 0 };

    if (down == 0) JLT_TRY(jlt_map_point(map, &back, q, 1, 1));
    for (int j = 0; j < 2; j++) {
        double moved[2] = { q[0], q[1] };
        moved[j] = q[j] + up;
        const double high = moved[j];
        JLT_TRY(jlt_map_point(map, &there, moved, 1, 1));
        moved[j] = q[j] - down;
        if (down > 0) JLT_TRY(jlt_map_point(map, &back, moved, 1, 1));
        for (int i = 0; i < 2; i++) slope[2 * i + j] = (there.q[i] - back.q[i]) / (high - moved[j]);
    }
done:
    return st;
}

static jlt_status central(jlt_map *map, double *slope, const double *q, double h)
{
    return differences(map, slope, q, h, h);
}

static jlt_status forward(jlt_map *map, double *slope, const double *q, double h)
{
    return differences(map, slope, q, h, 0);
}

/* Steps factor * tolerance^exponent balance the error of the map against that of the difference. */
static const struct {
    const char *name;
    derivative of;
    double factor, exponent;
} ways[] = { { "variational", variational, 0, 0 }, { "central", central, 0.3, 1. / 3 }, { "forward", forward, 0.1, 1. / 2 } };

typedef struct {
    jlt_map *map;
    derivative of;
    double step, error;
    const jlt_bench_table *reference;
    size_t failed;
} slope_run;

static jlt_status pass(void *context, bool first)
{
    slope_run *run = context;

    for (size_t i = 0; i < run->reference->rows; i++) {
        const double *row = run->reference->values + i * COLUMNS;
        double slope[4], size = 0, off = 0;
        const jlt_status st = run->of(run->map, slope, row + START, run->step);
        if (st == JLT_ERR_NOMEM) return st;
        if (!first) continue;
        for (int k = 0; k < 4; k++) {
            size = fmax(size, fabs(row[SLOPE + k]));
            off = fmax(off, fabs(slope[k] - row[SLOPE + k]));
        }
        run->failed += st != JLT_OK;
        if (st != JLT_OK) run->error = NAN;
        else if (!(off / size <= run->error)) run->error = off / size;
    }
    return JLT_OK;
}

static jlt_status measure(FILE *table, const jlt_bench_options *options, const jlt_bench_table *reference, const jlt_method *method,
                          size_t way, double tolerance)
{
    jlt_status st = JLT_OK;
    const jlt_flow flow = { .method = method, .tolerance = tolerance, .direction = JLT_RISING };
    jlt_system *system = NULL;
    jlt_surface surface;
    const jlt_claim *broken;
    slope_run run = { .of = ways[way].of, .step = ways[way].factor * pow(tolerance, ways[way].exponent), .reference = reference };
    jlt_bench_time time;

    JLT_TRY(jlt_surface_find(&surface, &broken, jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL), NULL));
    JLT_TRY(jlt_surface_system(&system, &surface, surface.defaults, &flow));
    JLT_TRY(jlt_map_create(&run.map, &system->flow));
    JLT_TRY(jlt_bench_clock(&time, options->repeats, 1, pass, &run));
    const double unit = 1e6 / (double)reference->rows;
    fprintf(table, "jellett,%s,%s,1,%g", method->name, ways[way].name, tolerance);
    jlt_bench_number(table, "%.3e", run.error);
    fprintf(table, ",%.4g,%.4g,%.4g,%zu\n", unit * time.median, unit * time.least, unit * time.largest, run.failed);
done:
    jlt_map_destroy(run.map);
    jlt_system_destroy(system);
    return st;
}

static jlt_exit run(FILE *table, const jlt_bench_options *options)
{
    jlt_bench_table reference = { 0 };
    const jlt_method *method;
    jlt_exit code = JLT_EXIT_DONE;

    const jlt_status read = jlt_bench_read(&reference, options->reference, COLUMNS);
    if (read != JLT_OK) code = jlt_bench_unread(options->reference, read);
    for (size_t i = 0; code == JLT_EXIT_DONE && (method = jlt_method_at(i)) != NULL; i++) {
        if (options->list) fprintf(table, "%s\n", method->name);
        if (options->list) continue;
        if (options->method != NULL && strcmp(method->name, options->method) != 0) continue;
        for (size_t way = 0; way < sizeof ways / sizeof *ways && code == JLT_EXIT_DONE; way++) {
            double tolerance;
            if (method->needs_jet && ways[way].of == variational) continue; /* the map would take another method */
            for (size_t k = 0; code == JLT_EXIT_DONE && (tolerance = jlt_bench_tolerance(options, k)) > 0; k++) {
                const jlt_status st = measure(table, options, &reference, method, way, tolerance);
                if (st != JLT_OK) code = jlt_command_fail(jlt_command_exit(st), "%s: %s", method->name, jlt_status_text(st));
            }
        }
    }
    jlt_bench_clear(&reference);
    return code;
}

const jlt_bench_kind jlt_bench_slope = {
    "slope", "derivative DP of the section map at (5.1) by the variational equations and by differences; error relative to its largest entry",
    "program,method,form,threads,tolerance,error,us_per_derivative,us_least,us_largest,failed", true, false, true, run,
};
