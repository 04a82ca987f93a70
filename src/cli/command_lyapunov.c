/* `jellett lyapunov`: Lyapunov exponents of an orbit with their convergence, or a chart of finite-time exponents. */
#include "base/options.h"
#include "cli/lyapunov_chart.h"
#include "cli/lyapunov_losses.h"
#include "cli/progress.h"
#include "cli/shelf.h"
#include "cli/swept.h"
#include "core/memory.h"
#include "dynamics/lyapunov.h"
#include "dynamics/scale.h"
#include "report/csv.h"

#include <math.h>
#include <string.h>

typedef jlt_lyapunov_chart_options options;

enum { SKIP = 2000, THREADS };

static const struct argp_option option_table[] = {
    { "start", 'a', "NAME=VALUE,...", 0,
      "The start on the section: a value for every coordinate; for the spherical top default a chaotic orbit", 1 },
    { "grid", 'g', "COUNTxCOUNT", 0,
      "Compute a chart instead: finite-time exponents for a grid of starts over the whole section, or over "
      "NAME=LOW:HIGH:COUNT,...", 1 },
    { "returns", 'n', "N", 0, "Follow orbits for N returns; default 1000, or 10 for a chart", 1 },
    { "skip", SKIP, "N|0", 0,
      "Leave out N returns first, so that the orbit reaches its attractor; t counts from there; default 0", 1 },
    { "threads", THREADS, "N", 0, "Use N threads for a chart or a sweep; default: all processors. Rows do not depend on N", 1 },
    { 0 },
};

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { &jlt_plot_axes_argp, 0, NULL, 0 },
                                              { &jlt_swept_argp, 0, NULL, 0 }, { 0 } };

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case 'a': jlt_motion_one_start(&o->motion, value); return 0;
    case 'g': jlt_motion_typed(o->motion.grid = value, "--grid"); return 0;
    case 'n': jlt_common_count(&o->returns, value, 1, 1000000000000, "--returns"); return 0;
    case SKIP: jlt_common_count(&o->skip, value, 0, 1000000000000, "--skip"); return 0;
    case THREADS: jlt_common_count(&o->threads, value, 1, 1024, "--threads"); return 0;
    case ARGP_KEY_END:
        if (o->motion.starts[0] != NULL && o->motion.grid != NULL) argp_error(state, "--start and --grid exclude each other");
        if (o->motion.grid == NULL && o->motion.common.sweep == NULL && o->threads > 0)
            argp_error(state, "--threads needs --grid or --sweep: add one, or leave out --threads");
        if (o->motion.grid == NULL && o->motion.common.axes != NULL && o->motion.common.sweep == NULL)
            argp_error(state, "--axes are those of a chart: add --grid");
        if (o->motion.grid == NULL && o->motion.common.sweep == NULL) jlt_plot_check_log(&o->motion.common, "x", state);
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Compute the Lyapunov exponents of the section's map, per unit of time, with the history of their convergence; or a chart "
    "of finite-time exponents over the section. The exponents of the flow's direction and across the levels are zero, and are "
    "left out. Where the section stands in a smaller table that the model reduces onto, exponents and divergence are those of "
    "that table's states: the states that it lacks have further ones, which need not be zero."
    "\vColumns of a history:\n"
    "  return, t         number of returns, and time; at powers of two, and at\n"
    "                    quarters between them\n"
    "  lambda1, lambda2, ...: the exponents\n"
    "  divergence        mean divergence along the orbit, to which the sum of the\n"
    "                    exponents tends\n\n"
    "Columns of a chart:\n"
    "  COORDINATE        each coordinate of the start\n"
    "  exponent          empty if the orbit ends before N returns, or a rate jumps\n"
    "  t                 time\n\n"
    "Differences of points are measured in coordinates, counted in units of the problem, powers of two; a coordinate that the "
    "grid, or a return, runs through by more than 64 of these, or by less than 1/64, counts in its own size, unless the "
    "derivative of a first return would be more than 64 times as large. Another grid, other units, coordinates or another order "
    "of states measure them differently: exponents of N returns change by a part that falls as 1/t, and their limits do not.\n\n"
    "Orbits on which a condition of the model breaks are told of at the end; those of a chart and of a sweep are followed once "
    "more for that, and the returns of --skip count.\n\n"
    "With --sweep, a history is its last row. The starts of a chart, and the histories of a sweep, are followed side by side, "
    "by a method that --tol chooses; with --method, one at a time.\n\n"
    "Examples:\n"
    "  jellett lyapunov --start eta=0.02,gamma3=-0.61 --returns 20000 \\\n"
    "    --plot history.svg\n"
    "  jellett lyapunov --sweep a3=0.4:0.6:101 --returns 2000 --plot over.svg\n"
    "  jellett lyapunov --grid 200x150 --returns 5 --plot chart.png > chart.csv",
    children, NULL, NULL,
};

