/* `jellett orbits`: finds periodic orbits of the return map, with multipliers, type, symmetry and residual. */
#include "base/options.h"
#include "base/text.h"
#include "cli/interrupt.h"
#include "cli/motion.h"
#include "cli/orbit_columns.h"
#include "cli/orbit_lines.h"
#include "cli/orbit_losses.h"
#include "cli/progress.h"
#include "cli/swept.h"
#include "dynamics/orbits.h"
#include "kernel/batch_isa.h"
#include "report/csv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    jlt_motion_options motion;
    size_t period_max, samples, settle, threads;
    const char *grid, *line, *hold;
    double near;
} options;

enum { NEAR = 2000, SETTLE, SAMPLES, LINE, HOLD, THREADS };

static const struct argp_option option_table[] = {
    { "period", 'n', "N", 0, "Look for orbits that close after 1 to N returns, N at most 64; default 3", 1 },
    { "grid", 'g', "COUNTxCOUNT", 0,
      "Starts of Newton's method: a grid over the whole section, or over NAME=LOW:HIGH:COUNT,...; default 40x40; 0x0 for "
      "none", 1 },
    { "near", NEAR, "DISTANCE", 0,
      "Try Newton's method where an orbit comes back to within this distance, in coordinates; default 0.6. To find a "
      "strongly unstable orbit, take a larger distance, such as 10, or a finer --grid, because its "
      "returns come less near", 1 },
    { "settle", SETTLE, "N|0", 0,
      "Also try Newton's method from the Nth return of every start, which finds attracting orbits; default 20; 0: do not", 1 },
    { "samples", SAMPLES, "N|0", 0,
      "For symmetric orbits: points on each of the lines that the section's reversor keeps, between which more are put where "
      "orbits differ much from one to the next; default 1000; 0 for none", 1 },
    { "start", 'a', "NAME=VALUE,...", 0,
      "Begin Newton's method at this point only, and look for an orbit of exactly N returns, N from --period; where it finds none, "
      "also by --settle, of fewer that divide N", 1 },
    { "hold", HOLD, "NAME,...", 0, "With --start, where orbits come in families: the coordinates that keep their values", 1 },
    { "line", LINE, "NAME=LOW:HIGH:COUNT", 0,
      "Look for symmetric orbits on one line only: through --start, along this coordinate, of at most N returns, N from "
      "--period", 1 },
    { "threads", THREADS, "N", 0,
      "Search on N threads; default: all processors. The orbits found do not depend on N", 1 },
    { 0 },
};

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { &jlt_plot_axes_argp, 0, NULL, 0 },
                                              { &jlt_swept_argp, 0, NULL, 0 }, { 0 } };

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case 'n': jlt_common_count(&o->period_max, value, 1, JLT_PERIODIC_MAX, "--period"); return 0;
    case 'g':
        if (strcmp(value, "0x0") != 0) jlt_motion_typed(value, "--grid");
        o->grid = value;
        return 0;
    case NEAR: jlt_common_positive(&o->near, value, "--near"); return 0;
    case SETTLE: jlt_common_count(&o->settle, value, 0, 1000000000, "--settle"); return 0;
    case SAMPLES: jlt_common_count(&o->samples, value, 0, 1000000000, "--samples"); return 0;
    case LINE: o->line = value; return 0;
    case THREADS: jlt_common_count(&o->threads, value, 1, 1024, "--threads"); return 0;
    case HOLD: o->hold = value; return 0;
    case 'a': jlt_motion_one_start(&o->motion, value); return 0;
    case ARGP_KEY_END:
        if (o->motion.starts[0] == NULL && o->line != NULL) argp_error(state, "--line goes through a point: add --start");
        if (o->motion.starts[0] == NULL && o->hold != NULL) argp_error(state, "--hold keeps coordinates of --start: add it");
        if (o->motion.starts[0] != NULL && o->grid != NULL) argp_error(state, "--start and --grid exclude each other");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Find periodic orbits of the section's map: symmetric ones as zeros along the lines that the reversor keeps, all others by "
    "Newton's method from a grid of starts."
    "\vColumns, one row an orbit:\n"
    "  period            returns after which the orbit closes\n"
    "  COORDINATE        each coordinate of one of its points\n"
    "  T                 the time that the whole orbit takes\n"
    "  trace, det        of the derivative DP of the map over one period\n"
    "  mu1_re, mu1_im, mu2_re, mu2_im: its multipliers\n"
    "  symmetric         whether the orbit is its own mirror image; empty where the\n"
    "                    section has no reversor that changes signs alone\n"
    "  type              centre, saddle, ...\n"
    "  residual          the largest distance of a return from the next point\n\n"
    "Distances are in coordinates; one whose size is not between 1/64 and 64 is divided by it. From one --start, sizes below 1 "
    "count as 1, unless all are below 1/64: where sizes are mixed, give a --grid. det is the exponential of the integrated "
    "divergence, and the determinant of DP itself is checked against it. Multipliers that the errors of DP hide, by more than a "
    "thousandth, are empty; with all of them the trace. An orbit that is not symmetric and has det != 1 excludes an invariant "
    "measure with smooth positive density; its mirror image has 1/det.\n\n"
    "Examples:\n"
    "  jellett orbits --period 4\n"
    "  jellett orbits --set I1=0.591,I3=0.494,a3=0.548 \\\n"
    "    --level E=2.15,G=0.161 --period 1",
    children, NULL, NULL,
};

