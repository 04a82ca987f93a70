/* `jellett portrait`: data and picture of the flow on M^2 of the balanced sphere. */
#include <math.h>
#include <string.h>

#include "base/options.h"
#include "cli/planned.h"
#include "cli/progress.h"
#include "cli/swept.h"
#include "core/memory.h"
#include "kernel/descriptor.h"
#include "report/csv.h"
#include "top/balanced.h"
#include "top/balanced_form.h"
#include "top/command_counterpart.h"

static const double pi = 3.14159265358979323846;
static const char *const names[] = { "E", "G", "F0" }; /* of the levels */

enum { LEVEL = 2000, ORBITS, UNTIL, TRAJECTORIES, AT, SAMPLES = 400, TRIES_MAX = 1000, PATIENCE = 20 };

typedef enum {
    JLT_PORTRAIT_ATTRACTED, /* followed to an attracting fixed point */
    JLT_PORTRAIT_POLE_PLUS,
    JLT_PORTRAIT_POLE_MINUS,
    JLT_PORTRAIT_WANDERING, /* none of these within the time */
    JLT_PORTRAIT_FATES
} jlt_portrait_fate;

typedef struct {
    jlt_session session;
    jlt_assign_list level;
    const char *trajectories; /* file for the orbits */
    size_t orbits;
    double until;

    jlt_counterpart counterpart;  /* of the model asked for */
    jlt_top top;                  /* with the general field and the parameters of JLT_DEFAULT_MODEL */
    const jlt_descriptor *model;
    double params[JLT_WAY_VALUES_MAX];
    double start[JLT_TOP_STATES]; /* all 0 if levels are given */
    jlt_balanced_levels levels;
    jlt_fixed_point fixed[4];
    unsigned fixed_count;
    bool fixed_curve;         /* the fixed points are not isolated */
    size_t fates[JLT_PORTRAIT_FATES];
} jlt_portrait_request;

static const struct argp_option option_table[] = {
    { "level", 'l', "E=VALUE,G=VALUE,F0=VALUE", TTC_OPTIONS_REPEATED,
      "Values of the three integrals; default those of --start", 1 },
    { "orbits", ORBITS, "N|0", 0, "Draw N orbits, followed forwards and backwards; default 60", 1 },
    { "until", UNTIL, "T", 0, "Follow orbits for this time each way, in the table's unit; default 20", 1 },
    { "trajectories", TRAJECTORIES, "FILE", 0, "Write the points of the orbits to FILE, as CSV", 1 },
    { "@level", AT, "LEVEL=VALUE,...", OPTION_HIDDEN, NULL, 1 },
    { 0 },
};

static const struct argp_child children[] = { { &jlt_session_argp, 0, NULL, 0 }, { &jlt_swept_argp, 0, NULL, 0 }, { 0 } };

static error_t parse(int key, char *value, struct argp_state *state)
{
    jlt_portrait_request *r = state->input;

    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case 'l': jlt_common_list(&r->level, value, "--level"); return 0;
    case ORBITS: jlt_common_count(&r->orbits, value, 0, 100000, "--orbits"); return 0;
    case UNTIL: jlt_common_positive(&r->until, value, "--until"); return 0;
    case TRAJECTORIES: r->trajectories = value; return 0;
    case AT:
        r->session.common.at_point = true;
        jlt_common_replace(&r->level, value);
        return 0;
    case ARGP_KEY_END:
        jlt_common_not_swept(&r->session.common, &r->level, "--level");
        if (r->trajectories != NULL && r->session.common.sweep != NULL)
            argp_error(state, "--trajectories: one file for all points of --sweep: leave it out");
        jlt_common_check_files(&r->session.common, "--trajectories", r->trajectories);
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "The balanced sphere (a3 = 0): compute the flow on the surface M^2 where E, G and F0 have given values: its fixed points in "
    "closed form, their stability by (4.5) of the paper, orbits, and a picture. Whether "
    "conditions of the model hold on the way is not looked at: `jellett simulate` tells."
    "\vColumns, one row a fixed point:\n"
    "  gamma3, v_nu, omega3: states of the fixed point\n"
    "  psi               angle of the horizontal angular momentum about the contact\n"
    "                    point, which is a constant vector in space\n"
    "  v_slip            velocity of the contact point along nu; its sign tells the\n"
    "                    two halves of M^2 apart\n"
    "  trace, determinant: of the linearization\n"
    "  re1, im1, re2, im2: the two eigenvalues that the integrals leave\n"
    "  type              of the fixed point\n\n"
    "Your own table is accepted if it has a proved `reduction` by spherical_top_balanced.tt.\n\n"
    "Examples:\n"
    "  jellett portrait --set I1=2/5,I3=1/4 \\\n"
    "    --start gamma3=0.5,v_nu=0.8,omega_tau=0,omega_n=0,omega3=0.9 --plot m2.svg\n"
    "  jellett portrait --set I1=2/5,I3=1/4 --level E=1,G=-0.2,F0=0.15",
    children, NULL, NULL,
};

