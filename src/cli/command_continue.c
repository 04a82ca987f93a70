/* `jellett continue`: follows a periodic orbit in a parameter or level, with its bifurcations. */
#include "base/options.h"
#include "cli/motion_family.h"
#include "cli/orbit_columns.h"
#include "cli/orbit_losses.h"
#include "cli/swept.h"
#include "dynamics/tree.h"
#include "report/csv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    jlt_motion_options motion;
    const char *along;
    size_t period, points, generations; /* generations: how many levels of branches to follow besides branch 0 */
    double step;
    int direction;
} options;

enum { ALONG = 2000, STEP, DOWN, FOLLOW, GENERATIONS };

static const struct argp_option option_table[] = {
    { "along", ALONG, "PARAM|LEVEL=LOW:HIGH", 0, "The parameter or level that varies, and its range", 1 },
    { "start", 'a', "NAME=VALUE,...", 0,
      "A point near the orbit: a value for every coordinate of the section; for the spherical top default the saddle of "
      "Figure 3", 1 },
    { "period", 'n', "N", 0, "The orbit closes after N returns; default 1", 1 },
    { "step", STEP, "VALUE", 0,
      "Arc length to the second point; later steps are at most 5 times as long; default 0.01. It is measured in the "
      "coordinates and the varying value together, this value divided by its largest or, if that is less, by four times its "
      "range", 1 },
    { "count", 'c', "N", 0, "Compute at most N points on a branch; default 500", 1 },
    { "decreasing", DOWN, NULL, 0, "Go towards smaller values first", 1 },
    { "branches", FOLLOW, NULL, 0,
      "On sections of two coordinates: also follow, once each, the branches that begin at branch points and period "
      "doublings of branch 0", 1 },
    { "generations", GENERATIONS, "N", 0,
      "Repeat --branches N times: also follow the branches that begin on those branches, and so on; default 1 with "
      "--branches", 1 },
    { 0 },
};

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { &jlt_plot_axes_argp, 0, NULL, 0 },
                                              { &jlt_swept_argp, 0, NULL, 0 }, { 0 } };

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case ALONG: o->along = value; return 0;
    case 'a': jlt_motion_one_start(&o->motion, value); return 0;
    case 'n': jlt_common_count(&o->period, value, 1, JLT_PERIODIC_MAX / 2, "--period"); return 0;
    case 'c': jlt_common_count(&o->points, value, 1, 10000000, "--count"); return 0;
    case STEP: jlt_common_positive(&o->step, value, "--step"); return 0;
    case DOWN: o->direction = -1; return 0;
    case FOLLOW: o->generations = o->generations == 0 ? 1 : o->generations; return 0;
    case GENERATIONS: jlt_common_count(&o->generations, value, 1, 1000000, "--generations"); return 0;
    case ARGP_KEY_END:
        if (o->along == NULL) jlt_common_incomplete(&o->motion.common, state, "say what runs: --along NAME=LOW:HIGH");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Follow a periodic orbit as one parameter or level varies, by pseudo-arclength, and find its bifurcations: folds, period "
    "doublings, branch points and, on a section of two coordinates, tori."
    "\vColumns, one row a point:\n"
    "  branch            0 is the orbit itself\n"
    "  PARAM or LEVEL    the value that varies (along_arc, if it is called arc)\n"
    "  arc               arc length along the branch\n"
    "  period ... residual: the orbit, as in `jellett orbits --help`\n"
    "  bifurcation       its kind; a bifurcation has a row of its own\n"
    "  low, high         the values at the nearest points found on both sides of it\n\n"
    "low and high are wide apart where a bifurcation could not be located, as steps may cease to converge there. Two within one "
    "step are missed where what they test, such as trace + 2, goes less than 1e-9 to the other side in between. A fold less "
    "than 1e-4 along the branch from a branch point is taken for that. At the end the command reports how many bifurcations have "
    "branches that were not followed.\n\n"
    "Examples:\n"
    "  jellett continue --along E=2:2.4\n"
    "  jellett continue --along a3=0.4:0.6 --branches --plot tree.svg > tree.csv\n"
    "  jellett continue roessler --section y=0 --direction down \\\n"
    "    --start x=-7.2,z=0 --along c=2:5.7",
    children, NULL, NULL,
};