/* Write comments: what the orbits say about an invariant measure, and how well the flux identity for det DP holds. */
static void write_findings(FILE *file, const jlt_orbits *list, const jlt_chart *chart)
{
    double defect = 0;
    size_t obstructions = 0, without_mirror = 0;

    for (size_t i = 0; i < list->count; i++) {
        const jlt_periodic *orbit = &list->orbits[i];
        defect = fmax(defect, fabs(orbit->defect));
        /* The error of the determinant is about the defect of the flux identity; a hundred times that leaves no doubt. */
        if (orbit->symmetric || !(fabs(orbit->determinant - 1) > 1e-8 + 100 * fabs(orbit->defect))) continue;
        obstructions++;
        if (jlt_orbits_mirror(list, chart, i) == list->count) without_mirror++;
    }
    fprintf(file, "# %zu orbit%s; det DP against flux and divergence: worst relative defect %.2g\n", list->count,
            ttc_text_plural(list->count), defect);
    if (!chart->reversible) return;
    if (obstructions == 0)
        fputs("# no asymmetric orbit with det != 1 among them: nothing here excludes an invariant measure\n", file);
    else
        fprintf(file,
                "# %zu asymmetric orbits with det != 1, %zu of them with their mirror image (det and 1/det): each excludes an "
                "invariant measure with smooth positive density on this level\n",
                obstructions, obstructions - without_mirror);
}

/* Each kind of work has a rate of its own. */
static void show(void *context, const char *what, size_t done, size_t all)
{
    jlt_progress *progress = context;

    if (strcmp(progress->unit, what) != 0) jlt_progress_start(progress, what);
    jlt_progress_show(progress, done, all);
}

/* Search on all threads, with progress. An interrupt ends the search, and what it has found is saved. */
static jlt_status search_until_interrupted(jlt_orbits *list, jlt_map *map, jlt_orbits_options *search, const options *o)
{
    jlt_progress progress;
    jlt_status st;

    jlt_interrupt_spare(o->threads);
    jlt_progress_start(&progress, "");
    search->progress = show;
    search->context = &progress;
    st = jlt_orbits_search(list, map, search);
    jlt_progress_end(&progress);
    if (!jlt_motion_interrupted(&o->motion) || (st != JLT_OK && st != JLT_ERR_NO_CONVERGENCE)) return st;
    if (list->count > 0) fprintf(stderr, "jellett: interrupted; the %zu orbits found so far are saved\n", list->count);
    return JLT_OK;
}

static jlt_exit held_mask(unsigned char *held, const options *o, const jlt_chart *chart)
{
    const char *text = o->hold;

    while (text != NULL && *text != '\0') {
        const size_t length = strcspn(text, ",");
        unsigned k = 0;
        while (k < chart->dim && (strlen(chart->names[k]) != length || strncmp(chart->names[k], text, length) != 0)) k++;
        if (k == chart->dim) return jlt_motion_no_coordinate(chart, "--hold", text, length);
        held[k] = 1;
        text += length + (text[length] == ',');
    }
    if (memchr(held, 0, chart->dim) == NULL)
        return jlt_command_fail(JLT_EXIT_INPUT, "--hold %s: no coordinate is left to solve for: leave one out", o->hold);
    return JLT_EXIT_DONE;
}

