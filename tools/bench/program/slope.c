/* Measures the cost and error of the return map's derivative by each method, at each tolerance. */
#include "bench.h"

#include <math.h>
#include <string.h>

#include "dynamics/map_batch.h"
#include "dynamics/surface.h"
#include "integrate/batch_method.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
#include "top/top.h"

/* The reference has rows orbit, eta, gamma3, image (2), time, DP (2, 2). */
enum { COLUMNS = 10, START = 1, SLOPE = 6 };

/* Computes DP at q; h is the step of methods by differences. */
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

/* The step factor * tolerance^exponent balances the error of the map against the truncation error of the difference. */
static const struct {
    const char *name;
    derivative of;
    double factor, exponent;
} ways[] = { { "variational", variational, 0, 0 }, { "central", central, 0.3, 1. / 3 }, { "forward", forward, 0.1, 1. / 2 } };

typedef struct {
    jlt_map *map;
    jlt_map_batch *batch;
    jlt_map_images images; /* of the batch */
    derivative of;
    double step, error;
    const jlt_bench_table *reference;
    size_t failed;
} slope_run;

/* Compare DP at a start with the reference, relative to its largest entry. */
static void note(slope_run *run, const double *row, const double *slope, jlt_status st)
{
    double size = 0, off = 0;

    for (int k = 0; k < 4; k++) {
        size = fmax(size, fabs(row[SLOPE + k]));
        off = fmax(off, fabs(slope[k] - row[SLOPE + k]));
    }
    run->failed += st != JLT_OK;
    if (st != JLT_OK) run->error = NAN;
    else if (!(off / size <= run->error)) run->error = off / size;
}

static jlt_status pass(void *context, bool first)
{
    slope_run *run = context;

    for (size_t i = 0; i < run->reference->rows; i++) {
        const double *row = run->reference->values + i * COLUMNS;
        double slope[4];
        const jlt_status st = run->of(run->map, slope, row + START, run->step);
        if (st == JLT_ERR_NOMEM) return st;
        if (first) note(run, row, slope, st);
    }
    return JLT_OK;
}

static jlt_status batch_pass(void *context, bool first)
{
    slope_run *run = context;
    const size_t rows = run->reference->rows;
    jlt_map_images *images = &run->images;

    for (size_t i = 0; i < rows; i++)
        memcpy(images->q + 2 * i, run->reference->values + i * COLUMNS + START, 2 * sizeof *images->q);
    const jlt_status st = jlt_map_batch_apply(run->batch, images, images->q, rows, 1, 1);
    for (size_t i = 0; first && st == JLT_OK && i < rows; i++)
        note(run, run->reference->values + i * COLUMNS, images->slope + 4 * i, images->status[i]);
    return st;
}

static void write_row(FILE *table, const char *method, const char *way, double tolerance, const slope_run *run,
                      const jlt_bench_time *time)
{
    const double unit = 1e6 / (double)run->reference->rows;

    fprintf(table, "jellett,%s,%s,1,%g", method, way, tolerance);
    jlt_bench_number(table, "%.3e", run->error);
    fprintf(table, ",%.4g,%.4g,%.4g,%zu\n", unit * time->median, unit * time->least, unit * time->largest, run->failed);
}

/* Make the system of (5.1) on the section that its tables describe. */
static jlt_status open_system(jlt_system **out, jlt_surface *surface, const jlt_flow *flow)
{
    const jlt_claim *broken;
    const jlt_status st = jlt_surface_find(surface, &broken, jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL), NULL, NULL);

    return st != JLT_OK ? st : jlt_surface_system(out, surface, surface->defaults, flow);
}

static jlt_status measure_batch(FILE *table, const jlt_bench_options *options, const jlt_bench_table *reference,
                                const jlt_batch_method *method, size_t isa, double tolerance)
{
    jlt_status st = JLT_OK;
    const jlt_flow flow = { .tolerance = tolerance, .direction = JLT_RISING };
    jlt_system *system = NULL;
    jlt_surface surface;
    slope_run run = { .reference = reference };
    jlt_bench_time time;
    char name[64];

    JLT_TRY(open_system(&system, &surface, &flow));
    const jlt_kernel_batch *kernels = system->instance->descriptor->batches[isa];
    if (!jlt_batch_isa_runs(kernels)) goto done;
    JLT_TRY(jlt_map_batch_images(&run.images, 2, reference->rows));
    JLT_TRY(jlt_map_batch_create(&run.batch, &system->flow, kernels, method, 1));
    JLT_TRY(jlt_bench_clock(&time, options->repeats, 1, batch_pass, &run));
    snprintf(name, sizeof name, "%s %sx%u", method->name, kernels->isa, kernels->lanes);
    write_row(table, name, "variational", tolerance, &run, &time);
done:
    jlt_map_batch_destroy(run.batch);
    jlt_map_batch_images_clear(&run.images);
    jlt_system_destroy(system);
    return st;
}

