/* Measures the cost of one orbit, and the error of its states, in each tier that serves it. */
#include "bench.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "scene/course.h"
#include "top/top.h"

enum { COLUMNS = 1 + JLT_TOP_STATES, PARAMS = 6, ROUNDS = 20 };

/* Orbits whose true states at some times are in files of the folder --reference. */
static const struct {
    const char *name, *file;
    double params[PARAMS]; /* m, R, g, a3, I1, I3 */
    size_t rows;           /* rows of the file to use, with the start: those before a pole */
} scenes[] = {
    { "rod", "flow_rod.csv", { 1, 1, 1, 0.3, 0.7, 0 }, 4 },
    { "balanced", "flow_balanced.csv", { 1, 1, 1, 0, 0.4, 0.25 }, 4 },
    { "generic", "flow_generic.csv", { 1.3, 0.7, 9.81, -0.12, 0.29, 0.21 }, 3 },
};

/* The computation of one orbit's states at all times, in one tier. */
typedef struct {
    jlt_plan plan;
    jlt_question question;
    jlt_course_options options;
    const double *rows;
    size_t count;
    double error;
    size_t steps, evaluations;
} tier_run;

static jlt_status follow(tier_run *run, bool first)
{
    jlt_status st = JLT_OK;
    jlt_course *course = NULL;
    jlt_course_row row;

    JLT_TRY(jlt_course_create(&course, &run->plan, &run->question, &run->options));
    for (size_t i = 1; i < run->count; i++) {
        const double *expected = run->rows + i * COLUMNS;
        JLT_TRY(jlt_course_to(course, expected[0], &row));
        for (size_t k = 0; first && k < JLT_TOP_STATES; k++) {
            const double off = fabs(row.x[k] - expected[1 + k]);
            if (!(off <= run->error)) run->error = off;
        }
    }
    jlt_course_cost(course, &run->steps, &run->evaluations);
done:
    jlt_course_destroy(course);
    return st;
}

static jlt_status pass(void *context, bool first)
{
    jlt_status st = JLT_OK;

    for (int i = 0; i < ROUNDS && st == JLT_OK; i++) st = follow(context, first && i == 0);
    return st;
}

/* Write a row for every tier that serves. Its fields are empty if the tier fails, as those with an eliminated angular velocity do
 * near the points where their integral does not depend on it. */
static jlt_status run_scene(FILE *table, const jlt_bench_options *options, size_t scene, const double *rows, double tolerance)
{
    const jlt_descriptor *model = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    jlt_tier tiers[JLT_TIERS_MAX];
    const unsigned count = jlt_tier_list(tiers, model, NULL);
    jlt_status st = JLT_OK;

    for (unsigned i = 0; i < count; i++) {
        const jlt_tier *tier = &tiers[i];
        tier_run run = { .question = { model, scenes[scene].params, rows + 1, false, false, tier->name, NULL },
                         .options = { .tolerance = tolerance }, .rows = rows, .count = scenes[scene].rows };
        jlt_bench_time time;
        if (options->form != NULL && strcmp(options->form, tier->name) != 0) continue;
        if (jlt_plan_make(&run.plan, &run.question) != JLT_OK) continue;
        st = jlt_bench_clock(&time, options->repeats, 1, pass, &run);
        if (st == JLT_ERR_NOMEM) goto done;
        fprintf(table, "%s,%s,%u,%g", scenes[scene].name, tier->name, tier->dimension, tolerance);
        if (st != JLT_OK) {
            fputs(",,,,,,\n", table);
            st = JLT_OK;
            continue;
        }
        const double unit = 1e6 / ROUNDS;
        fprintf(table, ",%.3e,%zu,%zu,%.4g,%.4g,%.4g\n", run.error, run.steps, run.evaluations, unit * time.median,
                unit * time.least, unit * time.largest);
    }
done:
    return st;
}

static jlt_exit run(FILE *table, const jlt_bench_options *options)
{
    jlt_exit code = JLT_EXIT_DONE;

    for (size_t scene = 0; scene < sizeof scenes / sizeof *scenes && code == JLT_EXIT_DONE; scene++) {
        jlt_bench_table reference = { 0 };
        char path[4096];
        double tolerance;
        snprintf(path, sizeof path, "%s/%s", options->reference, scenes[scene].file);
        jlt_status st = jlt_bench_read(&reference, path, COLUMNS);
        if (st == JLT_OK && reference.rows < scenes[scene].rows) st = JLT_ERR_ARG;
        if (st != JLT_OK) code = jlt_bench_unread(path, st);
        for (size_t k = 0; code == JLT_EXIT_DONE && (tolerance = jlt_bench_tolerance(options, k)) > 0; k++) {
            st = run_scene(table, options, scene, reference.values, tolerance);
            if (st != JLT_OK) code = jlt_command_fail(jlt_command_exit(st), "%s: %s", scenes[scene].name, jlt_status_text(st));
        }
        jlt_bench_clear(&reference);
    }
    return code;
}

const jlt_bench_kind jlt_bench_tiers = {
    "tiers",
    "states at given times by every tier that serves; --reference is the\n    folder with flow_rod.csv, flow_balanced.csv, "
    "flow_generic.csv",
    "scene,tier,dimension,tolerance,error,steps,evaluations,us_per_orbit,us_least,us_largest", "rfkqo", run,
};
