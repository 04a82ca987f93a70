/* Measures the cost and error of returns to the section by each tier and method, at each tolerance. */
#include "bench.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dynamics/section.h"
#include "dynamics/system.h"
#include "integrate/batch.h"
#include "integrate/batch_method.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
#include "scene/tier.h"
#include "top/top.h"

/* The reference has rows orbit, return, t, gamma3, v_nu, omega_n, omega3; return 0 is the start. */
enum { STATES = 32, COLUMNS = 7, FIRST_STATE = 3 };

typedef struct {
    jlt_progress line;
    size_t rows;
} tally;

/* One tier bound to the top of (5.1), and the orbits to follow in it. */
typedef struct {
    const jlt_bench_options *options;
    tally *tally;
    const jlt_tier *tier;
    jlt_top top;
    jlt_tier_view view;
    jlt_instance *instance; /* the view's */
    size_t section;  /* index of omega_tau */
    int root;        /* index of s; -1: it is not a state */
    size_t orbits, checked;          /* checked: returns of each orbit in the reference */
    const double *reference;
    double (*start)[JLT_TOP_STATES]; /* (orbits,) */
    double (*lifted)[STATES];        /* (orbits,): the starts in the tier's coordinates */
} problem;

/* Errors and counts, from the first pass. */
typedef struct {
    double error;     /* largest error of gamma3, v_nu and omega3 over the checked returns; NaN if an orbit ended before them */
    double time_error;
    double drift[2];  /* largest drift of E and G from the start, over all returns */
    double returns, steps;
    size_t failed;    /* orbits that ended before all their returns */
} outcome;

static void note(double *worst, double value)
{
    if (!(fabs(value) <= *worst)) *worst = fabs(value);
}

/* Take a return into the outcome. y: the tier's states there; t: its time, NaN if not known. */
static void note_return(outcome *out, const problem *p, size_t orbit, size_t number, const double *y, double t)
{
    const jlt_top *top = &p->top;
    const double *start = p->start[orbit], *expected = p->reference + (orbit * (p->checked + 1) + number) * COLUMNS;
    double x[JLT_TOP_STATES];

    jlt_tier_extract(&p->view, x, y);
    note(&out->drift[0], jlt_top_energy(top, x) - jlt_top_energy(top, start));
    note(&out->drift[1], jlt_top_jellett(top, x) - jlt_top_jellett(top, start));
    if (number > p->checked) return;
    note(&out->time_error, t - expected[2]);
    note(&out->error, x[JLT_TOP_GAMMA3] - expected[FIRST_STATE]);
    note(&out->error, x[JLT_TOP_V_NU] - expected[FIRST_STATE + 1]);
    note(&out->error, x[JLT_TOP_OMEGA3] - expected[FIRST_STATE + 3]);
}

static void note_end(outcome *out, const problem *p, size_t made)
{
    out->returns += (double)made;
    out->failed += made < p->options->returns;
    if (made < p->checked && made < p->options->returns) out->error = out->time_error = NAN;
}

/* ---- one orbit after another ---- */

typedef struct {
    const problem *problem;
    jlt_section *section;
    outcome outcome;
} scalar_run;

static jlt_status scalar_pass(void *context, bool first)
{
    scalar_run *run = context;
    const problem *p = run->problem;
    size_t before, after, evaluations;

    jlt_section_cost(run->section, &before, &evaluations);
    for (size_t orbit = 0; orbit < p->orbits; orbit++) {
        jlt_return row = { 0 };
        jlt_status st = jlt_section_start_state(run->section, &row, p->lifted[orbit], 1);
        size_t made = 0;
        while (st == JLT_OK && made < p->options->returns) {
            st = jlt_section_next(run->section, &row);
            if (st != JLT_OK || row.fate != JLT_FATE_ALIVE) break;
            made++;
            if (first) note_return(&run->outcome, p, orbit, made, row.x, row.t);
        }
        if (st == JLT_ERR_NOMEM) return st;
        if (first) note_end(&run->outcome, p, made);
    }
    jlt_section_cost(run->section, &after, &evaluations);
    if (first) run->outcome.steps = (double)(after - before);
    return JLT_OK;
}

