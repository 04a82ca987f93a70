/* `jellett fates`: how orbits of a section end, and the shares of each fate in a sweep. */
#include "base/options.h"
#include "cli/fates_crowd.h"
#include "cli/fates_table.h"
#include "cli/motion_family.h"
#include "report/symbol.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    jlt_motion_options motion;
    size_t returns;
} options;

enum { SWEEP = 2000 };

static const struct argp_option option_table[] = {
    { "start", 'a', "NAME=VALUE,...", TTC_OPTIONS_REPEATED,
      "A start on the section: a value for every coordinate; may be repeated", 1 },
    { "grid", 'g', "COUNTxCOUNT", 0,
      "A grid of starts over the whole section, or over NAME=LOW:HIGH:COUNT,...; for the spherical top 60x40 by default, "
      "where there is no --start", 1 },
    { "returns", 'n', "N", 0, "Returns after which an orbit counts as alive; default 200", 1 },
    { "sweep", SWEEP, "PARAM|LEVEL=LOW:HIGH:COUNT,...", 0,
      "One row for every point of a grid of parameters and levels, the last one fastest: the shares of the fates", 1 },
    { 0 },
};

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { &jlt_contact_argp, 0, NULL, 0 },
                                              { &jlt_motion_many_argp, 0, NULL, 0 }, { &jlt_plot_axes_argp, 0, NULL, 0 }, { 0 } };

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case 'a': o->motion.starts[o->motion.start_count++] = value; return 0;
    case 'g': jlt_motion_typed(o->motion.grid = value, "--grid"); return 0;
    case 'n': jlt_common_count(&o->returns, value, 1, 1000000000000, "--returns"); return 0;
    case SWEEP: o->motion.common.own_sweep = value; return 0;
    case ARGP_KEY_END:
        if (o->motion.common.own_sweep != NULL && o->motion.common.axes != NULL)
            argp_error(state, "--axes are those of a grid of fates: leave out --sweep");
        if (o->motion.common.own_sweep != NULL && strcmp(o->motion.contact, "report") == 0)
            argp_error(state, "--contact report writes a column of orbits, and rows of --sweep are shares: leave one out");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "Follow orbits from a section, and report how and when they end, or that they go on; for the spherical top at which pole, "
    "and which share turns over."
    "\vColumns, one row a start:\n"
    "  COORDINATE        each coordinate of the start\n"
    "  fate              as in `jellett section --help`\n"
    "  t_end             time of the end; of an orbit that is alive, of the last\n"
    "                    return; so also below\n"
    "  NAME_end          values at the end: of the spherical top three velocities,\n"
    "                    of another model all its states\n"
    "  NAME_min          with --contact report: the least value of the condition\n\n"
    "What is not known is empty. The exit status is 4 where the method failed on an orbit. Orbits on which a proved integral "
    "changes by more than a thousand errors of one tolerance a return, as on a pass close to a singularity, are counted at the "
    "end.\n\n"
    "An orbit of the spherical top turns over when it starts with its centre of mass below the centre of the sphere (a low "
    "start) and ends at the pole where it is above.\n\n"
    "Columns with --sweep, for the spherical top:\n"
    "  PARAM, LEVEL      the values of this point\n"
    "  starts, low_starts: how many starts there are, and low ones\n"
    "  pole+, pole-, lost_contact, equilibrium, alive, budget: how many end so\n"
    "  failed            on how many the method failed\n"
    "  turned            the share of the low starts that turns over\n"
    "  turned_error      how far Wilson's interval of one standard error reaches\n"
    "                    from this share\n"
    "  turned_in_contact the share that turns over with the model valid all the way\n"
    "                    (no column if the model has no conditions)\n\n"
    "Starts are evenly spaced in the coordinates. For other models the columns are the values, starts, the fates, failed, and, "
    "where the table has conditions, NAME_held: on how many starts they held all the way.\n\n"
    "Orbits are followed side by side as by `jellett section`, with a method that --tol chooses; with --method, one at a time.\n\n"
    "Examples:\n"
    "  jellett fates --grid 300x200 --plot fates.png > fates.csv\n"
    "  jellett fates --grid eta=-pi:pi:60,gamma3=-0.9999:-0.99:10\n"
    "  jellett fates --sweep E=0.6:4:18 --plot share.svg\n"
    "  jellett fates lorenz --section z=27 --grid x=-20:20:9,y=-20:20:9",
    children, NULL, NULL,
};

