#include "cli/motion_map.h"
#include "cli/progress.h"
#include "dynamics/lyapunov.h"
#include "report/csv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    jlt_motion_options motion;
    const char *start, *grid;
    size_t returns, skip;
} options;

enum { SKIP = 2000 };

static const struct argp_option option_table[] = {
    { "start", 'a', "NAME=VALUE,...", 0,
      "Start of the orbit, every coordinate of the section; of the spherical top a chaotic one by default", 1 },
    { "grid", 'g', "COUNTxCOUNT", 0, "A chart instead: finite-time exponents of a grid of starts, or of NAME=LOW:HIGH:COUNT,...", 1 },
    { "returns", 'n', "N", 0, "Returns; default 1000, or 10 for a chart", 1 },
    { "skip", SKIP, "N", 0, "Returns left out before, so that the orbit is on its attractor; t counts from there", 1 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &o->motion;
        state->child_inputs[1] = &o->motion.common;
        return 0;
    case 'a': o->start = value; return 0;
    case 'g': o->grid = value; return 0;
    case 'n': jlt_common_count(&o->returns, value, 1, 1000000000000, "--returns"); return 0;
    case SKIP: jlt_common_count(&o->skip, value, 0, 1000000000000, "--skip"); return 0;
    case ARGP_KEY_END:
        if (o->start != NULL && o->grid != NULL) argp_error(state, "--start and --grid exclude each other");
        if (o->grid == NULL && o->motion.common.axes != NULL) argp_error(state, "--axes are those of a chart: add --grid");
        if (o->grid == NULL) jlt_plot_check_log(&o->motion.common, "x", state);
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { &jlt_plot_axes_argp, 0, NULL, 0 }, { 0 } };

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Lyapunov exponents of the section's map, per time, with the history of their convergence; or a chart of finite-time "
    "exponents over the section. The exponents of the flow's direction and across the levels are zero and not shown."
    "\vColumns: return, t, lambda1, lambda2, ..., divergence: the mean divergence along the orbit, which the sum of the "
    "exponents tends to. Returns are shown at powers of two and at quarters between them. Chart: the coordinates, exponent, t; "
    "orbits that end before N returns have an empty exponent.\n\n"
    "  jellett lyapunov --start eta=0.02,gamma3=-0.61 --returns 20000 \\\n"
    "    --plot history.svg\n"
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

static jlt_exit draw_history(const options *o, const jlt_system *system, const char *points)
{
    double q[JLT_CHART_DIM_MAX];
    jlt_plot plot;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    jlt_plot_block(&plot, "HISTORY", points);
    jlt_plot_words(&plot, "Lyapunov exponents from ");
    (void)jlt_motion_start(q, system, o->start);
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

static jlt_exit run_history(jlt_stream *stream, char **points, jlt_map *map, options *o, const jlt_system *system)
{
    const jlt_chart *chart = system->flow.chart;
    history self = { .o = o, .dim = chart->dim, .next = 1, .file = stream->file };
    jlt_lyapunov_state state = { .returns = 0 };
    double q[JLT_CHART_DIM_MAX];
    size_t size;
    jlt_status st;
    jlt_exit code = jlt_motion_start(q, system, o->start);

    if (code != JLT_EXIT_DONE) return code;
    if (o->returns == 0) o->returns = 1000;
    if (o->motion.common.plot != NULL) self.points = open_memstream(points, &size);
    fputs("return,t", self.file);
    for (unsigned k = 0; k < chart->dim; k++) fprintf(self.file, ",lambda%u", k + 1);
    fputs(",divergence\n", self.file);
    jlt_progress_start(&self.progress, "returns");
    st = skip(map, q, o);
    if (st == JLT_OK) st = jlt_lyapunov_run(map, &state, q, o->returns, observe, &self);
    jlt_progress_end(&self.progress);
    if (self.points != NULL) fclose(self.points);
    if (jlt_motion_interrupted(&o->motion)) {
        fprintf(stderr, "jellett: interrupted after %zu returns; whole rows are saved in %s\n", state.returns, stream->path);
        return JLT_EXIT_DONE;
    }
    if (st == JLT_ERR_DOMAIN && state.returns > 0) {
        fprintf(stderr, "jellett: the orbit ends, at a pole or at rest, after %zu returns, t = %.10g: these are finite-time exponents\n",
                state.returns, state.t);
        return JLT_EXIT_DONE;
    }
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, o->start);
}

static jlt_exit draw_chart(const options *o, const jlt_system *system, jlt_motion_map *map)
{
    jlt_plot plot;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    jlt_plot_words(&plot, "Finite-time exponent over %zu return%s\n", o->returns, o->returns == 1 ? "" : "s");
    jlt_motion_caption(&plot, system, NULL);
    jlt_motion_map_frame(map, &plot);
    jlt_motion_map_palette(map, &plot, "exponent [1/s]");
    fputs("plot ", plot.stream);
    jlt_motion_map_plot(map, &plot, "2", "palette");
    fputs(" notitle\n", plot.stream);
    return jlt_plot_draw(&plot);
}

static jlt_exit run_chart(jlt_stream *stream, jlt_motion_map *picture, jlt_map *map, options *o, const jlt_grid_axis *axes)
{
    const jlt_system *system = picture->system;
    const jlt_chart *chart = system->flow.chart;
    jlt_progress progress;
    double q[JLT_CHART_DIM_MAX], from[JLT_CHART_DIM_MAX], exponent, t;
    const size_t all = jlt_motion_grid_size(axes, system);
    jlt_exit code = JLT_EXIT_DONE;

    if (o->returns == 0) o->returns = 10;
    for (unsigned k = 0; k < chart->dim; k++) fprintf(stream->file, "%s,", chart->names[k]);
    fputs("exponent,t\n", stream->file);
    jlt_progress_start(&progress, "starts");
    for (size_t i = 0; i < all && !jlt_motion_interrupted(&o->motion); i++) {
        jlt_status st;
        jlt_motion_grid_point(q, axes, system, i);
        memcpy(from, q, chart->dim * sizeof *q);
        st = skip(map, from, o);
        if (st == JLT_OK) st = jlt_lyapunov_finite(map, &exponent, &t, from, o->returns);
        jlt_csv_values(stream->file, q, chart->dim);
        fputc(',', stream->file);
        jlt_csv_row(stream->file, (const double[]){ st == JLT_OK ? exponent : NAN, st == JLT_OK ? t : NAN }, 2);
        jlt_motion_map_add(picture, q, st == JLT_OK ? exponent : NAN);
        jlt_progress_show(&progress, i + 1, all);
        if (st == JLT_ERR_NOMEM) code = jlt_motion_fail(st, system, "chart");
    }
    jlt_progress_end(&progress);
    if (jlt_motion_interrupted(&o->motion)) fprintf(stderr, "jellett: interrupted; whole rows are saved in %s\n", stream->path);
    return code;
}

static jlt_exit run(int argc, char **argv)
{
    options o = { .start = NULL };
    jlt_stream stream = { 0 };
    jlt_system *system = NULL;
    jlt_map *map = NULL;
    jlt_grid_axis axes[JLT_CHART_DIM_MAX];
    jlt_motion_map picture = { .points = NULL };
    char *points = NULL;
    jlt_exit code;
    jlt_status st;

    jlt_motion_begin(&o.motion, argc, argv);
    o.motion.flow.method = jlt_map_method();
    argp_parse(&parser, argc, argv, 0, NULL, &o);
    code = jlt_motion_system(&system, &o.motion);
    if (code == JLT_EXIT_DONE && o.grid == NULL) code = jlt_motion_default_start(&o.start, &o.motion, system, JLT_START_CHAOTIC, "say where to start: --grid, or --start");
    if (code == JLT_EXIT_DONE && o.start != NULL) code = jlt_motion_check_starts(system, &o.start, 1);
    if (code == JLT_EXIT_DONE && o.grid != NULL) code = jlt_motion_axes(axes, system, o.grid, "--grid");
    if (code == JLT_EXIT_DONE && o.grid != NULL) code = jlt_motion_map_open(&picture, &o.motion, system, o.grid, axes);
    if (code == JLT_EXIT_DONE) code = jlt_stream_open(&stream, o.motion.common.output);
    if (code != JLT_EXIT_DONE) goto done;
    if (o.grid != NULL) system->flow.max_steps = 20000;
    st = jlt_map_create(&map, &system->flow);
    if (st != JLT_OK) {
        code = jlt_motion_fail(st, system, "the map");
        goto done;
    }
    jlt_motion_header(stream.file, &o.motion, system);
    code = o.grid != NULL ? run_chart(&stream, &picture, map, &o, axes) : run_history(&stream, &points, map, &o, system);
    if (code != JLT_EXIT_DONE) goto done;
    code = jlt_stream_close(&stream);
    if (code == JLT_EXIT_DONE && picture.points != NULL) code = draw_chart(&o, system, &picture);
    if (code == JLT_EXIT_DONE && points != NULL) code = draw_history(&o, system, points);
done:
    jlt_stream_discard(&stream);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
    jlt_motion_end(&o.motion);
    jlt_motion_map_close(&picture);
    free(points);
    return code;
}

const jlt_command jlt_command_lyapunov = {
    "lyapunov", "[MODEL] [OPTION...]", "Lyapunov exponents with their convergence, or a chart of finite-time exponents", run
};