static jlt_status measure(FILE *table, const jlt_bench_options *options, const jlt_bench_table *reference, const jlt_method *method,
                          size_t way, double tolerance)
{
    jlt_status st = JLT_OK;
    const jlt_flow flow = { .method = method, .tolerance = tolerance, .direction = JLT_RISING };
    jlt_system *system = NULL;
    jlt_surface surface;
    slope_run run = { .of = ways[way].of, .step = ways[way].factor * pow(tolerance, ways[way].exponent), .reference = reference };
    jlt_bench_time time;

    JLT_TRY(open_system(&system, &surface, &flow));
    JLT_TRY(jlt_map_create(&run.map, &system->flow));
    JLT_TRY(jlt_bench_clock(&time, options->repeats, 1, pass, &run));
    write_row(table, method->name, ways[way].name, tolerance, &run, &time);
done:
    jlt_map_destroy(run.map);
    jlt_system_destroy(system);
    return st;
}

/* Write the rows of one method for single orbits, for each way to DP and each tolerance. */
static jlt_exit run_single(FILE *table, const jlt_bench_options *options, const jlt_bench_table *reference,
                           const jlt_method *method)
{
    double tolerance;

    for (size_t way = 0; way < sizeof ways / sizeof *ways; way++) {
        if (method->needs_jet && ways[way].of == variational) continue; /* jlt_map would use another method */
        for (size_t k = 0; (tolerance = jlt_bench_tolerance(options, k)) > 0; k++) {
            const jlt_status st = measure(table, options, reference, method, way, tolerance);
            if (st != JLT_OK) return jlt_command_fail(jlt_command_exit(st), "%s: %s", method->name, jlt_status_text(st));
        }
    }
    return JLT_EXIT_DONE;
}

/* Write the rows of one batch method on all instruction sets that run here. */
static jlt_exit run_batch(FILE *table, const jlt_bench_options *options, const jlt_bench_table *reference,
                          const jlt_batch_method *method)
{
    double tolerance;

    for (size_t isa = 0; isa < JLT_ISA_COUNT; isa++)
        for (size_t k = 0; (tolerance = jlt_bench_tolerance(options, k)) > 0; k++) {
            const jlt_status st = measure_batch(table, options, reference, method, isa, tolerance);
            if (st != JLT_OK) return jlt_command_fail(jlt_command_exit(st), "%s: %s", method->name, jlt_status_text(st));
        }
    return JLT_EXIT_DONE;
}

static bool wanted(const jlt_bench_options *options, const char *method)
{
    return options->method == NULL || strcmp(method, options->method) == 0;
}

static jlt_exit run(FILE *table, const jlt_bench_options *options)
{
    jlt_bench_table reference = { 0 };
    const jlt_batch_method *batch;
    const jlt_method *method;
    jlt_exit code = JLT_EXIT_DONE;

    const jlt_status read = jlt_bench_read(&reference, options->reference, COLUMNS);
    if (read != JLT_OK) code = jlt_bench_unread(options->reference, read);
    for (size_t i = 0; code == JLT_EXIT_DONE && (method = jlt_method_at(i)) != NULL; i++) {
        if (options->list) fprintf(table, "%s\n", method->name);
        else if (wanted(options, method->name)) code = run_single(table, options, &reference, method);
    }
    for (size_t i = 0; code == JLT_EXIT_DONE && (batch = jlt_batch_method_at(i)) != NULL; i++) {
        if (options->list) fprintf(table, "%s\n", batch->name);
        else if (wanted(options, batch->name)) code = run_batch(table, options, &reference, batch);
    }
    jlt_bench_clear(&reference);
    return code;
}

const jlt_bench_kind jlt_bench_slope = {
    "slope",
    "derivative DP of the section map at (5.1) by the variational\n    equations and by differences; error relative to its largest "
    "entry",
    "program,method,form,threads,tolerance,error,us_per_derivative,us_least,us_largest,failed", "rmkqlo", run,
};