static const char default_grid[] = "60x40";

static jlt_exit draw_fates(const options *o, const jlt_system *system, jlt_motion_map *map, const jlt_shares *sum)
{
    char name[JLT_FATE_TEXT_MAX];
    jlt_plot plot;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    jlt_plot_words(&plot, "Fates of orbits by their start\n");
    jlt_motion_caption(&plot, system, NULL);
    jlt_motion_map_frame(map, &plot);
    jlt_look_steps(plot.stream, plot.look, (unsigned)JLT_FATE_COUNT);
    jlt_motion_map_plot(map, &plot);
    for (unsigned fate = 0; fate < (unsigned)JLT_FATE_COUNT; fate++) {
        if (sum->all.by_fate[fate] == 0) continue;
        jlt_section_fate_text(name, system->observed, (jlt_fate)fate, JLT_OBSERVED_ANY);
        fprintf(plot.stream, ", keyentry with boxes fill solid lc rgb '%s' title '%zu ", jlt_look_colour(plot.look, fate),
                sum->all.by_fate[fate]);
        jlt_symbol_plain(plot.stream, name, strlen(name));
        fputc('\'', plot.stream);
    }
    fputc('\n', plot.stream);
    return jlt_plot_draw(&plot);
}

static jlt_exit one_system(options *o, jlt_system *system, jlt_motion_map *map)
{
    jlt_common *common = &o->motion.common;
    jlt_fates_crowd crowd = { .motion = &o->motion, .returns = o->returns, .rows = common->table.file, .map = map, .whole = 1 };
    jlt_progress progress;
    jlt_exit code;

    jlt_motion_header(common->table.file, &o->motion, system);
    jlt_fates_table_names(common->table.file, &o->motion, system);
    jlt_progress_start(&progress, "starts");
    crowd.progress = &progress;
    code = jlt_fates_crowd_follow(&crowd, system, NULL, 0);
    if (code == JLT_EXIT_DONE) code = jlt_fates_crowd_finish(&crowd);
    const jlt_shares sum = crowd.place_count > 0 ? *jlt_fates_crowd_sum(&crowd) : (jlt_shares){ .empty = 0 };
    jlt_fates_crowd_close(&crowd);
    jlt_progress_end(&progress);
    if (code == JLT_EXIT_DONE && sum.all.starts == 0 && sum.empty > 0 && (map->axes == NULL || map->axes[0].part == 0))
        code = jlt_motion_fail(JLT_ERR_EMPTY, system, "--grid");
    if (code == JLT_EXIT_DONE) code = jlt_common_save(common);
    if (code == JLT_EXIT_DONE) {
        if (jlt_motion_interrupted(&o->motion))
            fprintf(stderr, "jellett: interrupted; whole rows are saved in %s\n", common->table.path);
        fputs("jellett: ", stderr);
        jlt_fates_table_summary(stderr, &o->motion, system, &sum);
        jlt_fates_crowd_tell(&crowd, sum.all.starts);
        if (map->points != NULL) code = draw_fates(o, system, map, &sum);
    }
    return code == JLT_EXIT_DONE ? jlt_motion_failures(system, &sum.all.failures, sum.all.starts) : code;
}

/* Draw shares against the value that runs. Columns of $SHARES: the value; the share of low starts that turn over (without turns: of
 * all starts that stay alive); its error; the share of low starts that turn over in contact all the way. */
static jlt_exit draw_sweep(const options *o, const jlt_system *system, const jlt_grid_axis *axis)
{
    const bool turns = jlt_shares_turn(system);
    char label[JLT_LOOK_LABEL_MAX];
    jlt_plot plot;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    jlt_plot_block(&plot, "SHARES", o->motion.common.drawn);
    jlt_plot_words(&plot, "Share of orbits that %s\n", turns ? "turn over" : "go on");
    jlt_motion_caption(&plot, system, axis->name);
    jlt_motion_label(label, system, axis->name);
    jlt_plot_axis(&plot, 'x', label, jlt_extent_wider((jlt_extent){ fmin(axis->low, axis->high), fmax(axis->low, axis->high) }), 0);
    jlt_plot_axis(&plot, 'y', turns ? "share of low starts" : "share of starts", (jlt_extent){ 0, 1 }, 0);
    fputs("plot $SHARES using 1:2:3 ", plot.stream);
    jlt_look_pen(plot.stream, plot.look, (jlt_pen){ "yerrorlines", .colour = 2, .size = 0.6 });
    fprintf(plot.stream, " title '%s'", turns ? "turned over" : "alive");
    if (turns && jlt_observed_conditions(system->flow.observed) > 0) {
        fputs(", $SHARES using 1:4 ", plot.stream);
        jlt_look_pen(plot.stream, plot.look, (jlt_pen){ "linespoints", .colour = 1, .dash = 1, .mark = 3, .size = 0.6 });
        fputs(" title 'in contact all the way'", plot.stream);
    }
    fputc('\n', plot.stream);
    return jlt_plot_draw(&plot);
}

