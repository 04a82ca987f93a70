#include "cli/motion.h"
#include "cli/progress.h"
#include "integrate/rest.h"
#include "kernel/descriptor.h"
#include "report/csv.h"
#include "scene/conserved.h"
#include "scene/tier.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WATCHED = 2, ROWS_MAX = 64, PROJECT = 2000, STATES = JLT_TOP_STATES + 1 };

typedef struct {
    jlt_motion_options motion;
    const char *start;
    size_t returns;
    bool project;
} options;

static const struct argp_option option_table[] = {
    { "start", 'a', "eta=VALUE,gamma3=VALUE", 0, "Start on the section; default eta=0.44,gamma3=-0.62, a regular orbit", 1 },
    { "returns", 'n', "N", 0, "Returns; default 10000", 1 },
    { "project", PROJECT, NULL, 0, "After every step back onto the levels of the start (one-step methods)", 1 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT: state->child_inputs[0] = &o->motion; return 0;
    case 'a': o->start = value; return 0;
    case 'n': jlt_common_count(&o->returns, value, 1, (size_t)1 << 40, "--returns"); return 0;
    case PROJECT: o->project = true; return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { 0 } };

static const struct argp parser = {
    option_table, parse, "",
    "How far E and G drift along an orbit of the spherical top, by every method or by that of --method, in the five states of "
    "system (3.2) in regular time, where no integral is built in."
    "\vColumns: method, returns, t, evaluations, drift_E, drift_G: of the field since the start, and the largest |F - F(start)|/"
    "|F(start)| at a return so far (not divided where F(start) = 0); rows at powers of two and at the end. Comment lines at the end have the slopes: the "
    "powers of the number of returns with which the drifts grow, fitted over the last four doublings; or, where the orbit ends before all returns are done, its end: pole+, pole- or "
    "equilibrium, as in jellett section --help, with its time and the returns until then.\n\n"
    "  jellett drift --returns 1000000 --method gauss --tol 1e-13",
    children, NULL, NULL,
};

typedef struct {
    double returns, t, drift[WATCHED];
    size_t evaluations;
} sample;

/* Power of the returns with which the drift grows: the slope of a line through the logarithms. */
static double slope(const sample *rows, size_t count, unsigned k)
{
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;

    for (size_t i = 0; i < count; i++) {
        if (!(rows[i].drift[k] > 0) || rows[i].returns * 16 < rows[count - 1].returns) continue;
        const double u = log(rows[i].returns), v = log(rows[i].drift[k]);
        n++, x += u, y += v, xx += u * u, xy += u * v;
    }
    return n < 3 ? NAN : (n * xy - x * y) / (n * xx - x * x);
}

/* The start on the section as the tier five has it, in the flow's units. */
static jlt_status lift(double *x, const jlt_system *system, const double *q)
{
    double level[JLT_CHART_STATES_MAX];
    const jlt_status st = system->flow.chart->lift(system->flow.chart, level, NULL, q);

    if (st != JLT_OK) return st;
    memcpy(x, level, 3 * sizeof *x);
    jlt_chart_top_rotation(&system->flow_chart, &x[JLT_TOP_OMEGA_N], &x[JLT_TOP_OMEGA3], level);
    x[JLT_TOP_STATES] = level[JLT_CHART_TOP_S];
    return JLT_OK;
}

typedef struct {
    const options *o;
    jlt_stream *stream;
    FILE *points;
    jlt_field field;
    jlt_conserved conserved;
    jlt_invariants invariants;
    double start[STATES];
    int time; /* binary exponent of its unit */
    jlt_progress progress;
    unsigned drawn; /* bit k: method k has points in the picture */
} run_state;

static void write_row(run_state *r, const jlt_method *method, const sample *row, sample *rows, size_t *count)
{
    rows[(*count)++] = *row;
    fprintf(r->stream->file, "%s,%.0f,", method->name, row->returns);
    jlt_csv_value(r->stream->file, row->t);
    fprintf(r->stream->file, ",%zu,%.3g,%.3g\n", row->evaluations, row->drift[0], row->drift[1]);
    if (r->points != NULL) fprintf(r->points, "%.0f %.4g %.4g\n", row->returns, row->drift[0], row->drift[1]);
}

/* What may come before all returns are done. */
typedef struct {
    jlt_rest_watch rest;
    double limit[STATES];
    const char *name; /* as fates are called; NULL: none */
    double t;         /* in the table's unit */
    size_t returns;
} ending;

static int watch(void *context, jlt_orbit *orbit)
{
    ending *end = context;
    return jlt_rest_watch_step(&end->rest, jlt_orbit_stepper(orbit), end->limit);
}

static void end_by(ending *end, const jlt_outcome *at, double t, size_t returns)
{
    const jlt_fate fate = at->end == JLT_END_OBSERVER ? JLT_FATE_EQUILIBRIUM : at->x[JLT_TOP_GAMMA3] > 0 ? JLT_FATE_POLE_PLUS : JLT_FATE_POLE_MINUS;

    end->name = jlt_section_fate_name(fate);
    end->t = t;
    end->returns = returns;
}

/* One method over all returns, or to the orbit's end. Errors: those of the orbit. */
static jlt_status follow(run_state *r, sample *rows, size_t *count, ending *end, const jlt_method *method)
{
    const jlt_event section = { .column = JLT_TOP_OMEGA_TAU, .direction = r->o->motion.flow.direction };
    const jlt_options to_orbit = { .tolerance = r->o->motion.flow.tolerance, .interrupt = r->o->motion.flow.interrupt,
                                   .max_steps = 100000, /* of one return, as on sections */
                                   .invariants = r->invariants, .project = r->o->project };
    double first[JLT_INVARIANTS_MAX], now[JLT_INVARIANTS_MAX];
    jlt_orbit *orbit = NULL;
    jlt_outcome at = { .t = 0 };
    sample row = { .returns = 0 };
    bool written = true;
    jlt_status st = JLT_OK;

    *count = 0;
    *end = (ending){ .name = NULL };
    r->invariants.values(r->start, r->invariants.p, first);
    JLT_TRY(jlt_orbit_create(&orbit, method, &r->field, &to_orbit));
    jlt_orbit_observe(orbit, watch, end);
    JLT_TRY(jlt_orbit_start(orbit, 0, r->start, 1));
    for (size_t i = 1, next = 1; i <= r->o->returns && !ferror(r->stream->file); i++) {
        end->rest = (jlt_rest_watch){ 0 };
        JLT_TRY(jlt_orbit_next(orbit, INFINITY, &section, 1, &at));
        if (at.end == JLT_END_INTERRUPT) break;
        if (at.end != JLT_END_EVENT) {
            end_by(end, &at, ldexp(at.t, r->time), i - 1);
            break;
        }
        r->invariants.values(at.x, r->invariants.p, now);
        row.returns = (double)i;
        row.t = ldexp(at.t, r->time);
        row.evaluations = jlt_orbit_stepper(orbit)->evaluations;
        for (unsigned k = 0; k < WATCHED; k++)
            row.drift[k] = fmax(row.drift[k], fabs(now[k] - first[k]) / (first[k] != 0 ? fabs(first[k]) : 1));
        written = i == next || i == r->o->returns;
        if (written) write_row(r, method, &row, rows, count);
        if (i == next) next *= 2;
        jlt_progress_show(&r->progress, i, r->o->returns);
    }
    if (!written && end->name != NULL) write_row(r, method, &row, rows, count);
done:
    jlt_orbit_destroy(orbit);
    return st;
}

static bool asked(const options *o, const jlt_method *method)
{
    if (o->motion.flow.method != NULL) return o->motion.flow.method == method;
    return !(o->project && method->multistep);
}

static jlt_exit run_all(run_state *r)
{
    char *slopes = NULL;
    size_t size;
    FILE *notes = open_memstream(&slopes, &size);
    jlt_exit code = JLT_EXIT_DONE;

    if (notes == NULL) return jlt_command_no_memory();
    for (size_t m = 0; jlt_method_at(m) != NULL && !jlt_motion_interrupted(&r->o->motion); m++) {
        const jlt_method *method = jlt_method_at(m);
        sample rows[ROWS_MAX];
        ending end;
        size_t count;
        if (!asked(r->o, method)) continue;
        if (r->points != NULL) fprintf(r->points, "$%s << END\n", method->name);
        jlt_progress_start(&r->progress, method->name);
        const jlt_status st = follow(r, rows, &count, &end, method);
        jlt_progress_end(&r->progress);
        if (r->points != NULL) fputs("END\n", r->points);
        if (count > 0) r->drawn |= 1u << m;
        if (st == JLT_ERR_UNSUPPORTED) code = jlt_command_fail(JLT_EXIT_INPUT, "--project: one-step methods alone, not the multistep method %s", method->name);
        else if (st != JLT_OK) code = jlt_command_fail(jlt_command_exit(st), "%s: %s", method->name, jlt_status_text(st));
        else if (end.name != NULL)
            fprintf(notes, "# %s: ends by %s at t = %.17g, after %zu returns\n", method->name, end.name, end.t, end.returns);
        else if (!isnan(slope(rows, count, 0)) && !isnan(slope(rows, count, 1))) /* three rows that drift, to fit a line */
            fprintf(notes, "# %s: E drifts as returns^%.2f, G as returns^%.2f\n", method->name, slope(rows, count, 0),
                     slope(rows, count, 1));
    }
    if (fclose(notes) == 0) fputs(slopes, r->stream->file);
    free(slopes);
    return code;
}

static jlt_exit draw(const run_state *r, const jlt_system *system, const char *points)
{
    jlt_command_output script;
    size_t colour = 0;
    FILE *stream;

    if (jlt_command_open(&script) != JLT_OK) return jlt_command_no_memory();
    stream = script.stream;
    fprintf(stream, "set encoding utf8\n%sset title \"Drift of the integrals, ", points);
    jlt_motion_caption(stream, system, NULL);
    fprintf(stream, "\\nstart %s, tolerance %.3g%s\" noenhanced\n", r->o->start, r->o->motion.flow.tolerance,
            r->o->project ? ", projected" : "");
    fputs("set logscale xy\nset format '10^{%T}'\nset xlabel \"returns\"\nset ylabel \"relative drift: E solid, G dashed\"\n"
          "set grid\nset key top left\nplot ", stream);
    for (size_t m = 0; jlt_method_at(m) != NULL; m++) {
        const char *name = jlt_method_at(m)->name;
        if ((r->drawn >> m & 1u) == 0) continue;
        fprintf(stream, "%s$%s using 1:2 with lines lw 2 lc %zu title '%s', $%s using 1:3 with lines dt 2 lc %zu notitle",
                colour > 0 ? ", " : "", name, colour + 1, name, name, colour + 1);
        colour++;
    }
    fputc('\n', stream);
    return jlt_common_draw(&r->o->motion.common, &script);
}

/* The tier five, with its parameters and the start. */
static jlt_exit open_five(run_state *r, jlt_instance **instance, const jlt_system *system)
{
    const jlt_tier *five = jlt_tier_find("five");
    const jlt_top_values *v = &system->values;
    const double params[] = { v->m, v->R, v->g, v->a3, v->I1, v->I3 };
    double q[JLT_CHART_DIM_MAX];
    jlt_exit code = jlt_motion_start(q, system, r->o->start);
    jlt_status st;

    if (code != JLT_EXIT_DONE) return code;
    const jlt_descriptor *general = jlt_descriptor_find(five->model, NULL, five->time, five->elimination);
    if (general == NULL || general->param_count != sizeof params / sizeof *params)
        return jlt_command_fail(JLT_EXIT_NUMERICAL, "the table of spherical_top is not the one this command knows");
    st = lift(r->start, system, q);
    const jlt_units units = jlt_chart_top_units(&system->chart.top);
    r->time = units.time;
    if (st == JLT_OK) st = jlt_instance_create_in(instance, general, params, &units);
    if (st == JLT_OK) st = jlt_field_of(&r->field, general, (*instance)->block);
    if (st == JLT_OK) st = jlt_conserved_of(&r->invariants, &r->conserved, general, &r->field);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, r->o->start);
}

