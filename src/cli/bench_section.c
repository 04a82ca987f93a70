#include "cli/bench.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "dynamics/section.h"
#include "dynamics/system.h"
#include "integrate/batch.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"

const jlt_bench_form jlt_bench_forms[] = {
    { "level", "4 states on a level of G and s, dt = s dtau: what sections use", "spherical_top_level", "regular", "" },
    { "level_plain", "4 states on a level of G", "spherical_top_level", "", "" },
    { "regular", "5 states and s, dt = s dtau", "spherical_top", "regular", "" },
    { "plain", "5 states, the equations as published", "spherical_top", "", "" },
    { "no_omega_n", "4 states, omega_n eliminated: divides by s", "spherical_top", "", "level_G" },
    { "no_omega3", "4 states, omega3 eliminated: divides by b", "spherical_top", "", "level_G_omega3" },
    { NULL, NULL, NULL, NULL, NULL },
};

/* (5.1) of Kilin & Ivanova (2023). */
static const struct {
    const char *name;
    double value;
} published[] = { { "m", 1 }, { "R", 1 }, { "g", 1 }, { "I1", 1.0 / 3 }, { "I3", 1.0 / 3 }, { "a3", 0.51 },
                  { "G", -0.56 }, { "G_level", -0.56 } };

static const double R = 1, I1 = 1.0 / 3, I3 = 1.0 / 3, a3 = 0.51, G = -0.56;

static double parameter(const char *name)
{
    for (size_t i = 0; i < sizeof published / sizeof *published; i++)
        if (strcmp(published[i].name, name) == 0) return published[i].value;
    return NAN;
}

/* A state by name from (gamma3, v_nu, omega_n, omega3) on the section. */
static double state(const char *name, const double point[4])
{
    const double s = sqrt((1 - point[0]) * (1 + point[0]));

    if (strcmp(name, "gamma3") == 0) return point[0];
    if (strcmp(name, "v_nu") == 0) return point[1];
    if (strcmp(name, "omega_n") == 0) return point[2];
    if (strcmp(name, "omega3") == 0) return point[3];
    if (strcmp(name, "s") == 0) return s;
    if (strcmp(name, "v_tau") == 0) return (a3 + R * point[0]) * point[2] + R * s * point[3];
    return 0; /* omega_tau */
}

typedef struct {
    const jlt_descriptor *descriptor;
    double params[16], block[512];
    unsigned section;                        /* index of omega_tau */
    int gamma3, v_nu, omega_n, omega3, s, v_tau; /* indices; -1: none */
} problem;

static int index_of(const jlt_descriptor *d, const char *name)
{
    for (unsigned i = 0; i < d->state_count; i++)
        if (strcmp(d->states[i].name, name) == 0) return (int)i;
    return -1;
}

static jlt_status problem_of(problem *out, const jlt_bench_form *form)
{
    const jlt_descriptor *d = jlt_descriptor_find(form->model, "", form->time, form->elimination);

    if (d == NULL || d->param_count > 16 || d->block_count > 512 || d->state_count > JLT_BENCH_STATES) return JLT_ERR_UNSUPPORTED;
    *out = (problem){ .descriptor = d, .gamma3 = index_of(d, "gamma3"), .v_nu = index_of(d, "v_nu"),
                      .omega_n = index_of(d, "omega_n"), .omega3 = index_of(d, "omega3"), .s = index_of(d, "s"),
                      .v_tau = index_of(d, "v_tau"), .section = (unsigned)index_of(d, "omega_tau") };
    for (unsigned i = 0; i < d->param_count; i++) out->params[i] = parameter(d->params[i].name);
    d->prepare(out->params, out->block);
    return JLT_OK;
}

static void start_of(const problem *p, double *x, const double point[4])
{
    for (unsigned i = 0; i < p->descriptor->state_count; i++) x[i] = state(p->descriptor->states[i].name, point);
}

/* omega3 of a state, whatever the form keeps in its place. */
static double omega3_of(const problem *p, const double *x)
{
    if (p->omega3 >= 0) return x[p->omega3];
    const double gamma3 = x[p->gamma3], s = p->s >= 0 ? x[p->s] : sqrt((1 - gamma3) * (1 + gamma3)), b = a3 + R * gamma3;
    if (p->omega_n >= 0) return (I1 * R * s * x[p->omega_n] - G) / (I3 * b);
    return (I1 * R * s * x[p->v_tau] - b * G) / (I1 * R * R * s * s + I3 * b * b);
}