static jlt_exit read_sweep(jlt_grid_axis *axes, size_t *count, size_t *all, const options *o)
{
    JLT_PASS(jlt_grid_parse(axes, count, JLT_FAMILY_AXES_MAX, o->motion.common.own_sweep, "--sweep"));
    if (jlt_grid_size(all, axes, *count, o->motion.common.own_sweep, "--sweep") != JLT_EXIT_DONE) return JLT_EXIT_INPUT;
    if (o->motion.common.plot != NULL && *count != 1)
        return jlt_command_fail(JLT_EXIT_USAGE, "--plot needs a --sweep of one quantity: vary one, or leave out --plot");
    return JLT_EXIT_DONE;
}

/* The context of write_shares: what a sweep's rows need, and totals over all points. waiting: points without starts whose rows are
 * not written, as there was no start before them; outside: points at which the model's parameters have no meaning. */
typedef struct {
    const options *o;
    const jlt_system *base;
    size_t axes, starts, waiting, outside;
    jlt_failures failures;
} share_rows;

/* Write the header, and the rows that wait. */
static void begin_rows(share_rows *self)
{
    const jlt_common *common = &self->o->motion.common;
    double at[JLT_FAMILY_AXES_MAX];

    jlt_motion_header(common->table.file, &self->o->motion, self->base);
    jlt_fates_table_share_names(common->table.file, self->base, self->o->motion.swept, self->axes);
    for (size_t i = 0; i < self->waiting; i++) {
        jlt_grid_point(at, self->o->motion.swept, self->axes, i);
        jlt_fates_table_shares(common->table.file, common->points, self->base, at, self->axes, &(jlt_shares){ .empty = 0 });
    }
}

static void write_shares(void *context, const jlt_fates_crowd_place *place)
{
    share_rows *self = context;
    const jlt_common *common = &self->o->motion.common;

    if (self->starts == 0 && place->sum.all.starts > 0) begin_rows(self);
    self->starts += place->sum.all.starts;
    self->waiting += self->starts == 0;
    if (self->starts == 0) return;
    jlt_failures_join(&self->failures, &place->sum.all.failures);
    jlt_fates_table_shares(common->table.file, common->points, self->base, place->values, self->axes, &place->sum);
}

/* Follow the starts at each point of these axes (count,); orbits of several points share a batch. Where there is no state, or the
 * model has no meaning, there are no starts; the first point of the latter kind is reported. */
static jlt_exit follow_points(jlt_fates_crowd *crowd, jlt_motion_family *family, const jlt_grid_axis *axes, size_t count,
                              share_rows *rows)
{
    jlt_exit code = JLT_EXIT_DONE;

    for (size_t i = 0; code == JLT_EXIT_DONE && i < crowd->whole && !jlt_motion_interrupted(crowd->motion); i++) {
        jlt_system *system = NULL;
        double at[JLT_FAMILY_AXES_MAX];
        jlt_grid_point(at, axes, count, i);
        for (size_t k = 0; k < count; k++) *family->entries[k] = at[k];
        const jlt_status st = jlt_motion_family_make(family, &system);
        const bool is_outside = st == JLT_ERR_DOMAIN;
        if (st != JLT_OK && st != JLT_ERR_EMPTY && (!is_outside || rows->outside == 0))
            code = jlt_motion_family_fail(family, st, "--sweep", axes, count);
        rows->outside += is_outside;
        if (code == JLT_EXIT_DONE || is_outside) code = jlt_fates_crowd_follow(crowd, system, at, count);
    }
    return code == JLT_EXIT_DONE && !jlt_motion_interrupted(crowd->motion) ? jlt_fates_crowd_finish(crowd) : code;
}

