#include <argp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/options.h"
#include "cli/grid.h"
#include "cli/session.h"
#include "kernel/descriptor.h"
#include "report/csv.h"
#include "report/decimal.h"
#include "top/command_counterpart.h"
#include "top/rod.h"

enum { SWEEP = 2000, CHECK, AXES_MAX = 3 };

typedef struct {
    jlt_session session;
    jlt_grid_axis axes[AXES_MAX];
    double *targets[AXES_MAX]; /* the entry of the session's params or x that an axis runs over */
    size_t axis_count, all; /* all: number of rows */
    size_t rows, empty, failed; /* written; those of them that are refused; that could not be computed or checked */
    bool check;
    jlt_extent extent[2]; /* of period and rotation number */
} request;

static const struct argp_option option_table[] = {
    { "sweep", SWEEP, "STATE|PARAM=LOW:HIGH:COUNT,...", 0,
      "Write one row for each point of a grid in these states or parameters", 1 },
    { "check", CHECK, NULL, 0,
      "Also integrate over one period (--tol is then 1e-15 by default), and write by how much the state misses the start", 1 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    request *r = state->input;

    switch (key) {
    case ARGP_KEY_INIT: state->child_inputs[0] = &r->session; return 0;
    case SWEEP: r->session.common.own_sweep = value; return 0;
    case CHECK: r->check = true; return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = { { &jlt_session_argp, 0, NULL, 0 }, { 0 } };

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "The limiting case I3 = 0 of the spherical top, by quadratures: compute the turning points and period of gamma3, and the "
    "rotation number, which is the turns of (v_nu, v_tau) in a period. Where E1 = 0, every orbit has this period. "
    "Whether conditions of the model hold on the way, such as contact, is not looked at: `jellett simulate` tells."
    "\vColumns:\n"
    "  STATE, PARAM      the values of --sweep\n"
    "  E1, E2, G         the integrals\n"
    "  gamma3_low, gamma3_high: the turning points\n"
    "  period, rotation  the period of gamma3, and the rotation number\n\n"
    "With --check also the distance from the start after one integrated period:\n"
    "  defect_gamma3     in gamma3\n"
    "  defect_turn       in radians; empty where E1 = 0\n"
    "  defect_state      in all five states, which vanishes only where E1 = 0\n\n"
    "Your own table is accepted if it has a proved `reduction` by spherical_top_level.tt.\n\n"
    "Examples:\n"
    "  jellett rod --set I1=0.7,a3=0.3 \\\n"
    "    --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1.3,omega3=-0.8 --check\n"
    "  jellett rod --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0 \\\n"
    "    --sweep omega_n=0.2:2:181 --plot rod.svg",
    children, NULL, NULL,
};

static jlt_exit bind_axes(request *r)
{
    jlt_session *s = &r->session;
    const char *sweep = s->common.own_sweep;
    size_t index;
    jlt_exit code = JLT_EXIT_DONE;

    if (sweep != NULL) code = jlt_grid_parse(r->axes, &r->axis_count, AXES_MAX, sweep, "--sweep");
    if (code == JLT_EXIT_DONE) code = jlt_grid_size(&r->all, r->axes, r->axis_count, sweep, "--sweep");
    for (size_t k = 0; code == JLT_EXIT_DONE && k < r->axis_count; k++) {
        if (strcmp(r->axes[k].name, "I3") == 0) code = jlt_command_fail(JLT_EXIT_INPUT, "--sweep: I3 is 0 here");
        else if (jlt_descriptor_param(s->descriptor, r->axes[k].name, &index)) r->targets[k] = &s->params[index];
        else if (jlt_descriptor_state(s->descriptor, r->axes[k].name, &index)) r->targets[k] = &s->x[index];
        else code = jlt_command_fail(JLT_EXIT_INPUT, "--sweep: there is no state or parameter '%s'", r->axes[k].name);
    }
    return code;
}

/* The direction of the velocity of the centre of mass, in radians. */
static double direction(const jlt_top *top, const double *x)
{
    return atan2(jlt_top_v_tau(top, x), x[JLT_TOP_V_NU]);
}

/* Integrate the same orbit over one period. Out: defects of gamma3, of the turn, and of all states. */
static jlt_status integrate(double defects[3], const request *r, const jlt_rod *rod)
{
    const jlt_session *s = &r->session;
    const jlt_question question = { s->descriptor, s->params, s->x, false, false, "level", NULL };
    const jlt_course_options options = { .method = s->method, .tolerance = s->tolerance, .interrupt = s->interrupt };
    const double pi = acos(-1), *x = s->x;
    jlt_plan plan;
    JLT_OWNED(jlt_course) *course = NULL;
    jlt_course_row row;
    double before[JLT_TOP_STATES], after[JLT_TOP_STATES], turn;

    JLT_PASS(jlt_plan_make(&plan, &question));
    JLT_PASS(jlt_course_create(&course, &plan, &question, &options));
    JLT_PASS(jlt_course_to(course, rod->period, &row));
    jlt_counterpart_look(&rod->counterpart, before, x);
    jlt_counterpart_look(&rod->counterpart, after, row.x);
    turn = direction(&rod->top, after) - direction(&rod->top, before);
    defects[0] = fabs(after[JLT_TOP_GAMMA3] - before[JLT_TOP_GAMMA3]);
    defects[1] = rod->E1 > 1e-24 * fabs(rod->E2) ? fabs(remainder(turn - rod->turn, 2 * pi)) : NAN;
    defects[2] = 0;
    for (int i = 0; i < JLT_TOP_STATES; i++) defects[2] = fmax(defects[2], fabs(row.x[i] - x[i]));
    return JLT_OK;
}

static jlt_status open_rod(jlt_rod *rod, const request *r)
{
    size_t index;

    JLT_PASS(jlt_descriptor_check_params(r->session.descriptor, r->session.params, &index));
    return jlt_rod_open(rod, r->session.descriptor, r->session.params, r->session.x);
}

static jlt_exit check_claims(const request *r)
{
    const jlt_claim *broken;
    const char *refusal = jlt_rod_refuses(&broken, r->session.descriptor, r->session.params, NULL);

    if (refusal == NULL) return JLT_EXIT_DONE;
    if (broken != NULL) return jlt_top_unproved(broken, "the tables built in", "quadratures");
    return jlt_command_fail(JLT_EXIT_INPUT, "quadratures do not serve: %s", refusal);
}

/* Without a sweep, the quadrature must have a value at the start. */
static jlt_exit check_start(const request *r)
{
    jlt_rod rod;
    const jlt_status st = r->axis_count > 0 ? JLT_OK : open_rod(&rod, r);

    if (st == JLT_OK) return JLT_EXIT_DONE;
    if (st != JLT_ERR_DOMAIN) return jlt_session_fail(st, "the quadrature");
    return jlt_command_fail(JLT_EXIT_INPUT, "G = 0: the orbit runs through the poles, and there is no quadrature for it "
                                            "(give omega_n a value other than 0)");
}

/* Compute and write a row, unless an interrupt came meanwhile, which cuts the check short. A point of a sweep that fails leaves
 * fields empty; the first is reported. */
static jlt_exit write_row(FILE *file, request *r)
{
    double values[10];
    const size_t count = r->check ? 10 : 7;
    const char *what = "the quadrature";
    jlt_rod rod;
    const jlt_status opened = open_rod(&rod, r);
    jlt_status st = opened;

    for (size_t i = 0; i < count; i++) values[i] = NAN;
    if (opened == JLT_OK) {
        const double row[] = { rod.E1, rod.E2, rod.G, rod.below - 1, 1 - rod.above, rod.period, jlt_rod_rotation(&rod) };
        memcpy(values, row, sizeof row);
        if (r->check) {
            what = "--check";
            st = integrate(values + 7, r, &rod);
        }
    }
    if (jlt_session_interrupted(&r->session)) return JLT_EXIT_DONE;
    if (st != JLT_OK && (r->axis_count == 0 || st == JLT_ERR_NOMEM)) return jlt_session_fail(st, what);
    if (opened == JLT_ERR_DOMAIN) r->empty++;
    else if (st != JLT_OK && r->failed++ == 0) {
        char where[JLT_GRID_PLACE_MAX];
        (void)jlt_grid_place(where, r->axes, r->axis_count, r->rows);
        fprintf(stderr, "jellett: at %s:\n", where);
        (void)jlt_session_fail(st, what);
    }
    if (opened == JLT_OK) {
        if (r->session.common.points != NULL && r->axis_count > 0)
            jlt_look_row(r->session.common.points, (const double[]){ *r->targets[0], values[5], values[6] }, 3);
        jlt_extent_add(&r->extent[0], values[5]);
        jlt_extent_add(&r->extent[1], values[6]);
    }
    for (size_t k = 0; k < r->axis_count; k++) {
        jlt_csv_value(file, *r->targets[k]);
        fputc(',', file);
    }
    jlt_csv_row(file, values, count);
    r->rows++;
    return JLT_EXIT_DONE;
}

static jlt_exit write_rows(FILE *file, request *r)
{
    jlt_exit code = JLT_EXIT_DONE;

    for (size_t k = 0; k < r->axis_count; k++) *r->targets[k] = NAN; /* omitted from the header, since it varies from row to row */
    jlt_csv_header(file, &(jlt_csv_settings){ .command = r->session.common.command, .descriptor = r->session.descriptor,
                                              .params = r->session.params });
    fputs("# start", file);
    jlt_decimal_write_named(file, r->session.descriptor->states, r->session.x, r->session.descriptor->state_count);
    fputs("; quadratures by adaptive Gauss-Kronrod to 2e-14; nothing is random, so there is no seed\n", file);
    for (size_t k = 0; k < r->axis_count; k++) fprintf(file, "%s,", r->axes[k].name);
    fprintf(file, "E1,E2,G,gamma3_low,gamma3_high,period,rotation%s\n",
            r->check ? ",defect_gamma3,defect_turn,defect_state" : "");
    while (code == JLT_EXIT_DONE && r->rows < r->all && !jlt_session_interrupted(&r->session)) {
        double values[AXES_MAX];
        jlt_grid_point(values, r->axes, r->axis_count, r->rows);
        for (size_t k = 0; k < r->axis_count; k++) *r->targets[k] = values[k];
        code = write_row(file, r);
    }
    if (r->empty > 0)
        fprintf(stderr, "jellett: %zu of %zu points have no values: G = 0, |gamma3| >= 1, or a parameter that %s does not allow\n",
                r->empty, r->rows, r->session.descriptor->model);
    if (r->failed > 0) fprintf(stderr, "jellett: %zu of %zu points failed\n", r->failed, r->rows);
    return code;
}

static jlt_exit draw(const request *r)
{
    static const char *const labels[] = { "period [s]", "rotation" };
    char label[JLT_LOOK_LABEL_MAX];
    jlt_plot plot;

    if (jlt_plot_open(&plot, &r->session.common) != JLT_OK) return jlt_command_no_memory();
    jlt_plot_panels(&plot, 2, true);
    *r->targets[0] = NAN; /* omitted from the caption, since it is on the axis of the plot */
    jlt_plot_block(&plot, "ROWS", r->session.common.drawn);
    jlt_plot_words(&plot, "Period and rotation number\n");
    jlt_session_caption(&plot, &r->session);
    jlt_plot_words(&plot, "; start ");
    for (unsigned i = 0; i < r->session.descriptor->state_count; i++)
        jlt_plot_value(&plot, r->session.descriptor->states[i].name, r->session.x[i]);
    jlt_plot_label(label, r->session.descriptor, r->axes[0].name);
    fputs(JLT_LOOK_GRID, plot.stream);
    for (unsigned k = 0; k < 2; k++) {
        jlt_plot_panel(&plot, k, label,
                       (jlt_extent){ fmin(r->axes[0].low, r->axes[0].high), fmax(r->axes[0].low, r->axes[0].high) });
        jlt_plot_axis(&plot, 'y', labels[k], jlt_extent_wider(r->extent[k]), 0);
        fprintf(plot.stream, "plot $ROWS using 1:%u ", k + 2);
        jlt_look_pen(plot.stream, plot.look,
                     r->all == 1 ? (jlt_pen){ "points", .colour = 2, .size = 0.8 } : (jlt_pen){ "lines", .colour = 2 });
        fputs(" notitle\n", plot.stream);
    }
    return jlt_plot_draw(&plot);
}

static jlt_exit run(int argc, char **argv)
{
    JLT_CLEARED(jlt_session_end) request r = { .extent = { JLT_EXTENT_NONE, JLT_EXTENT_NONE } };
    jlt_common *common = &r.session.common;
    jlt_counterpart found;
    size_t I3;

    jlt_session_begin(&r.session, argc, argv);
    r.session.tolerance = 1e-15;
    ttc_options_parse(&parser, argc, argv, &r);
    JLT_PASS(jlt_session_open(&r.session));
    if (jlt_descriptor_param(r.session.descriptor, "I3", &I3)) {
        const char *given = jlt_assign_fraction(&r.session.common.set, "I3");
        if (given != NULL && strcmp(given, "0") != 0)
            return jlt_command_fail(JLT_EXIT_INPUT, "--set I3=%s: the quadratures are those of I3 = 0", given);
        r.session.params[I3] = 0;
    }
    JLT_PASS(jlt_top_counterpart(&found, &r.session, jlt_rod_table, "quadratures"));
    JLT_PASS(check_claims(&r));
    JLT_PASS(jlt_session_start(&r.session));
    JLT_PASS(bind_axes(&r));
    if (r.session.common.plot != NULL && r.axis_count != 1)
        return jlt_command_fail(JLT_EXIT_USAGE, "--plot needs a --sweep of one quantity: vary one, or leave out --plot");
    JLT_PASS(check_start(&r));
    if (r.session.common.plan) {
        puts("  * quadrature: nothing is integrated in time");
        return JLT_EXIT_PLANNED;
    }
    JLT_PASS(jlt_common_write(common));
    JLT_PASS(write_rows(common->table.file, &r));
    JLT_PASS(jlt_common_save(common));
    if (jlt_session_interrupted(&r.session))
        fprintf(stderr, "jellett: interrupted; %zu whole rows are saved in %s\n", r.rows, common->table.path);
    const bool none = r.empty == r.all && r.axes[0].part == 0; /* of a part, other parts may have rows */
    const jlt_exit rows = r.failed > 0 ? JLT_EXIT_NUMERICAL : none ? JLT_EXIT_INPUT : JLT_EXIT_DONE;
    const jlt_exit drawn = common->plot != NULL ? draw(&r) : JLT_EXIT_DONE;
    return drawn > rows ? drawn : rows; /* a picture of nothing is bad input only where nothing failed */
}

const jlt_command jlt_command_rod = {
    "rod", "[MODEL] --start ... [OPTION...]",
    "I3 = 0 by quadratures: period, rotation number; a check by integration", run, &parser, NULL
};