/* Find an orbit of a number of returns that divides `period`. Returns whether there is one. */
static bool find_shorter(jlt_periodic *out, jlt_map *map, const double *q, size_t period, const unsigned char *held)
{
    for (size_t shorter = 1; shorter < period; shorter++)
        if (period % shorter == 0 && jlt_periodic_find(map, out, q, shorter, held) == JLT_OK) return true;
    return false;
}

/* Follow the start q for `settle` returns. Returns whether Newton's method finds an attracting orbit there. */
static bool find_attracting(jlt_periodic *out, jlt_map *map, const options *o, const double *q)
{
    jlt_image settled;

    return o->settle > 0 && o->hold == NULL && jlt_map_point(map, &settled, q, o->settle, 1) == JLT_OK &&
           jlt_periodic_find(map, out, settled.q, o->period_max, NULL) == JLT_OK && out->type == JLT_ORBIT_ATTRACTING;
}

/* Find an orbit by Newton's method from q, of all returns that are asked for: near q, or attracting. Where there is none, find one
 * of fewer, near q unless the attracting one has more: near a strongly unstable orbit, those of q soon lead away from it. */
static jlt_status find_orbit(jlt_periodic *out, jlt_map *map, const options *o, const double *q, const unsigned char *held)
{
    const size_t period = o->period_max;
    const jlt_status st = jlt_periodic_find(map, out, q, period, held);
    const bool found = st == JLT_OK;
    jlt_periodic attracting;

    if (found ? out->period == period : !jlt_orbits_is_miss(st)) return st;
    const bool attracts = (found || st == JLT_ERR_NO_CONVERGENCE) && find_attracting(&attracting, map, o, q);
    const bool near = found || (!(attracts && attracting.period == period) && find_shorter(out, map, q, period, held));
    if (attracts && (!near || attracting.period > out->period)) *out = attracting;
    return near || attracts ? JLT_OK : st;
}

/* Read the start, the coordinates of --hold and the line of --line, which is left without samples if there is none. */
static jlt_exit read_start(jlt_symmetric_line *line, unsigned char *held, const options *o, const jlt_system *system)
{
    const jlt_chart *chart = system->flow.chart;
    jlt_grid_axis axis;

    JLT_PASS(jlt_motion_start(line->base, system, o->motion.starts[0]));
    JLT_PASS(held_mask(held, o, chart));
    if (o->line == NULL) return JLT_EXIT_DONE;
    JLT_PASS(jlt_grid_axis_parse(&axis, o->line, strlen(o->line), "--line"));
    while (line->free < chart->dim && strcmp(chart->names[line->free], axis.name) != 0) line->free++;
    if (line->free == chart->dim) return jlt_motion_no_coordinate(chart, "--line", axis.name, strlen(axis.name));
    if (!(axis.low < axis.high) || axis.count < 2)
        return jlt_command_fail(JLT_EXIT_INPUT, "--line: %s needs LOW below HIGH, and a COUNT of 2 or more", axis.name);
    line->low = axis.low, line->high = axis.high, line->samples = axis.count;
    return JLT_EXIT_DONE;
}

/* Newton from one point, or the zeros on one line through it. */
static jlt_exit from_start(jlt_orbits *list, jlt_map *map, const jlt_symmetric_line *line, const unsigned char *held,
                           const options *o, jlt_system *system)
{
    jlt_orbits_options search = { .period_max = o->period_max, .lines = line, .line_count = 1,
                                  .kernels = jlt_batch_isa_best(system->instance->descriptor, 0), .threads = (unsigned)o->threads };
    jlt_periodic orbit;
    jlt_status st;

    JLT_PASS(jlt_motion_scale(system, line->base, NULL));
    if (o->line == NULL) {
        st = find_orbit(&orbit, map, o, line->base, held);
        if (st == JLT_OK && orbit.type == JLT_ORBIT_DEGENERATE && o->hold == NULL)
            fputs("jellett: a multiplier is 1 or -1: if orbits come in a family, this is any one of it; --hold keeps coordinates "
                  "of --start, and --level chooses one\n", stderr);
        if (st == JLT_OK) st = jlt_orbits_add(list, system->flow.chart, &orbit);
        return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_no_orbit(st, system, o->motion.starts[0]);
    }
    JLT_PASS(jlt_orbit_lines_check(line, system->flow.chart));
    st = search_until_interrupted(list, map, &search, o);
    if (st == JLT_ERR_UNSUPPORTED)
        return jlt_motion_no_reversor(system, "--line: no reversor keeps the points of this line and mirrors one coordinate");
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "--line");
}

