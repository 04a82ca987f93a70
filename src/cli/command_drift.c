/* `jellett drift`: how far integrals drift along an orbit, by every method. */
#include "base/options.h"
#include "cli/interrupt.h"
#include "cli/motion_many.h"
#include "cli/progress.h"
#include "cli/swept.h"
#include "kernel/descriptor.h"
#include "report/csv.h"
#include "report/symbol.h"
#include "scene/drift_whole.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PROJECT = 2000, METHODS_MAX = 16 };

typedef struct {
    jlt_motion_options motion;
    size_t returns;
    bool project;
} options;

typedef struct {
    jlt_drift drift;
    jlt_drift_whole whole;                 /* the model asked for in all its states, in which the levels are integrals */
    const char *names[JLT_INVARIANTS_MAX]; /* of the integrals that are watched */
    FILE *file, *points;                   /* points: the same for a picture, or NULL */
    jlt_progress progress;
    size_t made, all;                      /* returns of all methods together: made so far, set atomically; wanted */
} report;

/* One method's part. */
typedef struct {
    report *whole;
    const jlt_method *method;
    jlt_drift drift;
    FILE *file, *points, *notes; /* in memory: rows; the same for a picture, or NULL; comments for the end of the table */
    char *text[3];               /* what was written to file, notes and points */
    size_t size[3];
    jlt_drift_row rows[JLT_DRIFT_ROWS_MAX];
    size_t row_count;
    jlt_status status;
} part;

static const struct argp_option option_table[] = {
    { "start", 'a', "NAME=VALUE,...", 0,
      "The start on the section: a value for every coordinate; for the spherical top default a regular orbit", 1 },
    { "returns", 'n', "N", 0, "Follow the orbit for N returns; default 10000", 1 },
    { "project", PROJECT, NULL, 0,
      "After every step, put the orbit back onto the levels that the integrals have at the start (one-step methods only)", 1 },
    { 0 },
};

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { &jlt_motion_many_argp, 0, NULL, 0 },
                                              { &jlt_swept_argp, 0, NULL, 0 }, { 0 } };

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case 'a': jlt_motion_one_start(&o->motion, value); return 0;
    case 'n': jlt_common_count(&o->returns, value, 1, (size_t)1 << 40, "--returns"); return 0;
    case PROJECT: o->project = true; return 0;
    case ARGP_KEY_END: jlt_plot_check_log(&o->motion.common, "xy", state); return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Measure how far the integrals that a table proves drift along an orbit, by every method, or by that of --method. For the "
    "spherical top in the five states of system (3.2) in regular time, where no integral is built in. For other tables: on "
    "--section."
    "\vColumns:\n"
    "  method, returns, t: the method, number of returns, and time\n"
    "  evaluations       evaluations of the field since the start\n"
    "  drift_NAME        of each integral F: the largest |F - F(start)| at a return\n"
    "                    so far, over |F(start)|; not divided where F(start) is 0,\n"
    "                    or rounding of 0\n\n"
    "Rows are at powers of two and at the end. Comment lines at the end have the slopes: the powers of the number of returns "
    "with which the drifts grow, fitted over the last four doublings. Where the orbit ends before all returns, they have its "
    "fate instead: pole+, pole-, equilibrium or left_domain, as in `jellett section --help`, with its time and the returns until "
    "then. Where no method returns at all, the status is 3.\n\n"
    "Examples:\n"
    "  jellett drift --returns 1000000 --method gauss --tol 1e-13\n"
    "  jellett drift toda --section q1=0 \\\n"
    "    --start q2=0.1,q3=-0.1,p1=0.2,p2=0,p3=-0.2",
    children, NULL, NULL,
};

static bool tell(void *context, const jlt_drift_row *row, bool due)
{
    part *self = context;

    if (due) {
        self->rows[self->row_count++] = *row;
        fprintf(self->file, "%s,%zu,", self->method->name, row->returns);
        jlt_csv_value(self->file, row->t);
        fprintf(self->file, ",%zu", row->evaluations);
        double point[1 + JLT_INVARIANTS_MAX] = { (double)row->returns };
        for (unsigned k = 0; k < self->drift.count; k++) {
            fprintf(self->file, ",%.3g", row->drift[k]);
            point[1 + k] = jlt_plot_drift(row->drift[k]);
        }
        fputc('\n', self->file);
        if (self->points != NULL) jlt_look_row(self->points, point, 1 + self->drift.count);
    }
    jlt_progress_show(&self->whole->progress, __atomic_add_fetch(&self->whole->made, 1, __ATOMIC_RELAXED), self->whole->all);
    return !ferror(self->file);
}

static bool asked(const options *o, const jlt_method *method)
{
    if (o->motion.flow.method != NULL) return o->motion.flow.method == method;
    return !(o->project && method->multistep);
}