typedef struct {
    FILE *file, *points;
    const options *o;
    jlt_progress progress;
    unsigned dim;
    size_t next;
    jlt_map *map;      /* which watches the conditions of the model until one is lost */
    double lost_at;    /* by this time; NAN: none is */
    unsigned lost;
} history;

static void write_state(FILE *file, const jlt_lyapunov_state *state, unsigned dim)
{
    fprintf(file, "%zu,", state->returns);
    jlt_csv_value(file, state->t);
    for (unsigned k = 0; k <= dim; k++) {
        fputc(',', file);
        jlt_csv_value(file, k < dim ? state->exponents[k] : state->sum_check);
    }
    fputc('\n', file);
}

static void note_loss(history *self, double t)
{
    const jlt_section_least least = jlt_map_least(self->map);

    if (!(least.value <= 0)) return;
    self->lost = least.condition;
    self->lost_at = t;
    jlt_map_watch(self->map, NULL);
}

static int observe(void *context, const jlt_lyapunov_state *state)
{
    history *self = context;

    jlt_progress_show(&self->progress, state->returns, self->o->returns);
    note_loss(self, state->t);
    if (self->o->motion.common.at_point) return jlt_motion_interrupted(&self->o->motion); /* only the last row is written, later */
    if (state->returns >= self->next || state->returns == self->o->returns) {
        write_state(self->file, state, self->dim);
        if (self->points != NULL) {
            double row[1 + JLT_CHART_DIM_MAX] = { state->t };
            memcpy(row + 1, state->exponents, self->dim * sizeof *row);
            jlt_look_row(self->points, row, 1 + self->dim);
        }
        /* rows after 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, ... returns */
        size_t step = 1;
        while (8 * step <= self->next) step *= 2;
        self->next += step;
    }
    return jlt_motion_interrupted(&self->o->motion);
}

static jlt_exit draw_history(const options *o, const jlt_system *system)
{
    double q[JLT_CHART_DIM_MAX];
    jlt_plot plot;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    jlt_plot_block(&plot, "HISTORY", o->motion.common.drawn);
    jlt_plot_words(&plot, "Lyapunov exponents from ");
    (void)jlt_motion_start(q, system, o->motion.starts[0]);
    for (unsigned k = 0; k < system->flow.chart->dim; k++) jlt_plot_value(&plot, system->flow.chart->names[k], q[k]);
    jlt_plot_words(&plot, "\n");
    jlt_motion_caption(&plot, system, NULL);
    const jlt_descriptor *model = system->instance->descriptor;
    jlt_plot_log(&plot, 'x', jlt_plot_timed(model, "t [s]", "t"), JLT_EXTENT_OPEN, 10);
    jlt_plot_axis(&plot, 'y', jlt_plot_timed(model, "λ [1/s]", "λ"), JLT_EXTENT_OPEN, 0);
    fputs(JLT_LOOK_GRID "plot ", plot.stream);
    for (unsigned k = 0; k < system->flow.chart->dim; k++) {
        fprintf(plot.stream, "%s$HISTORY using 1:%u ", k == 0 ? "" : ", ", k + 2);
        jlt_look_pen(plot.stream, plot.look, (jlt_pen){ "linespoints", .colour = k, .mark = k, .size = 0.3 });
        fprintf(plot.stream, " title 'λ_{%u}'", k + 1);
    }
    fputc('\n', plot.stream);
    return jlt_plot_draw(&plot);
}