/* Where points of branches are written, and what later ones need of those already written. */
typedef struct {
    FILE *file, *points;  /* the table; the picture's data, NULL: there is no picture */
    const jlt_chart *chart;
    unsigned shown[2];    /* on the picture's axes: 0, the value that runs; k > 0, coordinate k - 1 */
    size_t rows, branch;  /* rows written; branch of the last one, */
    double last[4];       /* and its row in the picture */
    jlt_extent extent[2]; /* of the picture */
    bool is_watched, is_told; /* the branch has had a point with all multipliers clear of the unit circle; a bifurcation after it */
    unsigned outside;         /* at the last such point, multipliers outside the circle, */
    double clear_at;          /* and the value that runs */
    jlt_system_family *systems;
    const jlt_observed *observed;
    jlt_orbit_losses losses; /* of the branch */
    unsigned kinds, lines; /* in the picture: bit k, bifurcations of kind k; bit k, orbits of which stability() is k */
} table;

static const double near = 1e-5; /* closer to the unit circle than this, rounding may decide the side */
static const char *const stabilities[] = { "stable", "unstable", "degenerate" };

static void write_point(const table *self, size_t branch, const jlt_continuation_point *point)
{
    const bool ends = point->kind != JLT_BIFURCATION_NONE;
    FILE *file = self->file;

    fprintf(file, "%zu,", branch);
    jlt_csv_value(file, point->value);
    fprintf(file, ",%.9g,", point->arc);
    jlt_orbit_columns_write(file, self->chart, &point->orbit);
    fprintf(file, ",%s,", jlt_continuation_bifurcation_name(point->kind));
    jlt_csv_row(file, (const double[]){ ends ? point->low : NAN, ends ? point->high : NAN }, 2);
}

/* Report changes of stability that were not located. Bifurcations are found where one multiplier crosses 1 or -1, or a complex pair
 * crosses the unit circle; where two real ones cross together, only the number of multipliers outside the circle shows it. */
static void watch_stability(table *self, size_t branch, const jlt_continuation_point *point)
{
    unsigned outside = 0;

    if (self->rows == 0 || branch != self->branch) self->is_watched = false;
    self->is_told |= point->kind != JLT_BIFURCATION_NONE;
    if (point->kind != JLT_BIFURCATION_NONE) return;
    for (unsigned k = 0; k < self->chart->dim; k++) {
        const double size = hypot(point->orbit.re[k], point->orbit.im[k]);
        if (fabs(size - 1) < near) return;
        outside += size > 1;
    }
    if (self->is_watched && !self->is_told && outside != self->outside)
        fprintf(stderr,
                "jellett: branch %zu: between %.10g and %.10g stability changes, from %u multipliers outside the unit circle to "
                "%u, where none crosses alone: no bifurcation is located\n",
                branch, self->clear_at, point->value, self->outside, outside);
    self->is_watched = true;
    self->is_told = false;
    self->outside = outside;
    self->clear_at = point->value;
}

/* Index into stabilities. Where a multiplier is 1 or -1 and none is larger, they do not tell. */
static unsigned stability(const jlt_periodic *orbit)
{
    if (orbit->type == JLT_ORBIT_CENTRE || orbit->type == JLT_ORBIT_ATTRACTING) return 0;
    return orbit->type != JLT_ORBIT_DEGENERATE || hypot(orbit->re[0], orbit->im[0]) > 1 + near ? 1 : 2;
}

static jlt_status take(void *context, size_t branch, const jlt_continuation_point *point)
{
    table *self = context;
    jlt_map *map;

    watch_stability(self, branch, point);
    if (self->rows == 0 || branch != self->branch) self->losses = (jlt_orbit_losses){ .orbits = 0 };
    JLT_PASS(jlt_system_map_at(self->systems, &map, point->value));
    jlt_orbit_losses_add(&self->losses, jlt_map_flow(map), &point->orbit, point->value);
    write_point(self, branch, point);
    if (self->points != NULL) {
        const unsigned line = stability(&point->orbit);
        double row[4] = { [2] = (double)point->kind, line }, period[2];
        for (unsigned k = 0; k < 2; k++) row[k] = self->shown[k] == 0 ? point->value : point->orbit.points[self->shown[k] - 1];
        for (unsigned k = 0; k < 2; k++) period[k] = self->shown[k] == 0 ? 0 : self->chart->period[self->shown[k] - 1];
        for (unsigned k = 0; k < 2; k++) jlt_extent_add(&self->extent[k], row[k]);
        if (branch != self->branch) fputc('\n', self->points);
        jlt_look_line(self->points, self->rows == 0 || branch != self->branch ? row : self->last, row, 4, period);
        memcpy(self->last, row, sizeof row);
        self->kinds |= 1u << point->kind;
        self->lines |= point->kind == JLT_BIFURCATION_NONE ? 1u << line : 0;
    }
    self->branch = branch;
    self->rows++;
    return ferror(self->file) ? JLT_ERR_IO : JLT_OK;
}