static jlt_status measure_scalar(outcome *out, jlt_bench_time *time, const problem *p, const jlt_method *method, double tolerance)
{
    jlt_status st = JLT_OK;
    jlt_system *system = NULL;
    scalar_run run = { .problem = p };
    const jlt_flow options = { .method = method, .tolerance = tolerance, .direction = JLT_RISING };

    JLT_TRY(jlt_system_plane(&system, p->instance->descriptor, p->instance->params, (unsigned)p->section, 0, NULL, &options));
    JLT_TRY(jlt_section_create(&run.section, &system->flow));
    JLT_TRY(jlt_bench_clock(time, p->options->repeats, 1, scalar_pass, &run));
    *out = run.outcome;
done:
    jlt_section_destroy(run.section);
    jlt_system_destroy(system);
    return st;
}

/* ---- many at once ---- */

typedef struct {
    const problem *problem;
    jlt_batch_map map;
    double *starts;   /* (orbits, states) */
    outcome *by_orbit; /* (orbits,), so that threads do not share one */
    size_t *made;
    outcome outcome;
    bool first;
} batch_run;

static int batch_row(void *context, size_t orbit, size_t number, const double *x)
{
    batch_run *run = context;
    run->made[orbit] = number;
    if (run->first) note_return(&run->by_orbit[orbit], run->problem, orbit, number, x, NAN);
    return 0;
}

static int batch_end(void *context, size_t orbit, jlt_lane_end end, size_t returns, const double *x)
{
    (void)context, (void)orbit, (void)end, (void)returns, (void)x;
    return 0;
}

static jlt_status batch_pass(void *context, bool first)
{
    batch_run *run = context;
    const problem *p = run->problem;
    outcome *out = &run->outcome;
    jlt_batch_work work;

    run->first = first;
    memset(run->made, 0, p->orbits * sizeof *run->made);
    const jlt_status st = jlt_batch_section(&run->map, run->starts, p->orbits, p->options->returns, batch_row, batch_end, run,
                                            &work);
    if (st != JLT_OK || !first) return st;
    out->steps = (double)work.steps;
    for (size_t orbit = 0; orbit < p->orbits; orbit++) {
        const outcome *one = &run->by_orbit[orbit];
        note(&out->error, one->error);
        note(&out->drift[0], one->drift[0]);
        note(&out->drift[1], one->drift[1]);
        note_end(out, p, run->made[orbit]);
    }
    out->time_error = NAN;
    return JLT_OK;
}

static jlt_status measure_batch(outcome *out, jlt_bench_time *time, const problem *p, const jlt_batch_method *method,
                                const jlt_kernel_batch *kernels, bool project, unsigned threads, double tolerance)
{
    const unsigned dim = p->instance->descriptor->state_count;
    jlt_status st = JLT_ERR_NOMEM;
    batch_run run = { .problem = p };

    run.map = (jlt_batch_map){ .kernels = kernels,
                               .dim = dim,
                               .column = (unsigned)p->section,
                               .direction = 1,
                               .cases = &(jlt_batch_case){ .p = p->instance->prepared, .params = p->instance->params },
                               .root = p->root,
                               .root_floor = 1e-9,
                               .method = method,
                               .tolerance = tolerance,
                               .max_steps = 1000000,
                               .threads = threads,
                               .project = project ? p->instance->descriptor : NULL };
    run.starts = calloc(p->orbits, dim * sizeof *run.starts);
    run.by_orbit = calloc(p->orbits, sizeof *run.by_orbit);
    run.made = calloc(p->orbits, sizeof *run.made);
    if (run.starts == NULL || run.by_orbit == NULL || run.made == NULL) goto done;
    for (size_t orbit = 0; orbit < p->orbits; orbit++) memcpy(run.starts + orbit * dim, p->lifted[orbit], dim * sizeof *run.starts);
    JLT_TRY(jlt_bench_clock(time, p->options->repeats, threads, batch_pass, &run));
    *out = run.outcome;
done:
    free(run.starts);
    free(run.by_orbit);
    free(run.made);
    return st;
}

/* ---- all measurements of a tier ---- */

static void write_row(FILE *table, const problem *p, const char *method, unsigned threads, double tolerance, const outcome *o,
                      const jlt_bench_time *time)
{
    const double unit = 1e6 / fmax(1, o->returns);

    fprintf(table, "jellett,%s,%s,%u,%g", method, p->tier->name, threads, tolerance);
    jlt_bench_number(table, "%.3e", o->error);
    jlt_bench_number(table, "%.3e", o->time_error);
    jlt_bench_number(table, "%.3e", o->drift[0]);
    jlt_bench_number(table, "%.3e", o->drift[1]);
    fprintf(table, ",%.4g,%.4g,%.4g,%.2f,%zu\n", unit * time->median, unit * time->least, unit * time->largest,
            o->steps / fmax(1, o->returns), o->failed);
    jlt_progress_show(&p->tally->line, ++p->tally->rows, 0);
}