static const char default_grid[] = "40x40";

/* Whether --grid 0x0 asks for symmetric orbits only, without starts of a grid. */
static bool searches_nowhere(const options *o) { return o->grid != NULL && strcmp(o->grid, "0x0") == 0; }

/* Say why a grid of starts shows no orbit: Newton's method needs the map's derivative at one of them at least. */
static void tell_none(jlt_map *map, const jlt_grid_axis *axes, unsigned dim)
{
    double q[JLT_CHART_DIM_MAX];
    jlt_image image;
    jlt_status st = JLT_ERR_DOMAIN;
    size_t all = 1;

    for (unsigned k = 0; k < dim; k++) all *= axes[k].count;
    for (size_t i = 0; i < all && st == JLT_ERR_DOMAIN; i++) {
        jlt_grid_point(q, axes, dim, i);
        st = jlt_map_apply(map, &image, q, 1, 1);
    }
    if (st == JLT_ERR_DOMAIN)
        fputs("jellett: no orbit is found: at none of the starts does the map have a derivative: orbits cross the section the "
              "other way (--direction), leave the model's domain, or do not come back ('jellett section' tells which), or a rate "
              "jumps on the way, as dry friction does\n", stderr);
    else
        fputs("jellett: no orbit is found: a finer --grid, or a larger --near, finds those that are strongly unstable\n", stderr);
}

static jlt_exit search_all(jlt_orbits *list, jlt_map *map, const options *o, jlt_system *system)
{
    const jlt_chart *chart = system->flow.chart;
    const bool no_grid = searches_nowhere(o);
    jlt_symmetric_line lines[2] = { { .free = 1 }, { .free = 1 } };
    jlt_orbits_options search = { .period_max = o->period_max, .near = o->near, .settle = o->settle, .lines = lines,
                                  .kernels = jlt_batch_isa_best(system->instance->descriptor, 0), .threads = (unsigned)o->threads };
    jlt_grid_axis axes[JLT_CHART_DIM_MAX];
    jlt_status st;

    JLT_PASS(jlt_motion_axes(axes, system, no_grid ? NULL : o->grid != NULL ? o->grid : default_grid, "--grid"));
    JLT_PASS(jlt_grid_whole(axes, "--grid"));
    if (!no_grid) JLT_PASS(jlt_motion_check_grid(axes, system));
    if (!no_grid) JLT_PASS(jlt_motion_scale(system, NULL, axes));
    for (unsigned k = 0; k < chart->dim; k++) {
        search.low[k] = axes[k].low;
        search.high[k] = axes[k].high;
        search.counts[k] = no_grid ? 0 : axes[k].count;
    }
    if (o->samples >= 2 && system->surface != NULL) search.line_count = jlt_orbit_lines_whole(lines, system, o->samples);
    if (o->samples >= 2 && o->grid != NULL && !no_grid && search.line_count == 0)
        search.line_count = jlt_orbit_lines_of_grid(lines, chart, axes, o->samples);
    st = search_until_interrupted(list, map, &search, o);
    if (st == JLT_OK && jlt_motion_interrupted(&o->motion)) return JLT_EXIT_DONE;
    if (st == JLT_OK && list->count == 0 && system->flow.chart->solved_count > 0)
        fputs("jellett: orbits with a return on another branch of --solve are not found\n", stderr);
    if (st == JLT_OK && list->count == 0 && !no_grid) tell_none(map, axes, chart->dim);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "orbits");
}