/* `all`: the points of the grid that is swept. */
static jlt_exit sweep(options *o, const jlt_system *base, size_t all)
{
    jlt_common *common = &o->motion.common;
    JLT_CLEARED(jlt_motion_family_clear) jlt_motion_family family = { .surface = NULL };
    const jlt_grid_axis *axes = o->motion.swept;
    share_rows rows = { .o = o, .base = base, .axes = o->motion.swept_count };
    JLT_CLEARED(jlt_fates_crowd_close)
    jlt_fates_crowd crowd = { .motion = &o->motion, .returns = o->returns, .done = write_shares, .context = &rows, .whole = all };
    jlt_progress progress;
    jlt_exit code;

    JLT_PASS(jlt_motion_family_open(&family, base, &o->motion, axes, rows.axes, "--sweep"));
    jlt_progress_start(&progress, "starts");
    crowd.progress = &progress;
    code = follow_points(&crowd, &family, axes, rows.axes, &rows);
    jlt_progress_end(&progress);
    const bool has_rows = rows.starts > 0 || axes[0].part > 0 || jlt_motion_interrupted(&o->motion);
    if (code == JLT_EXIT_DONE && !has_rows && rows.outside == 0) return jlt_motion_fail(JLT_ERR_EMPTY, base, "--sweep");
    if (code == JLT_EXIT_DONE && has_rows && rows.starts == 0) begin_rows(&rows);
    if (code == JLT_EXIT_DONE && has_rows) code = jlt_common_save(common);
    if (code == JLT_EXIT_DONE && jlt_motion_interrupted(&o->motion))
        fprintf(stderr, "jellett: interrupted; the whole rows so far are saved in %s\n", common->table.path);
    if (code == JLT_EXIT_DONE) jlt_fates_crowd_tell(&crowd, rows.starts);
    if (code == JLT_EXIT_DONE && has_rows && common->plot != NULL) code = draw_sweep(o, base, &axes[0]);
    if (code == JLT_EXIT_DONE) code = jlt_motion_failures(base, &rows.failures, rows.starts);
    if (code != JLT_EXIT_DONE || rows.outside == 0) return code;
    fprintf(stderr, "jellett: %zu of %zu points are outside the model's domain, and have no starts\n", rows.outside, all);
    return has_rows ? JLT_EXIT_DONE : JLT_EXIT_INPUT;
}

static jlt_exit run(int argc, char **argv)
{
    JLT_CLEARED(jlt_motion_end) options o = { .returns = 200 };
    JLT_OWNED(jlt_system) *system = NULL;
    JLT_CLEARED(jlt_motion_map_close) jlt_motion_map map = { .points = NULL };
    jlt_grid_axis axes[JLT_CHART_DIM_MAX], swept[JLT_FAMILY_AXES_MAX];
    size_t all;

    jlt_motion_begin(&o.motion, argc, argv);
    jlt_motion_many_begin(&o.motion);
    ttc_options_parse(&parser, argc, argv, &o);
    const bool sweeps = o.motion.common.own_sweep != NULL;
    jlt_motion_many_choose(&o.motion, o.motion.grid != NULL || o.motion.start_count != 1 || sweeps, false);
    o.motion.other = default_grid;
    o.motion.swept = swept;
    if (sweeps) JLT_PASS(read_sweep(swept, &o.motion.swept_count, &all, &o));
    JLT_PASS(jlt_motion_system(&system, &o.motion));
    if (jlt_fates_crowd_grid(&o.motion, system) == NULL && o.motion.start_count == 0)
        return jlt_command_fail(JLT_EXIT_USAGE, "say where orbits start: --start or --grid");
    JLT_PASS(jlt_motion_axes(axes, system, jlt_fates_crowd_grid(&o.motion, system), "--grid"));
    if (!sweeps) JLT_PASS(jlt_motion_map_open(&map, &o.motion, system, jlt_fates_crowd_grid(&o.motion, system), axes));
    JLT_PASS(jlt_motion_check_starts(system, o.motion.starts, o.motion.start_count));
    if (!sweeps && o.motion.start_count == 0) JLT_PASS(jlt_motion_check_grid(axes, system));
    JLT_PASS(jlt_motion_plan(system, &o.motion));
    JLT_PASS(jlt_common_write(&o.motion.common));
    return sweeps ? sweep(&o, system, all) : one_system(&o, system, &map);
}

const jlt_command jlt_command_fates = {
    "fates", "[MODEL] [OPTION...]", "How orbits end, when, or that they go on; the share that turns over", run, &parser, NULL
};