static jlt_exit run(int argc, char **argv)
{
    options o = { .start = "eta=0.44,gamma3=-0.62", .returns = 10000 };
    jlt_stream stream = { 0 };
    run_state r = { .o = &o, .stream = &stream };
    jlt_system *system = NULL;
    jlt_instance *instance = NULL;
    char *points = NULL;
    size_t size;
    jlt_exit code;

    jlt_motion_begin(&o.motion, argc, argv);
    o.motion.flow.method = NULL;
    argp_parse(&parser, argc, argv, 0, NULL, &o);
    code = jlt_motion_top(&system, &o.motion, "E and G");
    if (code == JLT_EXIT_DONE) code = open_five(&r, &instance, system);
    if (code == JLT_EXIT_DONE) code = jlt_stream_open(&stream, o.motion.common.output);
    if (code != JLT_EXIT_DONE) goto done;
    if (o.motion.common.plot != NULL) r.points = open_memstream(&points, &size);
    jlt_csv_header(stream.file, &(jlt_csv_settings){ .command = o.motion.common.command, .descriptor = instance->descriptor,
                                                     .params = instance->params, .level_count = 2,
                                                     .level_names = (const char *const[]){ "E", "G" },
                                                     .levels = (const double[]){ system->values.E, system->values.G } });
    fprintf(stream.file, "# levels E=%.17g G=%.17g; start %s; tolerance %.3g%s; nothing is random, so there is no seed\n",
            system->values.E, system->values.G, o.start, o.motion.flow.tolerance, o.project ? ", projected" : "");
    fputs("method,returns,t,evaluations,drift_E,drift_G\n", stream.file);
    code = run_all(&r);
    if (r.points != NULL) fclose(r.points);
    {
        const jlt_exit closed = jlt_stream_close(&stream);
        if (closed != JLT_EXIT_DONE) code = closed;
        else if (jlt_motion_interrupted(&o.motion)) fprintf(stderr, "jellett: interrupted; whole rows are saved in %s\n", stream.path);
    }
    if (code == JLT_EXIT_DONE && r.drawn != 0 && points != NULL) code = draw(&r, system, points);
done:
    jlt_stream_discard(&stream);
    jlt_instance_destroy(instance);
    jlt_system_destroy(system);
    jlt_motion_end(&o.motion);
    free(points);
    return code;
}

const jlt_command jlt_command_drift = {
    "drift", "[OPTION...]", "How far E and G drift along an orbit, by every method, with slopes", run
};