static bool wanted(const problem *p, const char *method)
{
    return p->options->method == NULL || strcmp(method, p->options->method) == 0;
}

/* Write the rows of one method for single orbits, one for each tolerance. Writes none if the method cannot use the tier's
 * kernels. */
static jlt_exit run_scalar(FILE *table, const problem *p, const jlt_method *method)
{
    double tolerance;

    for (size_t i = 0; (tolerance = jlt_bench_tolerance(p->options, i)) > 0; i++) {
        outcome out = { 0 };
        jlt_bench_time time;
        const jlt_status st = measure_scalar(&out, &time, p, method, tolerance);
        if (st == JLT_ERR_UNSUPPORTED) return JLT_EXIT_DONE;
        if (st != JLT_OK)
            return jlt_command_fail(jlt_command_exit(st), "%s on %s: %s", method->name, p->tier->name, jlt_status_text(st));
        write_row(table, p, method->name, 1, tolerance, &out, &time);
    }
    return JLT_EXIT_DONE;
}

/* Write the rows of one batch method, one for each tolerance. */
static jlt_exit run_batch(FILE *table, const problem *p, const jlt_batch_method *method, const jlt_kernel_batch *kernels,
                          bool project, unsigned threads)
{
    char name[64];
    double tolerance;

    snprintf(name, sizeof name, "%s%s %sx%u", method->name, project ? " projected" : "", kernels->isa, kernels->lanes);
    for (size_t i = 0; (tolerance = jlt_bench_tolerance(p->options, i)) > 0; i++) {
        outcome out = { 0 };
        jlt_bench_time time;
        const jlt_status st = measure_batch(&out, &time, p, method, kernels, project, threads, tolerance);
        if (st == JLT_ERR_UNSUPPORTED) return JLT_EXIT_DONE;
        if (st != JLT_OK) return jlt_command_fail(jlt_command_exit(st), "%s on %s: %s", name, p->tier->name, jlt_status_text(st));
        write_row(table, p, name, threads, tolerance, &out, &time);
    }
    return JLT_EXIT_DONE;
}

static void list_methods(FILE *table, const problem *p)
{
    const jlt_method *method;
    const jlt_batch_method *batch;

    for (size_t i = 0; (method = jlt_method_at(i)) != NULL; i++)
        if (p->instance->descriptor->state_count <= JLT_CHART_STATES_MAX) fprintf(table, "%s %s\n", p->tier->name, method->name);
    for (size_t i = 0; (batch = jlt_batch_method_at(i)) != NULL; i++)
        fprintf(table, "%s %s\n", p->tier->name, batch->name);
}

/* Measure all methods for single orbits, unless the tier has too many states for a chart; and all batch methods on all instruction
 * sets, on the best one also with projection onto levels, and with several threads if asked for. */
static jlt_exit run_tier(FILE *table, const problem *p)
{
    const jlt_descriptor *d = p->instance->descriptor;
    jlt_exit code = JLT_EXIT_DONE;
    const jlt_method *method;
    const jlt_batch_method *batch;

    for (size_t i = 0; d->state_count <= JLT_CHART_STATES_MAX && (method = jlt_method_at(i)) != NULL && code == JLT_EXIT_DONE; i++)
        if (wanted(p, method->name)) code = run_scalar(table, p, method);
    for (size_t i = 0; (batch = jlt_batch_method_at(i)) != NULL && code == JLT_EXIT_DONE; i++) {
        if (!wanted(p, batch->name)) continue;
        for (size_t isa = 0; isa < JLT_ISA_COUNT && code == JLT_EXIT_DONE; isa++)
            if (jlt_batch_isa_runs(d->batches[isa])) code = run_batch(table, p, batch, d->batches[isa], false, 1);
        if (code == JLT_EXIT_DONE && d->integral_count > 0) code = run_batch(table, p, batch, jlt_batch_isa_best(d, 0), true, 1);
        if (code == JLT_EXIT_DONE && p->options->threads > 1)
            code = run_batch(table, p, batch, jlt_batch_isa_best(d, 0), false, (unsigned)p->options->threads);
    }
    return code;
}

/* Bind a tier, and map every start into its coordinates. EMPTY: its kernel does not have the state omega_tau, or it does not
 * serve. */