/* Write the slopes of drift over returns, for integrals with enough rows to fit a line. */
static void write_slopes(const part *self)
{
    unsigned told = 0;

    for (unsigned k = 0; k < self->drift.count; k++) {
        const double power = jlt_drift_slope(self->rows, self->row_count, k);
        if (isnan(power)) continue;
        fprintf(self->notes, told++ == 0 ? "# %s: %s drifts as returns^%.2f" : "%.0s, %s as returns^%.2f", self->method->name,
                self->whole->names[k], power);
    }
    if (told > 0) fputc('\n', self->notes);
}

static void follow(part *self)
{
    const jlt_drift_whole *whole = &self->whole->whole;
    jlt_drift_end end;

    if (self->points != NULL) fprintf(self->points, "$%s << END\n", self->method->name);
    self->status = whole->instance == NULL ? jlt_drift_section(&self->drift, &end, self->method)
                                           : jlt_drift_whole_follow(&self->drift, &end, self->method, whole);
    if (self->points != NULL) fputs("END\n", self->points);
    if (self->status != JLT_OK) return;
    if (end.name[0] == '\0') {
        write_slopes(self);
        return;
    }
    fprintf(self->notes, "# %s: ends by %s at t = ", self->method->name, end.name);
    jlt_csv_value(self->notes, end.t);
    fprintf(self->notes, ", after %zu returns\n", end.returns);
}

static bool open_part(part *self, report *r, const jlt_method *method)
{
    FILE **streams[] = { &self->file, &self->notes, &self->points };

    *self = (part){ .whole = r, .method = method, .drift = r->drift };
    self->drift.tell = tell;
    self->drift.context = self;
    for (size_t i = 0; i < (r->points != NULL ? 3 : 2); i++)
        if ((*streams[i] = open_memstream(&self->text[i], &self->size[i])) == NULL) return false;
    return true;
}

/* Close a stream in memory, and write its text to `to`, unless that is NULL. */
static void pass_on(FILE *to, FILE **from, const char *const *text)
{
    if (*from != NULL && fclose(*from) == 0 && to != NULL) fputs(*text, to);
    *from = NULL;
}

static jlt_exit verdict(const part *self)
{
    if (self->status == JLT_OK) return JLT_EXIT_DONE;
    return jlt_command_fail(jlt_command_exit(self->status), "%s: %s", self->method->name, jlt_status_text(self->status));
}

/* Follow the orbit by all methods, each on one thread. Out: *drawn, bit m is set if method m has rows. */
static jlt_exit run_all(report *r, const options *o, unsigned *drawn)
{
    part parts[METHODS_MAX];
    size_t count = 0;
    jlt_exit code = JLT_EXIT_DONE;

    for (size_t m = 0; jlt_method_at(m) != NULL && count < METHODS_MAX; m++)
        if (asked(o, jlt_method_at(m)) && !open_part(&parts[count++], r, jlt_method_at(m))) code = jlt_command_no_memory();
    r->all = count * r->drift.returns;
    jlt_progress_start(&r->progress, "returns");
    jlt_interrupt_spare(o->motion.threads);
#if defined(_OPENMP)
#pragma omp parallel for num_threads((int)o->motion.threads) schedule(dynamic, 1)
#endif
    for (size_t i = count; i > 0; i--) /* the last methods take longest: begin with them */
        if (code == JLT_EXIT_DONE && !jlt_motion_interrupted(&o->motion)) follow(&parts[i - 1]);
    jlt_progress_end(&r->progress);
    for (size_t i = 0; i < count; i++) {
        pass_on(r->file, &parts[i].file, (const char *const *)&parts[i].text[0]);
        pass_on(r->points, &parts[i].points, (const char *const *)&parts[i].text[2]);
        const jlt_exit failed = verdict(&parts[i]);
        if (failed != JLT_EXIT_DONE) code = failed;
        for (size_t m = 0; parts[i].row_count > 0 && jlt_method_at(m) != NULL; m++)
            if (jlt_method_at(m) == parts[i].method) *drawn |= 1u << m;
    }
    for (size_t i = 0; i < count; i++) {
        pass_on(r->file, &parts[i].notes, (const char *const *)&parts[i].text[1]);
        for (size_t k = 0; k < 3; k++) free(parts[i].text[k]);
    }
    return code;
}