/* ---- levels ---- */

static jlt_exit read_levels(jlt_portrait_request *r)
{
    double *const values[] = { &r->levels.E, &r->levels.G, &r->levels.F0 };
    bool given[3] = { false };

    if ((r->level.count > 0) == (r->session.start.count > 0))
        return jlt_command_fail(JLT_EXIT_USAGE, "say which surface: --level E=...,G=...,F0=..., or --start");
    if (r->session.start.count > 0) {
        JLT_PASS(jlt_session_start(&r->session));
        jlt_counterpart_look(&r->counterpart, r->start, r->session.x);
        jlt_balanced_levels_of(&r->levels, &r->top, r->start);
        return JLT_EXIT_DONE;
    }
    for (size_t i = 0; i < r->level.count; i++) {
        size_t k = 0;
        while (k < 3 && strcmp(names[k], r->level.items[i].name) != 0) k++;
        if (k == 3)
            return jlt_command_fail(JLT_EXIT_INPUT, "--level: there is no level '%s'; there are E, G, F0", r->level.items[i].name);
        *values[k] = r->level.items[i].value;
        given[k] = true;
    }
    for (size_t k = 0; k < 3; k++)
        if (!given[k]) return jlt_command_fail(JLT_EXIT_INPUT, "--level: give %s as well", names[k]);
    if (jlt_balanced_complete(&r->levels, &r->top) != JLT_OK)
        return jlt_command_fail(JLT_EXIT_INPUT, "no state has these levels: raise E, or take G or F0 nearer to 0");
    return JLT_EXIT_DONE;
}

static jlt_exit open_top(jlt_portrait_request *r)
{
    const jlt_claim *broken = NULL;
    size_t a3;

    JLT_PASS(jlt_session_open(&r->session));
    if (jlt_descriptor_param(r->session.descriptor, "a3", &a3)) {
        const char *given = jlt_assign_fraction(&r->session.common.set, "a3");
        if (given != NULL && strcmp(given, "0") != 0)
            return jlt_command_fail(JLT_EXIT_INPUT, "--set a3=%s: M^2 exists for the balanced sphere alone, a3 = 0", given);
        r->session.params[a3] = 0;
    }
    JLT_PASS(jlt_top_counterpart(&r->counterpart, &r->session, jlt_balanced_table, "M^2"));
    r->top = r->counterpart.top;
    const bool serves = jlt_balanced_serves(&broken);
    if (broken != NULL) return jlt_top_unproved(broken, "the tables built in", "M^2");
    if (!serves || !jlt_balanced_form_holds(&r->top))
        return jlt_command_fail(JLT_EXIT_INPUT, "M^2: the tables built in have other integrals or equations at a3 = 0 than those "
                                                "whose fixed points are known in closed form");
    r->model = jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL);
    jlt_top_write(r->params, r->model, &r->top);
    return JLT_EXIT_DONE;
}

/* ---- fixed points ---- */

static const char *type_of(const jlt_fixed_point *point)
{
    static const char *const kinds[] = { "repelling", "centre of the linearization", "attracting" };
    static const char *const foci[] = { "repelling focus", "centre of the linearization", "attracting focus" };
    return point->focus ? foci[point->kind] : kinds[point->kind];
}