static const char *const ends[] = {
    "the range ends", "the number of points is reached",
    ("no shorter step converges (a pole, an edge of the domain, an empty level, a branch of --solve, a tangency, a family: levels "
     "tell orbits apart, a range of --along thousands of times as wide as the orbit changes in, an equilibrium onto which orbits "
     "shrink, or, where T and the multipliers grow without bound, an orbit homoclinic to one)"),
    "interrupted", "it closes", "it ends at a period doubling"
};

static void tell_end(void *context, const jlt_tree_end *e)
{
    const table *self = context;
    char text[32];

    fflush(self->file); /* where both go to one place, what is said stands between whole rows */
    if (!e->found) {
        fprintf(stderr, "jellett: no other branch found at the %s at %.10g, side %+d\n",
                jlt_continuation_bifurcation_name(e->origin->kind), e->origin->value, e->side);
        return;
    }
    fprintf(stderr, "jellett: branch %zu", e->branch);
    if (e->origin != NULL)
        fprintf(stderr, ", from the %s at %.10g", jlt_continuation_bifurcation_name(e->origin->kind), e->origin->value);
    if (e->is_known) fprintf(stderr, ": the rest is branch %zu\n", e->known);
    else fprintf(stderr, ": %s\n", e->status == JLT_OK ? ends[e->end] : jlt_status_text(e->status));
    if (self->branch == e->branch) {
        snprintf(text, sizeof text, "branch %zu: ", e->branch);
        jlt_orbit_losses_tell(&self->losses, self->observed, text);
    }
}

static void tell_left(const jlt_tree_left *left, size_t generations)
{
    if (left->longer > 0)
        fprintf(stderr, "jellett: not followed: what begins at %zu period doublings of orbits longer than %d returns\n",
                left->longer, JLT_PERIODIC_MAX / 2);
    if (left->last > 0)
        fprintf(stderr, "jellett: not followed: what begins at %zu branch points and period doublings of the last branches; "
                "ask for more with --generations %zu\n", left->last, generations + 1);
}

/* Choose the picture's axes: by default the value that runs, and the first coordinate that is not an angle. */
static jlt_exit choose_axes(unsigned shown[2], const options *o, const jlt_system *system, const jlt_grid_axis *axis)
{
    const jlt_chart *chart = system->flow.chart;
    const char *names[JLT_CHART_DIM_MAX + 1] = { axis->name };

    memcpy(names + 1, chart->names, chart->dim * sizeof *names);
    shown[0] = 0, shown[1] = 1;
    while (shown[1] < chart->dim && chart->period[shown[1] - 1] != 0) shown[1]++;
    return jlt_plot_shown(shown, &o->motion.common, names, chart->dim + 1);
}

/* Draw the branches; a bifurcation point belongs to all their lines, stable or not. */
static jlt_exit draw(const options *o, const jlt_system *system, const char *name, const table *to)
{
    char label[JLT_LOOK_LABEL_MAX];
    jlt_plot plot;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    FILE *const stream = plot.stream;
    jlt_plot_block(&plot, "POINTS", o->motion.common.drawn);
    jlt_plot_words(&plot, "First points of periodic orbits\n");
    jlt_motion_caption(&plot, system, name);
    jlt_motion_label(label, system, name);
    for (unsigned k = 0; k < 2; k++) {
        const jlt_extent range = jlt_extent_wider(to->extent[k]);
        if (to->shown[k] == 0) jlt_plot_axis(&plot, k == 0 ? 'x' : 'y', label, range, 0);
        else jlt_motion_axis(&plot, system, k == 0 ? 'x' : 'y', to->shown[k] - 1, range);
    }
    const bool alone = to->extent[0].low == to->extent[0].high && to->extent[1].low == to->extent[1].high;
    fputs("plot ", stream);
    for (unsigned line = 0; line < sizeof stabilities / sizeof *stabilities; line++) {
        if ((to->lines >> line & 1u) == 0) continue;
        fprintf(stream, "$POINTS using 1:($4==%u||$3>0?$2:NaN) ", line);
        jlt_look_pen(stream, plot.look, alone ? (jlt_pen){ "points", .mark = line, .size = 0.8 }
                                              : (jlt_pen){ "lines", .dash = line });
        fprintf(stream, " title '%s', ", stabilities[line]);
    }
    for (unsigned kind = JLT_BIFURCATION_FOLD; kind <= (unsigned)JLT_BIFURCATION_TORUS; kind++) {
        if ((to->kinds >> kind & 1u) == 0) continue;
        fprintf(stream, "$POINTS using 1:($3==%u?$2:NaN) ", kind);
        jlt_look_pen(stream, plot.look, (jlt_pen){ "points", .colour = kind, .mark = kind, .size = 1 });
        fprintf(stream, " title '%s', ", jlt_continuation_bifurcation_name((jlt_bifurcation)kind));
    }
    fputc('\n', stream);
    return jlt_plot_draw(&plot);
}