static jlt_exit draw(const report *r, const options *o, unsigned drawn)
{
    const jlt_chart *chart = r->drift.system->flow.chart;
    unsigned series = 0;
    jlt_plot plot;
    FILE *stream;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    stream = plot.stream;
    fputs(o->motion.common.drawn, stream);
    jlt_plot_words(&plot, "Drift of the integrals from ");
    for (unsigned k = 0; k < chart->dim; k++) jlt_plot_value(&plot, chart->names[k], r->drift.q[k]);
    jlt_plot_words(&plot, "\n");
    jlt_motion_caption(&plot, r->drift.system, NULL);
    jlt_plot_value(&plot, "tolerance", o->motion.flow.tolerance);
    if (o->project) jlt_plot_words(&plot, ", projected");
    jlt_plot_log(&plot, 'x', "returns", JLT_EXTENT_OPEN, 10);
    jlt_plot_log(&plot, 'y', "drift ≥ 10^{−17}", JLT_EXTENT_OPEN, 10);
    fputs(JLT_LOOK_GRID "plot ", stream);
    for (size_t m = 0; jlt_method_at(m) != NULL; m++) {
        const char *name = jlt_method_at(m)->name;
        if ((drawn >> m & 1u) == 0) continue;
        for (unsigned k = 0; k < r->drift.count; k++) {
            fprintf(stream, "%s$%s using 1:%u ", series > 0 || k > 0 ? ", " : "", name, k + 2);
            jlt_look_pen(stream, plot.look, (jlt_pen){ "linespoints", .colour = series, .dash = k, .mark = series, .size = 0.4 });
            fprintf(stream, k == 0 ? " title '%s'" : " notitle", name);
        }
        series++;
    }
    for (unsigned k = 0; k < r->drift.count && r->drift.count > 1; k++) {
        fputs(", keyentry ", stream);
        jlt_look_pen(stream, plot.look, (jlt_pen){ "lines", .dash = k });
        fputs(" title '", stream);
        jlt_symbol_write(stream, r->names[k]);
        fputc('\'', stream);
    }
    fputc('\n', stream);
    return jlt_plot_draw(&plot);
}

/* Watch the integrals that are proved of this field, except those that change by a turn of the section's angle. */
static jlt_exit watch_proved(report *r, const jlt_descriptor *d)
{
    bool turns = false, left_out = false;

    for (unsigned i = 0; i < d->integral_count; i++) {
        if (!jlt_descriptor_proves(d, "integral", d->integrals[i].name)) continue;
        const jlt_status st = r->whole.instance == NULL ? jlt_drift_turns(&turns, r->drift.system, r->drift.q, i) : JLT_OK;
        if (st != JLT_OK) return jlt_motion_fail(st, r->drift.system, "--start");
        if (turns) {
            fprintf(stderr, "jellett: %s is another after a turn of %s, and returns do not count turns: its drift is left out\n",
                    d->integrals[i].name, d->states[r->drift.system->flow.chart->column].name);
            left_out = true;
            continue;
        }
        if (r->drift.count == JLT_INVARIANTS_MAX)
            return jlt_command_fail(JLT_EXIT_USAGE, "%s proves more than %d integrals; drift serves up to so many", d->model,
                                    JLT_INVARIANTS_MAX);
        r->names[r->drift.count] = d->integrals[i].name;
        r->drift.watched[r->drift.count++] = i;
    }
    if (r->drift.count > 0) return JLT_EXIT_DONE;
    for (const jlt_claim *claim = d->claims; claim->kind != NULL; claim++)
        if (strcmp(claim->kind, "integral") == 0 && claim->verdict == JLT_PROVED && claim->condition[0] != '\0')
            fprintf(stderr, "jellett: %s is an integral where %s, and is followed there in a 'variant' that sets this\n",
                    claim->name, claim->condition);
    return jlt_command_fail(JLT_EXIT_INPUT, "%s proves no %sintegral at these parameters: write 'integral NAME = ...' in its table",
                            d->model, left_out ? "other " : "");
}

/* Say which levels cannot drift, being parameters of the section's table, in which the orbit is followed after all. */
static void tell_fixed(const jlt_surface *surface)
{
    for (unsigned i = 0; i < surface->table->param_count; i++) {
        const char *name = surface->table->params[i].name;
        if (jlt_surface_value(surface, name) >= surface->params)
            fprintf(stderr, "jellett: %s has no drift: the orbit is followed in %s, where it is a parameter\n", name,
                    surface->table->model);
    }
}

/* Read the start, and choose the integrals: those of the whole model, else those of the section's table. */
static jlt_exit open_integrals(report *r, options *o)
{
    const jlt_system *system = r->drift.system;

    JLT_PASS(jlt_motion_default_start(&o->motion, system, JLT_START_REGULAR, "say where to start: --start"));
    JLT_PASS(jlt_motion_start(r->drift.q, system, o->motion.starts[0]));
    const jlt_status st = system->surface != NULL ? jlt_drift_whole_open(&r->whole, system, r->drift.q) : JLT_ERR_UNSUPPORTED;
    if (st != JLT_OK && st != JLT_ERR_UNSUPPORTED) return jlt_motion_fail(st, system, o->motion.starts[0]);
    if (st != JLT_OK && system->surface != NULL) tell_fixed(system->surface);
    return watch_proved(r, (st == JLT_OK ? r->whole.instance : system->instance)->descriptor);
}