static void write_header(FILE *file, const jlt_portrait_request *r)
{
    double levels[] = { r->levels.E, r->levels.G, r->levels.F0 };
    JLT_FREED double *params = jlt_common_steady(&r->session.common, r->session.descriptor, r->session.params);

    if (params == NULL) return;
    for (unsigned k = 0; k < 3; k++)
        if (jlt_common_runs(&r->session.common, names[k])) levels[k] = NAN;
    jlt_csv_header(file, &(jlt_csv_settings){ .command = r->session.common.command, .descriptor = r->session.descriptor,
                                              .params = params, .level_count = 3, .level_names = names, .levels = levels,
                                              .method = r->session.method->name, .tolerance = r->session.tolerance });
}

static void write_fixed_points(FILE *file, const jlt_portrait_request *r)
{
    write_header(file, r);
    fprintf(file, "# levels E=%.17g G=%.17g F0=%.17g, horizontal momentum %.17g; method %s, tolerance %.3g; nothing is random, so "
                  "there is no seed\n",
            r->levels.E, r->levels.G, r->levels.F0, r->levels.M, r->session.method->name, r->session.tolerance);
    if (r->counterpart.way != NULL)
        fprintf(file, "# the motion of %s, as its proved reduction '%s' says; states and levels below are of that table\n",
                r->model->model, r->counterpart.way->name);
    if (r->fixed_curve) fputs("# the fixed points of this level are not isolated: they fill a curve\n", file);
    fputs("gamma3,v_nu,omega3,psi,v_slip,trace,determinant,re1,im1,re2,im2,type\n", file);
    for (unsigned k = 0; k < r->fixed_count; k++) {
        const jlt_fixed_point *p = &r->fixed[k];
        const double row[] = { p->x[JLT_TOP_GAMMA3], p->x[JLT_TOP_V_NU], p->x[JLT_TOP_OMEGA3], p->psi, p->v_slip, p->trace,
                               p->determinant, p->re[0], p->im[0], p->re[1], p->im[1] };
        jlt_csv_values(file, row, sizeof row / sizeof *row);
        fprintf(file, ",%s\n", type_of(p));
    }
}

/* ---- orbits ---- */

typedef struct {
    double psi, gamma3, v_slip;
} point;

static point point_of(const jlt_portrait_request *r, const double *x)
{
    point p;

    jlt_balanced_from_state(&r->top, &p.gamma3, &p.v_slip, &p.psi, x);
    return p;
}

/* Whether the point lies within a hundredth of the fixed point, of v_slip in relation to its value there: in any units. */
static bool is_near(const point *p, const jlt_fixed_point *fixed)
{
    return fabs(p->gamma3 - fixed->x[JLT_TOP_GAMMA3]) < 0.01 && fabs(remainder(p->psi - fixed->psi, 2 * pi)) < 0.01
           && fabs(p->v_slip - fixed->v_slip) < 0.01 * fabs(fixed->v_slip);
}

static jlt_portrait_fate fate_of(const jlt_portrait_request *r, const jlt_course_row *row)
{
    const point here = point_of(r, row->x);

    if (row->end == JLT_END_POLE) return row->fate == JLT_FATE_POLE_PLUS ? JLT_PORTRAIT_POLE_PLUS : JLT_PORTRAIT_POLE_MINUS;
    for (unsigned k = 0; k < r->fixed_count; k++)
        if (r->fixed[k].kind == JLT_FIXED_ATTRACTING && is_near(&here, &r->fixed[k])) return JLT_PORTRAIT_ATTRACTED;
    return JLT_PORTRAIT_WANDERING;
}