static jlt_exit parse_range(jlt_grid_axis *axis, const char *text)
{
    const char *equals = strchr(text, '='), *colon = strchr(text, ':');
    jlt_exit code = JLT_EXIT_DONE;

    axis->high = axis->low;
    if (equals != NULL && colon != NULL && colon > equals && strchr(colon + 1, ':') == NULL) {
        code = jlt_grid_axis_parse(axis, text, (size_t)(colon - text), "--along"); /* NAME=LOW */
        if (code == JLT_EXIT_DONE) code = jlt_grid_number(&axis->high, colon + 1, strlen(colon + 1), "--along");
    }
    if (code == JLT_EXIT_DONE && !(axis->low < axis->high))
        code = jlt_command_fail(JLT_EXIT_USAGE, "--along: '%s' is no range (write NAME=LOW:HIGH, LOW below HIGH)", text);
    return code;
}

/* Find the periodic orbit near --start, the first point of branch 0, in sizes of the start's motion, then in those of its own. */
static jlt_exit find_first(jlt_continuation_point *first, jlt_motion_family *family, const jlt_grid_axis *axis,
                           const options *o, jlt_system *system)
{
    jlt_map *map;
    jlt_status st = JLT_OK;

    *first = (jlt_continuation_point){ .value = *family->entries[0] };
    JLT_PASS(jlt_motion_start(first->orbit.points, system, o->motion.starts[0]));
    if (!(first->value >= axis->low && first->value <= axis->high))
        return jlt_command_fail(JLT_EXIT_INPUT, "--along: the branch starts at %s=%.10g: choose LOW:HIGH around it, or start "
                                "elsewhere by --level or --set", axis->name, first->value);
    JLT_PASS(jlt_motion_plan(system, &o->motion));
    for (int round = 0; st == JLT_OK && round < 2; round++) {
        JLT_PASS(jlt_motion_scale(system, first->orbit.points, NULL));
        jlt_system_family_clear(&family->systems);
        st = jlt_system_map_at(&family->systems, &map, first->value);
        if (st == JLT_OK) st = jlt_periodic_find(map, &first->orbit, first->orbit.points, o->period, NULL);
    }
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_no_orbit(st, system, o->motion.starts[0]);
}

/* Say that only one half of branch 0 was followed, if its first point lies inside the range. */
static void tell_half(const jlt_grid_axis *axis, double value, int direction)
{
    if (!(value > axis->low && value < axis->high)) return;
    fprintf(stderr, "jellett: from %s=%.10g the branch was followed one way, at first to %s values; the other way: run it %s\n",
            axis->name, value, direction > 0 ? "larger" : "smaller", direction > 0 ? "with --decreasing" : "without --decreasing");
}

