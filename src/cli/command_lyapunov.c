#include "cli/motion_map.h"
#include "cli/progress.h"
#include "cli/swept.h"
#include "dynamics/lyapunov.h"
#include "dynamics/map_batch.h"
#include "kernel/batch_isa.h"
#include "report/csv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    jlt_motion_options motion;
    size_t returns, skip, threads;
} options;

/* Starts of a chart that go together, for each thread. */
enum { SKIP = 2000, THREADS, BLOCK = 256 };

static const struct argp_option option_table[] = {
    { "start", 'a', "NAME=VALUE,...", 0,
      "Start of the orbit, every coordinate of the section; of the spherical top a chaotic one by default", 1 },
    { "grid", 'g', "COUNTxCOUNT", 0, "A chart instead: finite-time exponents of a grid of starts, or of NAME=LOW:HIGH:COUNT,...", 1 },
    { "returns", 'n', "N", 0, "Returns; default 1000, or 10 for a chart", 1 },
    { "skip", SKIP, "N|0", 0, "Returns left out before, so that the orbit is on its attractor; t counts from there", 1 },
    { "threads", THREADS, "N", 0, "Of a chart: on so many threads; default: all processors. Rows do not depend on it", 1 },
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
    case 'g': o->motion.grid = value; return 0;
    case 'n': jlt_common_count(&o->returns, value, 1, 1000000000000, "--returns"); return 0;
    case SKIP: jlt_common_count(&o->skip, value, 0, 1000000000000, "--skip"); return 0;
    case THREADS: jlt_common_count(&o->threads, value, 1, 1024, "--threads"); return 0;
    case ARGP_KEY_END:
        if (o->motion.starts[0] != NULL && o->motion.grid != NULL) argp_error(state, "--start and --grid exclude each other");
        if (o->motion.grid == NULL && o->threads > 0) argp_error(state, "--threads are of a chart: add --grid");
        if (o->motion.grid == NULL && o->motion.common.axes != NULL && o->motion.common.sweep == NULL)
            argp_error(state, "--axes are those of a chart: add --grid");
        if (o->motion.grid == NULL && o->motion.common.sweep == NULL) jlt_plot_check_log(&o->motion.common, "x", state);
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Lyapunov exponents of the section's map, per time, with the history of their convergence; or a chart of finite-time "
    "exponents over the section. The exponents of the flow's direction and across the levels are zero and not shown."
    "\vColumns: return, t, lambda1, lambda2, ..., divergence: the mean divergence along the orbit, which the sum of the "
    "exponents tends to. Returns are shown at powers of two and at quarters between them. Chart: the coordinates, exponent, t; "
    "orbits that end before N returns have an empty exponent. With --sweep a history is its last row. Starts go many at once, by a "
    "method chosen by --tol, or by --method one at a "
    "time.\n\n"
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

static int observe(void *context, const jlt_lyapunov_state *state)
{
    history *self = context;

    jlt_progress_show(&self->progress, state->returns, self->o->returns);
    if (self->o->motion.common.at_point) return jlt_motion_interrupted(&self->o->motion); /* the last row alone is written */
    if (state->returns >= self->next || state->returns == self->o->returns) {
        write_state(self->file, state, self->dim);
        if (self->points != NULL) {
            double row[1 + JLT_CHART_DIM_MAX] = { state->t };
            memcpy(row + 1, state->exponents, self->dim * sizeof *row);
            jlt_look_row(self->points, row, 1 + self->dim);
        }
        /* 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, ... */
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
    jlt_plot_axis(&plot, 'x', "t [s]", JLT_EXTENT_OPEN, 0);
    jlt_plot_log(&plot, 'x', 10);
    jlt_plot_axis(&plot, 'y', "λ [1/s]", JLT_EXTENT_OPEN, 0);
    fputs(JLT_LOOK_GRID "plot ", plot.stream);
    for (unsigned k = 0; k < system->flow.chart->dim; k++) {
        fprintf(plot.stream, "%s$HISTORY using 1:%u ", k == 0 ? "" : ", ", k + 2);
        jlt_look_pen(plot.stream, plot.look, (jlt_pen){ "linespoints", .colour = k, .mark = k, .size = 0.3 });
        fprintf(plot.stream, " title 'λ_{%u}'", k + 1);
    }
    fputc('\n', plot.stream);
    return jlt_plot_draw(&plot);
}

/* The point that exponents are measured from. */
static jlt_status skip(jlt_map *map, double *q, const options *o)
{
    jlt_image image;
    const jlt_status st = o->skip > 0 ? jlt_map_point(map, &image, q, o->skip, 1) : JLT_OK;

    if (o->skip > 0 && st == JLT_OK) memcpy(q, image.q, jlt_map_flow(map)->chart->dim * sizeof *q);
    return st;
}

static jlt_exit run_history(jlt_map *map, options *o, const jlt_system *system)
{
    const jlt_chart *chart = system->flow.chart;
    history self = { .o = o, .dim = chart->dim, .next = 1, .file = o->motion.common.table.file,
                     .points = o->motion.common.points };
    jlt_lyapunov_state state = { .returns = 0 };
    double q[JLT_CHART_DIM_MAX];
    jlt_status st;
    jlt_exit code = jlt_motion_start(q, system, o->motion.starts[0]);

    if (code != JLT_EXIT_DONE) return code;
    if (o->returns == 0) o->returns = 1000;
    fputs("return,t", self.file);
    for (unsigned k = 0; k < chart->dim; k++) fprintf(self.file, ",lambda%u", k + 1);
    fputs(",divergence\n", self.file);
    jlt_progress_start(&self.progress, "returns");
    st = skip(map, q, o);
    if (st == JLT_OK) st = jlt_lyapunov_run(map, &state, q, o->returns, observe, &self);
    jlt_progress_end(&self.progress);
    if (o->motion.common.at_point && state.returns > 0) write_state(self.file, &state, self.dim);
    if (jlt_motion_interrupted(&o->motion)) {
        fprintf(stderr, "jellett: interrupted after %zu returns; whole rows are saved in %s\n", state.returns, o->motion.common.table.path);
        return JLT_EXIT_DONE;
    }
    if (st == JLT_ERR_DOMAIN && state.returns > 0) {
        fprintf(stderr, "jellett: the orbit ends, at a pole, at rest or where the domain does, after %zu returns, t = %.10g: these are finite-time exponents\n",
                state.returns, state.t);
        return JLT_EXIT_DONE;
    }
    if (state.blurred > 0)
        fprintf(stderr, "jellett: %zu of %zu returns stretch by more than rounding can tell apart: exponents between the first and the "
                "last are in doubt; a section that is met more often shows them\n", state.blurred, state.returns);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, o->motion.starts[0]);
}

static jlt_exit draw_chart(const options *o, const jlt_system *system, jlt_motion_map *map)
{
    jlt_plot plot;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    jlt_plot_words(&plot, "Finite-time exponent over %zu return%s\n", o->returns, o->returns == 1 ? "" : "s");
    jlt_motion_caption(&plot, system, NULL);
    jlt_motion_map_frame(map, &plot);
    jlt_motion_map_palette(map, &plot, "exponent [1/s]");
    jlt_motion_map_plot(map, &plot);
    fputc('\n', plot.stream);
    return jlt_plot_draw(&plot);
}

/* Starts first .. first + count - 1: their points q, exponents and times, NaN where the orbit ends. */
static jlt_status exponents(const options *o, jlt_map *map, jlt_map_batch *maps, const jlt_map_images *images, double *q, size_t count)
{
    const unsigned d = jlt_map_flow(map)->chart->dim;
    jlt_status st = JLT_OK;

    memcpy(images->q, q, count * d * sizeof *q);
    for (size_t i = 0; i < count; i++)
        if ((st = skip(map, images->q + i * d, o)) != JLT_OK)
            for (unsigned k = 0; k < d; k++) images->q[i * d + k] = NAN; /* it has ended already */
    return st == JLT_ERR_NOMEM ? st : jlt_map_batch_apply(maps, images, images->q, count, o->returns, 1);
}

static jlt_exit run_chart(jlt_motion_map *picture, jlt_map *map, jlt_map_batch *maps, options *o, const jlt_grid_axis *axes)
{
    const jlt_stream *table = &o->motion.common.table;
    const jlt_system *system = picture->system;
    const jlt_chart *chart = system->flow.chart;
    const unsigned d = chart->dim;
    const size_t all = jlt_motion_grid_size(axes, system), block = BLOCK * o->threads;
    double *q = malloc(block * d * sizeof *q);
    jlt_map_images images = { 0 };
    jlt_progress progress;
    jlt_status st = q == NULL ? JLT_ERR_NOMEM : jlt_map_batch_images(&images, d, block);

    if (o->returns == 0) o->returns = 10;
    for (unsigned k = 0; k < d; k++) fprintf(table->file, "%s,", chart->names[k]);
    fputs("exponent,t\n", table->file);
    jlt_progress_start(&progress, "starts");
    for (size_t first = 0; st == JLT_OK && first < all; first += block) {
        const size_t count = all - first < block ? all - first : block;
        for (size_t i = 0; i < count; i++) jlt_motion_grid_point(q + i * d, axes, system, first + i);
        st = exponents(o, map, maps, &images, q, count);
        if (jlt_motion_interrupted(&o->motion)) break;
        for (size_t i = 0; st == JLT_OK && i < count; i++) {
            const bool has_returned = images.status[i] == JLT_OK;
            const double exponent = has_returned ? jlt_lyapunov_growth(images.slope + i * d * d, d) / images.T[i] : NAN;
            jlt_csv_values(table->file, q + i * d, d);
            fputc(',', table->file);
            jlt_csv_row(table->file, (const double[]){ exponent, has_returned ? images.T[i] : NAN }, 2);
            jlt_motion_map_add(picture, q + i * d, exponent);
        }
        jlt_progress_show(&progress, first + count, all);
    }
    jlt_progress_end(&progress);
    jlt_map_batch_images_clear(&images);
    free(q);
    if (jlt_motion_interrupted(&o->motion)) fprintf(stderr, "jellett: interrupted; whole rows are saved in %s\n", table->path);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "chart");
}