typedef struct {
    options o;
    jlt_system *system;
    jlt_map *map;
    jlt_map_batch *maps; /* for a chart, and for a history that may share a batch with others; NULL: not needed */
    jlt_grid_axis axes[JLT_CHART_DIM_MAX];
    jlt_motion_map picture;
    double q[JLT_CHART_DIM_MAX]; /* start of a history */
    jlt_lyapunov_state state;    /* its end */
    jlt_status status;
    int lost;                    /* as jlt_lyapunov_losses says; JLT_LYAPUNOV_HELD until it is known */
    bool has_end;                /* the history was followed in a batch: state, status and lost are set */
} exponents;

/* Follow the history of the first run, and in the same batch those of later runs that fit it. Returns false if the batch fails, or
 * memory is out. */
static bool follow_group(exponents *const *runs, size_t count)
{
    const unsigned d = runs[0]->system->flow.chart->dim;
    JLT_FREED exponents **own = malloc(count * sizeof(exponents *));
    JLT_FREED double *q = calloc(count, d * sizeof *q);
    JLT_FREED size_t *flow_of = calloc(count, sizeof *flow_of);
    size_t made = 0;
    JLT_FREED jlt_lyapunov_state *states = malloc(count * sizeof *states);
    JLT_FREED jlt_status *statuses = malloc(count * sizeof *statuses);
    JLT_FREED const jlt_system **systems = malloc(count * sizeof(jlt_system *));
    JLT_FREED int *lost = malloc(count * sizeof *lost);
    const options *o = &runs[0]->o;

    if (own == NULL || q == NULL || flow_of == NULL || states == NULL || statuses == NULL || systems == NULL || lost == NULL)
        return false;
    for (size_t i = 0; i < count; i++) {
        exponents *run = runs[i];
        flow_of[made] = 0;
        if (run->maps == NULL || run->has_end) continue;
        if (i > 0 && jlt_map_batch_add(runs[0]->maps, &flow_of[made], &run->system->flow) != JLT_OK) continue;
        memcpy(q + made * d, run->q, d * sizeof *q);
        systems[flow_of[made]] = run->system;
        own[made++] = run;
    }
    if (jlt_lyapunov_run_each(runs[0]->maps, states, statuses, q, flow_of, made, o->skip, o->returns) != JLT_OK
        || jlt_lyapunov_losses(lost, systems, made, q, flow_of, made, o->skip + o->returns, true, o->threads) != JLT_OK)
        return false;
    for (size_t i = 0; i < made; i++) {
        own[i]->state = states[i];
        own[i]->status = statuses[i];
        own[i]->lost = lost[i];
        own[i]->has_end = true;
    }
    return true;
}

/* Follow one orbit, and keep its last state; at a point of a sweep no rows are written on the way. */
static void follow_alone(exponents *self, history *rows)
{
    self->status = jlt_lyapunov_chart_skip(self->map, self->q, self->o.skip);
    jlt_map_watch(self->map, self->system->flow.observed);
    if (self->status == JLT_OK) self->status = jlt_lyapunov_run(self->map, &self->state, self->q, self->o.returns, observe, rows);
    const jlt_section_least least = jlt_map_least(self->map);
    self->lost = jlt_lyapunov_loss(least.value, least.condition); /* after the last return that `observe` saw */
}