static jlt_exit run_all(table *to, jlt_motion_family *family, const jlt_grid_axis *axis, const jlt_continuation_point *first,
                        const options *o, const jlt_system *system)
{
    const jlt_family maps = { jlt_system_map_at, &family->systems, jlt_system_map_near };
    const double range = axis->high - axis->low, largest = fmax(fabs(axis->low), fabs(axis->high));
    const jlt_continuation_options run = { .scale = fmin(4 * range, largest), .step = o->step,
                                           .step_max = 5 * o->step, .low = axis->low, .high = axis->high,
                                           .points_max = o->points, .interrupt = o->motion.flow.interrupt };
    const jlt_tree_sink sink = { take, tell_end, to };
    jlt_tree_left left;

    to->chart = system->flow.chart;
    to->systems = &family->systems;
    to->observed = system->flow.observed;
    const jlt_status st = jlt_tree_grow(&left, to->chart, &maps, first, o->direction, o->generations, &run, &sink);
    if (st == JLT_OK) tell_half(axis, first->value, o->direction);
    if (st == JLT_OK && o->generations > 0) tell_left(&left, o->generations);
    if (st == JLT_ERR_DOMAIN && jlt_motion_family_no_angle(family)) return jlt_motion_family_fail(family, st, "--along", axis, 1);
    return st == JLT_OK || st == JLT_ERR_IO ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "continuation");
}

/* Whether a column has this name: a parameter may be called the same. */
static bool is_column(const char *name)
{
    static const char *const columns[] = { "branch", "arc", "period", "T", "trace", "det", "mu1_re", "mu1_im", "mu2_re", "mu2_im",
                                           "symmetric", "type", "residual", "bifurcation", "low", "high" };

    for (size_t i = 0; i < sizeof columns / sizeof *columns; i++)
        if (strcmp(columns[i], name) == 0) return true;
    return false;
}

static const jlt_swept_form swept = { &jlt_command_continue, true, 4 };

static jlt_exit run(int argc, char **argv)
{
    JLT_CLEARED(jlt_motion_end) options o = { .period = 1, .points = 500, .step = 0.01, .direction = 1 };
    JLT_OWNED(jlt_system) *system = NULL;
    JLT_CLEARED(jlt_motion_family_clear) jlt_motion_family family = { .surface = NULL };
    table to = { .extent = { JLT_EXTENT_NONE, JLT_EXTENT_NONE } };
    jlt_common *common = &o.motion.common;
    jlt_grid_axis axis = { .count = 1 };
    jlt_continuation_point first;
    jlt_csv_names names;
    jlt_exit code;

    jlt_motion_begin(&o.motion, argc, argv);
    o.motion.flow.tolerance = 1e-13;
    ttc_options_parse(&parser, argc, argv, &o);
    if (jlt_swept_done(&code, &swept, &o.motion.common)) return code;
    if (o.motion.flow.max_steps == 0) o.motion.flow.max_steps = 20000;
    JLT_PASS(jlt_motion_system(&system, &o.motion));
    JLT_PASS(parse_range(&axis, o.along));
    JLT_PASS(choose_axes(to.shown, &o, system, &axis));
    JLT_PASS(jlt_motion_default_start(&o.motion, system, JLT_START_SADDLE, "say near which orbit to begin: --start"));
    if (o.generations > 0 && system->flow.chart->dim != 2)
        return jlt_command_fail(JLT_EXIT_USAGE,
                                "--branches: the section has %u coordinates; branches are followed where it has two",
                                system->flow.chart->dim);
    JLT_PASS(jlt_motion_family_open(&family, system, &o.motion, &axis, 1, "--along"));
    JLT_PASS(find_first(&first, &family, &axis, &o, system));
    if (first.value >= axis.high) o.direction = -1; /* from the upper end only this way is left */
    JLT_PASS(jlt_common_write(common));
    to.file = common->table.file;
    to.points = common->points;
    o.motion.swept = &axis;
    o.motion.swept_count = 1;
    jlt_motion_header(to.file, &o.motion, system);
    FILE *line = jlt_csv_names_begin(&names, to.file);
    fprintf(line, "branch,%s%s,arc,", is_column(axis.name) ? "along_" : "", axis.name);
    jlt_orbit_columns_names(line, system->flow.chart);
    fputs(",bifurcation,low,high", line);
    jlt_csv_names_end(&names);
    JLT_PASS(run_all(&to, &family, &axis, &first, &o, system));
    JLT_PASS(jlt_common_save(common));
    if (jlt_motion_interrupted(&o.motion))
        fprintf(stderr, "jellett: interrupted; %zu whole rows are saved in %s\n", to.rows, common->table.path);
    return common->plot != NULL ? draw(&o, system, axis.name, &to) : JLT_EXIT_DONE;
}

const jlt_command jlt_command_continue = {
    "continue", "[MODEL] --along PARAM|LEVEL=LOW:HIGH [OPTION...]",
    "Follow a periodic orbit in a parameter or level, with its bifurcations", run, &parser, NULL
};