/* The maps of a chart: in lanes, unless a method was asked for. */
static jlt_status open_maps(jlt_map_batch **out, options *o, const jlt_system *system, bool has_method)
{
    const jlt_kernel_batch *kernels = has_method ? NULL : jlt_batch_isa_best(system->instance->descriptor, 0);
    jlt_status st;

    if (o->threads == 0) o->threads = jlt_common_processors();
    st = jlt_map_batch_create(out, &system->flow, kernels, NULL, (unsigned)o->threads);
    if (st == JLT_OK) o->motion.in_lanes = jlt_map_batch_in_lanes(*out); /* says the header */
    return st;
}

static const jlt_swept_form swept = { &jlt_command_lyapunov, true, 2 };

static jlt_exit run(int argc, char **argv)
{
    options o = { .returns = 0 };
    jlt_common *common = &o.motion.common;
    jlt_system *system = NULL;
    jlt_map *map = NULL;
    jlt_map_batch *maps = NULL;
    jlt_grid_axis axes[JLT_CHART_DIM_MAX];
    jlt_motion_map picture = { .points = NULL };
    jlt_exit code;
    jlt_status st;

    jlt_motion_begin(&o.motion, argc, argv);
    o.motion.flow.method = NULL;
    argp_parse(&parser, argc, argv, 0, NULL, &o);
    if (jlt_swept_done(&code, &swept, &o.motion.common)) goto done;
    const bool has_method = o.motion.flow.method != NULL;
    if (!has_method) o.motion.flow.method = jlt_method_find(NULL);
    code = jlt_motion_system(&system, &o.motion);
    if (code == JLT_EXIT_DONE && o.motion.grid == NULL) code = jlt_motion_default_start(&o.motion, system, JLT_START_CHAOTIC, "say where to start: --grid, or --start");
    if (code == JLT_EXIT_DONE && o.motion.starts[0] != NULL) code = jlt_motion_check_starts(system, o.motion.starts, 1);
    if (code == JLT_EXIT_DONE && o.motion.grid != NULL) code = jlt_motion_axes(axes, system, o.motion.grid, "--grid");
    if (code == JLT_EXIT_DONE && o.motion.grid != NULL) code = jlt_motion_map_open(&picture, &o.motion, system, o.motion.grid, axes);
    if (code == JLT_EXIT_DONE) code = jlt_common_write(common);
    if (code != JLT_EXIT_DONE) goto done;
    if (o.motion.grid != NULL) system->flow.max_steps = 20000;
    st = jlt_map_create(&map, &system->flow);
    if (st == JLT_OK && o.motion.grid != NULL) st = open_maps(&maps, &o, system, has_method);
    if (st != JLT_OK) {
        code = jlt_motion_fail(st, system, "the map");
        goto done;
    }
    jlt_motion_header(common->table.file, &o.motion, system);
    code = o.motion.grid != NULL ? run_chart(&picture, map, maps, &o, axes) : run_history(map, &o, system);
    if (code == JLT_EXIT_DONE) code = jlt_common_save(common);
    if (code == JLT_EXIT_DONE && common->plot != NULL)
        code = o.motion.grid != NULL ? draw_chart(&o, system, &picture) : draw_history(&o, system);
done:
    jlt_map_destroy(map);
    jlt_map_batch_destroy(maps);
    jlt_system_destroy(system);
    jlt_motion_end(&o.motion);
    jlt_motion_map_close(&picture);
    return code;
}

const jlt_command jlt_command_lyapunov = {
    "lyapunov", "[MODEL] [OPTION...]", "Lyapunov exponents with their convergence, or a chart of finite-time exponents", run, &parser
};