static jlt_exit write_history(exponents *self)
{
    options *o = &self->o;
    const jlt_chart *chart = self->system->flow.chart;
    const jlt_lyapunov_state *state = &self->state;
    history rows = { .o = o, .dim = chart->dim, .next = 1, .file = o->motion.common.table.file, .points = o->motion.common.points,
                     .map = self->map, .lost_at = NAN };

    fputs("return,t", rows.file);
    for (unsigned k = 0; k < chart->dim; k++) fprintf(rows.file, ",lambda%u", k + 1);
    fputs(",divergence\n", rows.file);
    jlt_progress_start(&rows.progress, "returns");
    if (self->maps != NULL && !self->has_end && !follow_group(&self, 1)) self->status = JLT_ERR_NOMEM;
    else if (self->maps == NULL) follow_alone(self, &rows);
    jlt_progress_end(&rows.progress);
    if (o->motion.common.at_point && state->returns > 0) write_state(rows.file, state, chart->dim);
    if (jlt_motion_interrupted(&o->motion)) {
        fprintf(stderr, "jellett: interrupted after %zu returns; whole rows are saved in %s\n", state->returns,
                o->motion.common.table.path);
        return JLT_EXIT_DONE;
    }
    if (!isnan(rows.lost_at))
        fprintf(stderr, "jellett: by t = %.10g %s is lost, and the model does not hold from there on\n", rows.lost_at,
                jlt_observed_condition(self->system->flow.observed, rows.lost));
    if (self->lost >= 0)
        fprintf(stderr, "jellett: on the way %s is lost, and the model does not hold from there on\n",
                jlt_observed_condition(self->system->flow.observed, (unsigned)self->lost));
    if (self->lost == JLT_LYAPUNOV_UNKNOWN)
        fputs("jellett: it is not known whether the model holds on the way: a condition of it has no value there\n", stderr);
    if (self->status == JLT_ERR_DOMAIN && state->returns > 0) {
        fprintf(
            stderr,
            "jellett: the orbit ends, at a pole, at rest or where the domain does, after %zu returns, t = %.10g: these are "
            "finite-time exponents\n",
            state->returns, state->t);
        return JLT_EXIT_DONE;
    }
    if (state->blurred > 0)
        fprintf(stderr,
                "jellett: %zu of %zu returns contract some directions by more than the tolerance resolves: exponents that rest "
                "on them are left out, and the mean divergence stands for the sum of all; a section that is met more often shows "
                "them\n",
                state->blurred, state->returns);
    if (state->saddle.has_left)
        fprintf(stderr, "jellett: return %zu begins nearer to a saddle than errors tell separatrices apart: what follows is one of "
                "the motions beside it\n", state->saddle.at);
    return self->status == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(self->status, self->system, o->motion.starts[0]);
}

static const jlt_swept_form swept = { &jlt_command_lyapunov, true, 2 };

static void drop(void *run)
{
    exponents *self = run;

    jlt_map_destroy(self->map);
    jlt_map_batch_destroy(self->maps);
    jlt_system_destroy(self->system);
    jlt_motion_end(&self->o.motion);
    jlt_motion_map_close(&self->picture);
    free(self);
}

/* Create the maps: a batch for a chart, and for a history at a point of a sweep, which may share it with other points; else a
 * single map. Then find the typical sizes of coordinates at the starts, in which tangent vectors are measured. */
static jlt_exit open_maps(exponents *self, bool has_method)
{
    double extents[JLT_CHART_DIM_MAX];
    options *o = &self->o;
    const bool is_chart = o->motion.grid != NULL;
    jlt_status st;

    if (is_chart && self->system->flow.max_steps == 0) self->system->flow.max_steps = 20000;
    st = jlt_map_create(&self->map, &self->system->flow);
    if (st == JLT_OK && (is_chart || (o->motion.common.at_point && !has_method)))
        st = jlt_lyapunov_chart_maps(&self->maps, o, self->system, has_method);
    if (st != JLT_OK) return jlt_motion_fail(st, self->system, "the map");
    if (is_chart) {
        JLT_PASS(jlt_motion_scale(self->system, NULL, self->axes));
        jlt_motion_grid_point(self->q, self->axes, self->system, jlt_motion_grid_size(self->axes, self->system) / 2);
        st = jlt_scale_for_tangents(self->system, self->q);
        return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, self->system, "the map");
    }
    if (self->maps != NULL && !jlt_map_batch_in_lanes(self->maps)) {
        jlt_map_batch_destroy(self->maps);
        self->maps = NULL;
    }
    JLT_PASS(jlt_motion_start(self->q, self->system, o->motion.starts[0]));
    for (unsigned k = 0; k < self->system->flow.chart->dim; k++) extents[k] = fabs(self->q[k]);
    st = jlt_scale_find(self->system, self->q, 1, extents);
    if (st == JLT_OK) st = jlt_scale_for_tangents(self->system, self->q);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, self->system, "the map");
}