/* Set up the projection onto levels. */
static jlt_exit project(report *r, jlt_system *system, const options *o)
{
    JLT_PASS(jlt_common_one_step(o->motion.flow.method));
    if (r->whole.instance == NULL) return jlt_motion_project(system);
    JLT_PASS(jlt_common_project(r->whole.instance->descriptor));
    const jlt_status st = jlt_drift_whole_project(&r->whole);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "--project");
}

static void write_header(const report *r, const options *o)
{
    const jlt_surface *surface = r->drift.system->surface;
    FILE *file = r->file;

    if (r->whole.instance != NULL) {
        const jlt_instance *whole = r->whole.instance;
        const char *const *names = surface->names + surface->params;
        const unsigned count = surface->count - surface->params;
        double levels[JLT_CHART_VALUES_MAX], *params = jlt_common_steady(&o->motion.common, whole->descriptor, whole->params);
        if (params == NULL) return;
        for (unsigned k = 0; k < count; k++)
            levels[k] = jlt_common_runs(&o->motion.common, names[k]) ? NAN : r->drift.system->values[surface->params + k];
        jlt_csv_header(file, &(jlt_csv_settings){ .command = o->motion.common.command, .descriptor = whole->descriptor,
                                                  .params = params, .level_count = count,
                                                  .level_names = names, .levels = levels });
        free(params);
        fputs("# levels", file);
        for (unsigned k = 0; k < count; k++) {
            if (isnan(levels[k])) continue;
            fprintf(file, " %s=", names[k]);
            jlt_csv_value(file, levels[k]);
        }
        fprintf(file, "; start %s; tolerance %.3g%s; nothing is random, so there is no seed\n", o->motion.starts[0],
                o->motion.flow.tolerance, o->project ? ", projected" : "");
    } else {
        jlt_motion_header(file, &o->motion, r->drift.system);
        fprintf(file, "# start %s%s\n", o->motion.starts[0], o->project ? ", projected" : "");
    }
    fputs("method,returns,t,evaluations", file);
    for (unsigned k = 0; k < r->drift.count; k++) fprintf(file, ",drift_%s", r->names[k]);
    fputc('\n', file);
}

static void close_report(report *r) { jlt_drift_whole_close(&r->whole); }

static const jlt_swept_form swept = { &jlt_command_drift, true, 4 };

static jlt_exit run(int argc, char **argv)
{
    JLT_CLEARED(jlt_motion_end) options o = { .returns = 10000 };
    JLT_OWNED(jlt_system) *system = NULL;
    JLT_CLEARED(close_report) report r = { .points = NULL };
    jlt_common *common = &o.motion.common;
    unsigned drawn = 0;
    jlt_exit code;

    jlt_motion_begin(&o.motion, argc, argv);
    jlt_motion_many_begin(&o.motion);
    o.motion.looks_at_integrals = true;
    ttc_options_parse(&parser, argc, argv, &o);
    if (jlt_swept_done(&code, &swept, &o.motion.common)) return code;
    JLT_PASS(jlt_motion_system(&system, &o.motion));
    r.drift = (jlt_drift){ .system = system, .returns = o.returns };
    JLT_PASS(open_integrals(&r, &o));
    if (o.project) JLT_PASS(project(&r, system, &o));
    JLT_PASS(jlt_motion_plan(system, &o.motion));
    JLT_PASS(jlt_common_write(common));
    r.file = common->table.file;
    r.points = common->points;
    write_header(&r, &o);
    code = run_all(&r, &o, &drawn);
    if (code != JLT_EXIT_DONE && drawn == 0) return code; /* no method has a row */
    const jlt_exit saved = jlt_common_save(common);
    if (saved != JLT_EXIT_DONE) code = saved;
    else if (jlt_motion_interrupted(&o.motion))
        fprintf(stderr, "jellett: interrupted; whole rows are saved in %s\n", common->table.path);
    else if (drawn == 0)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: the orbit ends before it returns, and nothing drifts: take another start, or, "
                                "where it ends by budget, more --max-steps",
                                o.motion.starts[0]);
    return code == JLT_EXIT_DONE && drawn != 0 && common->plot != NULL ? draw(&r, &o, drawn) : code;
}

const jlt_command jlt_command_drift = {
    "drift", "[MODEL] [OPTION...]", "How far integrals drift along an orbit, by every method, with slopes", run, &parser, NULL
};