/* Follow one orbit in one direction of time. The plotted line breaks where v_slip changes sign. */
static jlt_status follow(jlt_portrait_request *r, FILE *file, const double *start, int direction, size_t number)
{
    const jlt_question question = { .model = r->model, .params = r->params, .start = start };
    const jlt_course_options options = { .method = r->session.method, .tolerance = r->session.tolerance,
                                         .interrupt = r->session.interrupt };
    jlt_plan plan;
    JLT_OWNED(jlt_course) *course = NULL;
    jlt_course_row row;
    point last = point_of(r, start);

    JLT_PASS(jlt_plan_make(&plan, &question));
    JLT_PASS(jlt_course_create(&course, &plan, &question, &options));
    for (int i = 0; i <= SAMPLES; i++) {
        JLT_PASS(jlt_course_to(course, direction * r->until * i / SAMPLES, &row));
        if (row.end == JLT_END_INTERRUPT) break;
        const point now = point_of(r, row.x);
        if (r->session.common.points != NULL) {
            if (now.v_slip * last.v_slip < 0) fputs("\n", r->session.common.points);
            jlt_look_line(r->session.common.points, (const double[]){ last.psi, last.gamma3, last.v_slip },
                          (const double[]){ now.psi, now.gamma3, now.v_slip }, 3, (const double[]){ 2 * pi, 0 });
        }
        if (file != NULL) {
            const double values[] = { row.t, now.gamma3, now.psi, now.v_slip, row.x[JLT_TOP_V_NU], row.x[JLT_TOP_OMEGA_TAU],
                                      row.x[JLT_TOP_OMEGA_N], row.x[JLT_TOP_OMEGA3] };
            fprintf(file, "%zu,", number);
            jlt_csv_row(file, values, sizeof values / sizeof *values);
        }
        last = now;
        if (row.end == JLT_END_POLE) break;
    }
    if (r->session.common.points != NULL) fputs("\n", r->session.common.points);
    /* The orbit is continued beyond the plotted part until its fate is clear. */
    for (int i = 5; direction > 0 && i <= 4 * PATIENCE && row.end == JLT_END_TIME && fate_of(r, &row) == JLT_PORTRAIT_WANDERING;
         i++)
        JLT_PASS(jlt_course_to(course, r->until * i / 4, &row));
    if (direction > 0 && row.end != JLT_END_INTERRUPT) r->fates[fate_of(r, &row)]++;
    return JLT_OK;
}

static jlt_exit follow_all(jlt_portrait_request *r, FILE *file)
{
    jlt_progress progress;
    jlt_exit code = JLT_EXIT_DONE;
    size_t done = 0, tried = 0;

    if (file != NULL) {
        write_header(file, r);
        fputs("orbit,t,gamma3,psi,v_slip,v_nu,omega_tau,omega_n,omega3\n", file);
    }
    jlt_progress_start(&progress, "orbits");
    for (; code == JLT_EXIT_DONE && done < r->orbits && tried < r->orbits * TRIES_MAX; tried++) {
        double start[JLT_TOP_STATES];
        if (!jlt_balanced_start(&r->top, &r->levels, start, tried)) continue;
        for (int direction = -1; code == JLT_EXIT_DONE && direction <= 1; direction += 2) {
            const jlt_status st = follow(r, file, start, direction, done);
            if (st != JLT_OK) code = jlt_session_fail(st, "an orbit");
        }
        if (jlt_session_interrupted(&r->session)) break;
        jlt_progress_show(&progress, ++done, r->orbits);
    }
    jlt_progress_end(&progress);
    if (jlt_session_interrupted(&r->session))
        fprintf(stderr, "jellett: interrupted; the fixed points and %zu of %zu orbits are saved\n", done, r->orbits);
    r->orbits = done;
    return code;
}

/* Show the plan of the first orbit. */
static jlt_exit show_plan(const jlt_portrait_request *r)
{
    double start[JLT_TOP_STATES] = { 0 };
    const jlt_question question = { .model = r->model, .params = r->params, .start = start };
    jlt_plan plan;
    size_t tried = 0;

    while (tried < TRIES_MAX && !jlt_balanced_start(&r->top, &r->levels, start, tried)) tried++;
    const jlt_status st = jlt_plan_make(&plan, &question);
    if (st != JLT_OK) return jlt_session_fail(st, "portrait");
    jlt_planned_show(&plan, NULL);
    return JLT_EXIT_PLANNED;
}

/* Plot the half of M^2 where side * v_slip > 0. Columns of $ORBITS: psi, gamma3, v_slip; a blank line ends a line. */
static void draw_half(jlt_plot *plot, const jlt_portrait_request *r, int side)
{
    static const struct {
        unsigned colour, mark;
        const char *name;
    } kinds[] = { { 2, 3, "repelling" }, { 0, 7, "trace zero" }, { 4, 0, "attracting" } };

    fprintf(plot->stream, "set title 'half v_{slip} %c 0'\nplot $ORBITS using 1:(%d*$3>0?$2:NaN) ", side > 0 ? '>' : '<', side);
    jlt_look_pen(plot->stream, plot->look, (jlt_pen){ "lines", .colour = 7, .size = 0.1 });
    fputs(" notitle", plot->stream);
    for (unsigned kind = 0; kind < 3; kind++) {
        bool is_named = false;
        for (unsigned k = 0; k < r->fixed_count; k++) {
            if (r->fixed[k].kind != kind || !(side * r->fixed[k].v_slip > 0)) continue;
            fprintf(plot->stream, ", '+' using (%.17g):(%.17g) every ::0::0 ", r->fixed[k].psi, r->fixed[k].x[JLT_TOP_GAMMA3]);
            jlt_look_pen(plot->stream, plot->look,
                         (jlt_pen){ "points", .colour = kinds[kind].colour, .mark = kinds[kind].mark, .size = 1 });
            if (is_named) fputs(" notitle", plot->stream);
            else fprintf(plot->stream, " title '%s'", kinds[kind].name);
            is_named = true;
        }
    }
    fputs("\n", plot->stream);
}