static void *begin(jlt_exit *code, int argc, char **argv)
{
    exponents *self = calloc(1, sizeof *self);

    if (self == NULL) {
        *code = jlt_command_no_memory();
        return NULL;
    }
    options *o = &self->o;
    self->lost = JLT_LYAPUNOV_HELD;
    jlt_motion_begin(&o->motion, argc, argv);
    o->motion.flow.method = NULL;
    ttc_options_parse(&parser, argc, argv, o);
    if (jlt_swept_done(code, &swept, &o->motion.common)) goto done;
    const bool has_method = o->motion.flow.method != NULL;
    if (!has_method) o->motion.flow.method = jlt_method_find(NULL);
    o->motion.common.lanes = !has_method && (o->motion.grid != NULL || o->motion.common.at_point);
    if (o->returns == 0) o->returns = o->motion.grid != NULL ? 10 : 1000;
    *code = jlt_motion_system(&self->system, &o->motion);
    if (*code == JLT_EXIT_DONE && o->motion.grid == NULL)
        *code = jlt_motion_default_start(&o->motion, self->system, JLT_START_CHAOTIC, "say where to start: --grid, or --start");
    if (*code == JLT_EXIT_DONE && o->motion.starts[0] != NULL) *code = jlt_motion_check_starts(self->system, o->motion.starts, 1);
    if (*code == JLT_EXIT_DONE && o->motion.grid != NULL)
        *code = jlt_motion_axes(self->axes, self->system, o->motion.grid, "--grid");
    if (*code == JLT_EXIT_DONE && o->motion.grid != NULL) *code = jlt_motion_check_grid(self->axes, self->system);
    if (*code == JLT_EXIT_DONE && o->motion.grid != NULL)
        *code = jlt_motion_map_open(&self->picture, &o->motion, self->system, o->motion.grid, self->axes);
    if (*code == JLT_EXIT_DONE) *code = open_maps(self, has_method);
    if (*code == JLT_EXIT_DONE) *code = jlt_motion_plan(self->system, &o->motion);
    if (*code == JLT_EXIT_DONE) return self;
done:
    drop(self);
    return NULL;
}

static jlt_exit finish(void *run)
{
    exponents *self = run;
    options *o = &self->o;
    jlt_common *common = &o->motion.common;

    JLT_PASS(jlt_common_write(common));
    jlt_motion_header(common->table.file, &o->motion, self->system);
    JLT_PASS(o->motion.grid != NULL ? jlt_lyapunov_chart_write(&self->picture, self->map, self->maps, o, self->axes)
                                    : write_history(self));
    JLT_PASS(jlt_common_save(common));
    if (common->plot == NULL) return JLT_EXIT_DONE;
    return o->motion.grid != NULL ? jlt_lyapunov_chart_draw(o, self->system, &self->picture) : draw_history(o, self->system);
}

static bool are_enough(void *const *runs, size_t count)
{
    return ((const exponents *)runs[0])->maps == NULL || ((const exponents *)runs[0])->o.motion.grid != NULL
           || count == JLT_SHELF_RUNS;
}

static void follow(void *const *runs, size_t count)
{
    exponents *all[JLT_SHELF_RUNS];

    for (size_t i = 0; i < count; i++) all[i] = runs[i];
    for (size_t i = 0; i < count; i++)
        if (all[i]->o.motion.grid == NULL && all[i]->maps != NULL && !all[i]->has_end && !follow_group(all + i, count - i)) return;
}

static const jlt_shelf_form together = { begin, are_enough, follow, finish, drop };

const jlt_command jlt_command_lyapunov = {
    "lyapunov", "[MODEL] [OPTION...]",
    "Lyapunov exponents and how they converge, or a chart of finite times", NULL, &parser, &together
};