static void note_error(double *error, const problem *p, const jlt_bench_grid *grid, size_t orbit, size_t number, const double *x)
{
    if (number == 0 || number > grid->checked) return;
    const double *expected = grid->expected[orbit * grid->checked + number - 1];
    const double off[3] = { x[p->gamma3] - expected[0], x[p->v_nu] - expected[1], omega3_of(p, x) - expected[3] };
    for (int i = 0; i < 3; i++)
        if (!(fabs(off[i]) <= *error)) *error = fabs(off[i]);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Repeats, with one that is not counted first. pass() makes all returns and fills the result but for the times. */
static jlt_status repeat(jlt_bench_result *result, unsigned repeats, jlt_status (*pass)(void *context, jlt_bench_result *), void *context)
{
    jlt_status st = JLT_OK;
    double *times = calloc(repeats + 1, sizeof *times);

    if (times == NULL) return JLT_ERR_NOMEM;
    for (unsigned i = 0; i <= repeats; i++) {
        *result = (jlt_bench_result){ 0 };
        const double begin = now();
        JLT_TRY(pass(context, result));
        times[i] = now() - begin;
    }
    qsort(times + 1, repeats, sizeof *times, ascending);
    result->seconds[0] = times[1];
    result->seconds[1] = times[1 + repeats / 2];
    result->seconds[2] = times[repeats];
done:
    free(times);
    return st;
}

typedef struct {
    const problem *problem;
    const jlt_bench_grid *grid;
    size_t returns;
    jlt_section *section;
} scalar_run;

static jlt_status scalar_pass(void *context, jlt_bench_result *result)
{
    const scalar_run *run = context;
    size_t before, after, evaluations;

    jlt_section_cost(run->section, &before, &evaluations);
    for (size_t orbit = 0; orbit < run->grid->orbits; orbit++) {
        double x[JLT_BENCH_STATES];
        jlt_return row;
        start_of(run->problem, x, run->grid->start[orbit]);
        jlt_status st = jlt_section_start_state(run->section, &row, x, 1);
        while (st == JLT_OK && row.number < run->returns) {
            st = jlt_section_next(run->section, &row);
            if (st != JLT_OK || row.fate != JLT_FATE_ALIVE) break;
            note_error(&result->error, run->problem, run->grid, orbit, row.number, row.x);
            result->returns++;
        }
        if (st == JLT_ERR_NOMEM) return st;
        result->failed += row.number < run->returns || row.fate != JLT_FATE_ALIVE || st != JLT_OK;
        if (row.number < run->grid->checked && row.number < run->returns) result->error = NAN;
    }
    jlt_section_cost(run->section, &after, &evaluations);
    result->steps = (double)(after - before) / fmax(1, result->returns);
    return JLT_OK;
}

jlt_status jlt_bench_scalar(jlt_bench_result *result, const jlt_bench_form *form, const char *method,
                            const jlt_bench_grid *grid, double tolerance, size_t returns, unsigned repeats)
{
    jlt_status st = JLT_OK;
    problem p;
    jlt_system *system = NULL;
    scalar_run run = { .problem = &p, .grid = grid, .returns = returns };
    const jlt_flow options = { .method = jlt_method_find(method), .tolerance = tolerance, .direction = JLT_RISING };

    if (options.method == NULL) return JLT_ERR_ARG;
    JLT_TRY(problem_of(&p, form));
    JLT_TRY(jlt_system_plane(&system, p.descriptor, p.params, p.section, 0, NULL, &options));
    JLT_TRY(jlt_section_create(&run.section, &system->flow));
    st = repeat(result, repeats, scalar_pass, &run);
done:
    jlt_section_destroy(run.section);
    jlt_system_destroy(system);
    return st;
}

typedef struct {
    const problem *problem;
    const jlt_bench_grid *grid;
    size_t returns;
    jlt_batch_map map;
    double *starts;
    double *errors; /* by orbit: threads write their own */
    size_t *made;
} batch_run;

static int batch_row(void *context, size_t orbit, size_t number, const double *x)
{
    batch_run *run = context;
    run->made[orbit] = number;
    note_error(&run->errors[orbit], run->problem, run->grid, orbit, number, x);
    return 0;
}

static int batch_end(void *context, size_t orbit, jlt_lane_end end, size_t returns, const double *x)
{
    (void)context, (void)orbit, (void)end, (void)returns, (void)x;
    return 0;
}

static jlt_status batch_pass(void *context, jlt_bench_result *result)
{
    batch_run *run = context;
    jlt_batch_work work;

    memset(run->errors, 0, run->grid->orbits * sizeof *run->errors);
    memset(run->made, 0, run->grid->orbits * sizeof *run->made);
    const jlt_status st = jlt_batch_section(&run->map, run->starts, run->grid->orbits, run->returns, batch_row, batch_end, run, &work);
    if (st != JLT_OK) return st;
    for (size_t orbit = 0; orbit < run->grid->orbits; orbit++) {
        result->returns += (double)run->made[orbit];
        result->failed += run->made[orbit] < run->returns;
        if (run->made[orbit] < run->grid->checked && run->made[orbit] < run->returns) result->error = NAN;
        if (!(run->errors[orbit] <= result->error)) result->error = run->errors[orbit];
    }
    result->steps = (double)work.steps / fmax(1, result->returns);
    return JLT_OK;
}

jlt_status jlt_bench_batch(jlt_bench_result *result, const jlt_bench_form *form, unsigned lanes, unsigned threads,
                           const jlt_bench_grid *grid, double tolerance, size_t returns, unsigned repeats)
{
    jlt_status st = JLT_OK;
    problem p;
    batch_run run = { .problem = &p, .grid = grid, .returns = returns };

    JLT_TRY(problem_of(&p, form));
    run.map = (jlt_batch_map){ .kernels = jlt_batch_isa_best(p.descriptor, lanes), .p = p.block, .dim = p.descriptor->state_count,
                               .column = p.section, .direction = 1, .root = p.s, .root_floor = 1e-9, .tolerance = tolerance,
                               .max_steps = 1000000, .threads = threads };
    if (run.map.kernels == NULL || run.map.kernels->lanes != lanes) return JLT_ERR_UNSUPPORTED;
    run.starts = calloc(grid->orbits, p.descriptor->state_count * sizeof *run.starts);
    run.errors = calloc(grid->orbits, sizeof *run.errors);
    run.made = calloc(grid->orbits, sizeof *run.made);
    if (run.starts == NULL || run.errors == NULL || run.made == NULL) st = JLT_ERR_NOMEM;
    for (size_t orbit = 0; st == JLT_OK && orbit < grid->orbits; orbit++)
        start_of(&p, run.starts + orbit * p.descriptor->state_count, grid->start[orbit]);
    if (st == JLT_OK) st = repeat(result, repeats, batch_pass, &run);
done:
    free(run.starts);
    free(run.errors);
    free(run.made);
    return st;
}