/* Plot the orbits that were collected. Prints an error message on failure. */
static jlt_exit draw(const jlt_portrait_request *r)
{
    jlt_plot plot;

    if (jlt_plot_open(&plot, &r->session.common) != JLT_OK) return jlt_command_no_memory();
    jlt_plot_panels(&plot, 2, false);
    jlt_plot_block(&plot, "ORBITS", r->session.common.drawn);
    jlt_plot_words(&plot, "Flow on M²\n");
    jlt_session_caption(&plot, &r->session);
    jlt_plot_value(&plot, "E", r->levels.E);
    jlt_plot_value(&plot, "G", r->levels.G);
    jlt_plot_value(&plot, "F0", r->levels.F0);
    jlt_plot_words(&plot, "; of %zu orbits %zu are attracted, %zu end at pole +1, %zu at pole −1", r->orbits,
                   r->fates[JLT_PORTRAIT_ATTRACTED], r->fates[JLT_PORTRAIT_POLE_PLUS], r->fates[JLT_PORTRAIT_POLE_MINUS]);
    fputs(JLT_LOOK_GRID, plot.stream);
    jlt_plot_axis(&plot, 'x', "ψ [rad]", (jlt_extent){ -pi, pi }, 2 * pi);
    jlt_plot_axis(&plot, 'y', "γ_3", (jlt_extent){ -1, 1 }, 0);
    draw_half(&plot, r, 1);
    draw_half(&plot, r, -1);
    return jlt_plot_draw(&plot);
}

static void end_request(jlt_portrait_request *r)
{
    jlt_assign_clear(&r->level);
    jlt_session_end(r);
}

static const jlt_swept_form swept = { &jlt_command_portrait, true, 0 };

static jlt_exit run(int argc, char **argv)
{
    JLT_CLEARED(end_request) jlt_portrait_request r = { .orbits = 60, .until = 20 };
    JLT_CLEARED(jlt_stream_discard) jlt_stream trajectories = { 0 };
    jlt_common *common = &r.session.common;
    jlt_exit code;

    jlt_session_begin(&r.session, argc, argv);
    ttc_options_parse(&parser, argc, argv, &r);
    if (jlt_swept_done(&code, &swept, &r.session.common)) return code;
    JLT_PASS(open_top(&r));
    JLT_PASS(read_levels(&r));
    if (r.session.common.plan) JLT_PASS(show_plan(&r));
    JLT_PASS(jlt_common_write(common));
    if (r.trajectories != NULL) JLT_PASS(jlt_stream_open(&trajectories, r.trajectories));
    if (!jlt_balanced_fixed_like(r.fixed, &r.fixed_count, &r.top, r.start))
        r.fixed_curve = jlt_balanced_fixed_points(r.fixed, &r.fixed_count, &r.top, &r.levels) == JLT_ERR_UNSUPPORTED;
    write_fixed_points(common->table.file, &r);
    if (common->points != NULL || r.trajectories != NULL) JLT_PASS(follow_all(&r, trajectories.file));
    JLT_PASS(jlt_common_save(common));
    if (r.trajectories != NULL) JLT_PASS(jlt_stream_close(&trajectories));
    return common->plot != NULL ? draw(&r) : JLT_EXIT_DONE;
}

const jlt_command jlt_command_portrait = {
    "portrait", "[MODEL] --level ...|--start ... [OPTION...]",
    "a3 = 0: the flow on M^2, its fixed points, their stability, a picture", run, &parser, NULL
};