static jlt_status open_tier(problem *p, const jlt_tier *tier)
{
    const double params[] = { p->top.m, p->top.R, p->top.g, p->top.a3, p->top.I1, p->top.I3 };
    char refusal[JLT_TIER_TEXT_MAX];
    double y[JLT_WAY_VALUES_MAX];
    size_t s, level;
    jlt_status st = JLT_ERR_EMPTY;

    p->tier = tier;
    if (tier->table == NULL || tier->dimension >= STATES) return st;
    for (size_t i = p->orbits; i-- > 0;) { /* the first start last, since its view is kept */
        jlt_tier_close(&p->view);
        st = jlt_tier_open(&p->view, y, refusal, tier, params, p->start[i]);
        if (st != JLT_OK) return st == JLT_ERR_UNSUPPORTED ? JLT_ERR_EMPTY : st;
        memcpy(p->lifted[i], y, p->view.instance->descriptor->state_count * sizeof *y);
    }
    const jlt_descriptor *d = p->view.instance->descriptor;
    if (!jlt_descriptor_state(d, "omega_tau", &p->section)) return JLT_ERR_EMPTY;
    p->root = jlt_descriptor_state(d, "s", &s) ? (int)s : -1;
    if (jlt_descriptor_param(d, "G", &level)) { /* the exact level, without the rounding errors of the first start */
        memcpy(y, p->view.instance->params, d->param_count * sizeof *y);
        y[level] = p->view.params[tier->way_count][level] = -0.56;
        jlt_tier_view *view = &p->view;
        jlt_instance_destroy(view->instance);
        JLT_TRY(jlt_instance_create(&view->instance, d, y));
    }
    p->instance = p->view.instance;
done:
    return st;
}

/* Read orbits and starts from the reference, which has return 0 and the same number of returns for every orbit. */
static jlt_status read_grid(problem *p, const jlt_bench_table *table)
{
    size_t checked = 0;

    while (checked + 1 < table->rows && table->values[(checked + 1) * COLUMNS + 1] > 0) checked++;
    if (table->rows % (checked + 1) != 0) return JLT_ERR_ARG;
    for (size_t i = 0; i < table->rows; i++)
        if (table->values[i * COLUMNS + 1] != (double)(i % (checked + 1))) return JLT_ERR_ARG;
    p->checked = checked;
    p->orbits = table->rows / (checked + 1);
    p->reference = table->values;
    p->start = calloc(p->orbits, sizeof *p->start);
    p->lifted = calloc(p->orbits, sizeof *p->lifted);
    if (p->start == NULL || p->lifted == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < p->orbits; i++) {
        const double *row = table->values + i * (checked + 1) * COLUMNS + FIRST_STATE;
        const double x[JLT_TOP_STATES] = { row[0], row[1], 0, row[2], row[3] };
        memcpy(p->start[i], x, sizeof x);
    }
    return JLT_OK;
}

static jlt_exit run(FILE *table, const jlt_bench_options *options)
{
    jlt_exit code = JLT_EXIT_DONE;
    jlt_bench_table reference = { 0 };
    tally rows = { .rows = 0 };
    problem p = { .options = options, .tally = &rows,
                  .top = { .m = 1, .R = 1, .g = 1, .a3 = 0.51, .I1 = 1.0 / 3, .I3 = 1.0 / 3 } }; /* (5.1) */
    jlt_tier tiers[JLT_TIERS_MAX];
    const unsigned count = jlt_tier_list(tiers, jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL), NULL);

    jlt_status st = jlt_bench_read(&reference, options->reference, COLUMNS);
    if (st == JLT_OK) st = read_grid(&p, &reference);
    if (st != JLT_OK) code = jlt_bench_unread(options->reference, st);
    jlt_progress_start(&rows.line, "rows");
    for (unsigned i = 0; i < count && code == JLT_EXIT_DONE; i++) {
        const jlt_tier *tier = &tiers[i];
        if (options->form != NULL && strcmp(tier->name, options->form) != 0) continue;
        st = open_tier(&p, tier);
        if (st == JLT_OK && options->list) list_methods(table, &p);
        else if (st == JLT_OK) code = run_tier(table, &p);
        else if (st != JLT_ERR_EMPTY) code = jlt_command_fail(jlt_command_exit(st), "%s: %s", tier->name, jlt_status_text(st));
        jlt_tier_close(&p.view);
    }
    jlt_progress_end(&rows.line);
    free(p.lifted);
    free(p.start);
    jlt_bench_clear(&reference);
    return code;
}

const jlt_bench_kind jlt_bench_section = {
    "section", "section map at (5.1), every method on every tier; errors over the\n    returns that the reference knows",
    "program,method,form,threads,tolerance,error,time_error,drift_E,drift_G,us_per_return,us_least,us_largest,"
    "steps_per_return,failed",
    "rfmntkqlo", run,
};