static jlt_exit draw(const options *o, const jlt_system *system, const jlt_orbits *list, const unsigned shown[2])
{
    const unsigned dim = system->flow.chart->dim;
    size_t found[JLT_ORBIT_DEGENERATE + 1] = { 0 };
    jlt_extent extent[2] = { JLT_EXTENT_NONE, JLT_EXTENT_NONE };
    bool first = true;
    jlt_plot plot;
    FILE *stream;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    stream = plot.stream;
    fputs("$POINTS << END\n", stream);
    for (size_t i = 0; i < list->count; i++) {
        const jlt_periodic *orbit = &list->orbits[i];
        found[orbit->type]++;
        for (const double *q = orbit->points; q < orbit->points + orbit->period * dim; q += dim) {
            for (unsigned k = 0; k < 2; k++) jlt_extent_add(&extent[k], q[shown[k]]);
            jlt_look_row(stream, (const double[]){ q[shown[0]], q[shown[1]], (double)orbit->type }, 3);
        }
    }
    fputs("END\n", stream);
    jlt_plot_words(&plot, "Points of periodic orbits\n");
    jlt_motion_caption(&plot, system, NULL);
    for (unsigned k = 0; k < 2; k++)
        jlt_motion_axis(&plot, system, k == 0 ? 'x' : 'y', shown[k],
                        !jlt_motion_framed(system, shown[k]) && list->count > 0 ? jlt_extent_wider(extent[k]) : JLT_MOTION_WHOLE);
    fputs(JLT_LOOK_GRID "plot ", stream);
    for (unsigned type = 0; type <= (unsigned)JLT_ORBIT_DEGENERATE; type++) {
        if (found[type] == 0) continue;
        fprintf(stream, "%s$POINTS using 1:($3==%u?$2:NaN) ", first ? "" : ", ", type);
        jlt_look_pen(stream, plot.look, (jlt_pen){ "points", .colour = type, .mark = type, .size = 0.8 });
        fprintf(stream, " title '%zu %s'", found[type], jlt_periodic_type_name((jlt_orbit_type)type));
        first = false;
    }
    fputs(first ? "NaN notitle\n" : "\n", stream);
    return jlt_plot_draw(&plot);
}

static const jlt_swept_form swept = { &jlt_command_orbits, true, 1 };

static jlt_exit run(int argc, char **argv)
{
    JLT_CLEARED(jlt_motion_end)
    options o = { .period_max = 3, .samples = 1000, .near = 0.6, .settle = 20, .threads = jlt_common_processors() };
    JLT_OWNED(jlt_system) *system = NULL;
    JLT_OWNED(jlt_map) *map = NULL;
    JLT_CLEARED(jlt_orbits_clear) jlt_orbits list = { 0 };
    jlt_common *common = &o.motion.common;
    jlt_symmetric_line line = { .samples = 0 };
    jlt_orbit_losses losses = { .orbits = 0 };
    unsigned char held[JLT_CHART_DIM_MAX] = { 0 };
    unsigned shown[2];
    jlt_csv_names names;
    jlt_exit code;
    jlt_status st;

    jlt_motion_begin(&o.motion, argc, argv);
    o.motion.flow.tolerance = 1e-13;
    ttc_options_parse(&parser, argc, argv, &o);
    if (jlt_swept_done(&code, &swept, &o.motion.common)) return code;
    common->lanes = o.motion.starts[0] == NULL;
    if (!searches_nowhere(&o)) o.motion.grid = o.grid, o.motion.other = default_grid;
    JLT_PASS(jlt_motion_system(&system, &o.motion));
    if (system->surface == NULL && o.grid == NULL && o.motion.starts[0] == NULL)
        return jlt_command_fail(JLT_EXIT_USAGE, "say where to search: --start or --grid");
    if (o.motion.starts[0] != NULL) JLT_PASS(read_start(&line, held, &o, system));
    JLT_PASS(jlt_motion_shown(shown, &o.motion, system));
    JLT_PASS(jlt_motion_plan(system, &o.motion));
    JLT_PASS(jlt_common_write(common));
    if (system->flow.max_steps == 0) system->flow.max_steps = 20000;
    st = jlt_map_create(&map, &system->flow);
    if (st != JLT_OK) return jlt_motion_fail(st, system, "the map");
    JLT_PASS(o.motion.starts[0] != NULL ? from_start(&list, map, &line, held, &o, system) : search_all(&list, map, &o, system));
    jlt_motion_header(common->table.file, &o.motion, system);
    write_findings(common->table.file, &list, system->flow.chart);
    jlt_orbit_columns_names(jlt_csv_names_begin(&names, common->table.file), system->flow.chart);
    jlt_csv_names_end(&names);
    for (size_t i = 0; i < list.count; i++) {
        jlt_orbit_columns_write(common->table.file, system->flow.chart, &list.orbits[i]);
        fputc('\n', common->table.file);
        jlt_orbit_losses_add(&losses, &system->flow, &list.orbits[i], NAN);
    }
    JLT_PASS(jlt_common_save(common));
    jlt_orbit_losses_tell(&losses, system->flow.observed, "");
    return common->plot != NULL ? draw(&o, system, &list, shown) : JLT_EXIT_DONE;
}

const jlt_command jlt_command_orbits = {
    "orbits", "[MODEL] [OPTION...]", "Periodic orbits of the map: multipliers, type, symmetry, residual", run, &parser, NULL
};
