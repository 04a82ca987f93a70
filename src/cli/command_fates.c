#include "cli/fates_table.h"
#include "cli/motion_family.h"
#include "cli/motion_many.h"
#include "cli/motion_map.h"
#include "cli/progress.h"
#include "report/symbol.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    jlt_motion_options motion;
    const char **starts;
    size_t start_count;
    const char *grid, *sweep;
    size_t returns;
} options;

/* Orbits that are followed at once, for each thread: so many that lanes seldom wait for the last ones. */
enum { SWEEP = 2000, BLOCK = 4096 };

static const struct argp_option option_table[] = {
    { "start", 'a', "NAME=VALUE,...", 0, "A start on the section, every coordinate; may be repeated", 1 },
    { "grid", 'g', "COUNTxCOUNT", 0,
      "A grid of starts over the whole section, or of NAME=LOW:HIGH:COUNT,...; for the spherical top default 60x40 when there is no "
      "--start", 1 },
    { "returns", 'n', "N", 0, "Returns after which an orbit counts as alive; default 200", 1 },
    { "sweep", SWEEP, "PARAM|LEVEL=LOW:HIGH:COUNT,...", 0,
      "Shares of the fates as parameters and levels run, the last one fastest, in place of a row for every start", 1 },
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
    case 'g': o->motion.grid = value; return 0;
    case 'n': jlt_common_count(&o->returns, value, 1, 1000000000000, "--returns"); return 0;
    case SWEEP: o->sweep = value; return 0;
    case ARGP_KEY_END:
        if (o->sweep != NULL && o->motion.common.axes != NULL) argp_error(state, "--axes are those of a grid of fates: leave out --sweep");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "How orbits end, and when, or that they go on, for starts on the section: of the spherical top at which pole, and which share "
    "turns over."
    "\vColumns: the coordinates of the start, fate, t_end, and quantities at the end, NAME_end: of the spherical top three "
    "velocities, of another model all its states; for orbits that are alive, the last return. Fates are those of jellett "
    "section, and so are empty fields and the status 4 where the method failed on an orbit.\n\n"
    "An orbit of the spherical top turns over when it starts with its centre of mass below the centre of the sphere and ends at the "
    "pole where it is above. With --sweep, columns: the values, starts, low_starts, the fates (pole+, pole-, lost_contact, equilibrium, "
    "alive, budget), failed, turned, turned_error, turned_in_contact: failed, those the method failed on; then the share of the low "
    "starts that turns over, its binomial standard error, and the share that does so with the model valid all the way; starts are even "
    "in the coordinates. Of other models columns are the values, starts, fates, failed, and where the table has conditions NAME_held: on how "
    "many starts they held all the way. Orbits go at once as those of jellett section, by a method that --tol chooses, or by --method one "
    "at a time.\n\n"
    "  jellett fates --grid 300x200 --plot fates.png > fates.csv\n"
    "  jellett fates --grid eta=-pi:pi:60,gamma3=-0.9999:-0.99:10\n"
    "  jellett fates --sweep E=0.6:4:18 --plot share.svg\n"
    "  jellett fates lorenz --section z=27 --grid x=-20:20:9,y=-20:20:9",
    children, NULL, NULL,
};

static const char default_grid[] = "60x40";

/* NULL: none. */
static const char *grid_of(const options *o, const jlt_system *system)
{
    return o->motion.grid != NULL ? o->motion.grid : o->motion.start_count > 0 || system->surface == NULL ? NULL : default_grid;
}

/* What starts of one system are followed with, and what becomes of them. */
typedef struct {
    const options *o;
    jlt_system *system;
    jlt_shares *sum;
    FILE *file;           /* of rows; NULL: they are only counted */
    jlt_motion_map *map;  /* NULL: there is no picture */
    jlt_section_batch *batch;
    jlt_grid_axis axes[JLT_CHART_DIM_MAX];
    jlt_progress *progress;
    size_t before, whole; /* starts of the systems before, and how many systems there are; of one 0 and 1 */
} crowd;

/* What has become of start `index`, which is `number` of its block. */
static jlt_exit count_start(crowd *self, const double *q, size_t index, size_t number)
{
    const options *o = self->o;
    jlt_return last;
    const jlt_status st = jlt_section_batch_last(self->batch, &last, number);

    if (index >= o->motion.start_count && (st == JLT_ERR_EMPTY || st == JLT_ERR_DOMAIN)) {
        self->sum->empty++;
        return JLT_EXIT_DONE;
    }
    if (st != JLT_OK) return jlt_motion_fail(st, self->system, index < o->motion.start_count ? o->motion.starts[index] : "a start of the grid");
    if (last.interrupted) return JLT_EXIT_DONE;
    const jlt_fates_end end = jlt_fates_of(&last);
    jlt_shares_add(self->sum, self->system, q, &end);
    if (self->file != NULL) jlt_fates_table_row(self->file, &o->motion, self->system, q, &end);
    if (self->map != NULL) jlt_motion_map_add(self->map, q, (double)end.fate);
    return JLT_EXIT_DONE;
}

/* So many starts from number `first` on, all of `all`. */
static jlt_exit follow_block(crowd *self, double *q, size_t first, size_t count, size_t all)
{
    const options *o = self->o;
    const unsigned dim = self->system->flow.chart->dim;
    jlt_exit code = JLT_EXIT_DONE;

    for (size_t i = 0; code == JLT_EXIT_DONE && i < count; i++)
        code = jlt_motion_any_start(q + i * dim, &o->motion, self->axes, self->system, first + i);
    if (code != JLT_EXIT_DONE) return code;
    const jlt_status st = jlt_section_batch_run(self->batch, q, count, o->returns);
    if (st != JLT_OK) return jlt_motion_fail(st, self->system, "section");
    for (size_t i = 0; code == JLT_EXIT_DONE && i < count; i++) code = count_start(self, q + i * dim, first + i, i);
    jlt_progress_show(self->progress, self->before + first + count, self->whole * all);
    return code;
}

/* All starts of one system. */
static jlt_exit follow_all(crowd *self)
{
    const options *o = self->o;
    const char *grid = grid_of(o, self->system);
    const size_t block = BLOCK * o->motion.threads;
    jlt_section_batch_options batch = { .last_only = true };
    double *q = malloc(block * self->system->flow.chart->dim * sizeof *q);
    size_t all = o->motion.start_count;
    jlt_exit code = q != NULL ? jlt_motion_axes(self->axes, self->system, grid, "--grid") : jlt_command_no_memory();

    if (code == JLT_EXIT_DONE) code = jlt_motion_many_open(&self->batch, &batch, &o->motion, self->system);
    if (grid != NULL && code == JLT_EXIT_DONE) all += jlt_motion_grid_size(self->axes, self->system);
    for (size_t first = 0; code == JLT_EXIT_DONE && first < all && !jlt_motion_interrupted(&o->motion); first += block)
        code = follow_block(self, q, first, all - first < block ? all - first : block, all);
    jlt_section_batch_destroy(self->batch);
    free(q);
    return code;
}

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
    jlt_shares sum = { .empty = 0 };
    jlt_progress progress;
    jlt_exit code;

    jlt_motion_header(common->table.file, &o->motion, system);
    jlt_fates_table_names(common->table.file, &o->motion, system);
    jlt_progress_start(&progress, "starts");
    code = follow_all(&(crowd){ .o = o, .system = system, .sum = &sum, .file = common->table.file, .map = map, .progress = &progress,
                                .whole = 1 });
    jlt_progress_end(&progress);
    if (code == JLT_EXIT_DONE && sum.all.starts == 0 && sum.empty > 0 && (map->axes == NULL || map->axes[0].part == 0))
        code = jlt_motion_fail(JLT_ERR_EMPTY, system, "--grid");
    if (code == JLT_EXIT_DONE) code = jlt_common_save(common);
    if (code == JLT_EXIT_DONE) {
        if (jlt_motion_interrupted(&o->motion)) fprintf(stderr, "jellett: interrupted; whole rows are saved in %s\n", common->table.path);
        fputs("jellett: ", stderr);
        jlt_fates_table_summary(stderr, &o->motion, system, &sum);
        if (map->points != NULL) code = draw_fates(o, system, map, &sum);
    }
    if (code == JLT_EXIT_DONE && jlt_shares_failed(&sum) > 0) code = jlt_motion_failures(jlt_shares_failed(&sum), sum.all.starts);
    return code;
}

/* The last column of $SHARES is what is left when orbits that turn over in contact are counted; of other sections those alive. */
static jlt_exit draw_sweep(const options *o, const jlt_system *system, const jlt_grid_axis *axis)
{
    const bool turns = jlt_shares_turn(system);
    char label[JLT_LOOK_LABEL_MAX];
    jlt_plot plot;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    jlt_plot_block(&plot, "SHARES", o->motion.common.drawn);
    jlt_plot_words(&plot, "Share of orbits that %s\n", turns ? "turn over" : "go on");
    jlt_motion_caption(&plot, system, axis->name);
    jlt_look_label(label, axis->name, "");
    jlt_plot_axis(&plot, 'x', label, jlt_extent_wider((jlt_extent){ fmin(axis->low, axis->high), fmax(axis->low, axis->high) }), 0);
    jlt_plot_axis(&plot, 'y', turns ? "share of low starts" : "share of starts", (jlt_extent){ 0, 1 }, 0);
    fputs("plot $SHARES using 1:2:3 ", plot.stream);
    jlt_look_pen(plot.stream, plot.look, (jlt_pen){ "yerrorlines", .colour = 2, .size = 0.6 });
    fprintf(plot.stream, " title '%s'", turns ? "turned over" : "alive");
    if (turns) {
        fputs(", $SHARES using 1:4 ", plot.stream);
        jlt_look_pen(plot.stream, plot.look, (jlt_pen){ "linespoints", .colour = 1, .dash = 1, .mark = 3, .size = 0.6 });
        fputs(" title 'in contact all the way'", plot.stream);
    }
    fputc('\n', plot.stream);
    return jlt_plot_draw(&plot);
}

static jlt_exit read_sweep(jlt_grid_axis *axes, size_t *count, size_t *all, const options *o)
{
    const jlt_exit code = jlt_grid_parse(axes, count, JLT_FAMILY_AXES_MAX, o->sweep, "--sweep");

    if (code != JLT_EXIT_DONE) return code;
    if (*count == 0) return jlt_command_fail(JLT_EXIT_USAGE, "--sweep: nothing runs (write NAME=LOW:HIGH:COUNT,...)");
    if (jlt_grid_size(all, axes, *count, o->sweep, "--sweep") != JLT_EXIT_DONE) return JLT_EXIT_INPUT;
    if (o->motion.common.plot != NULL && *count != 1)
        return jlt_command_fail(JLT_EXIT_USAGE, "--plot draws against what one --sweep runs over");
    return JLT_EXIT_DONE;
}

static jlt_exit sweep(options *o, const jlt_system *base)
{
    jlt_common *common = &o->motion.common;
    jlt_motion_family family = { .surface = NULL };
    jlt_grid_axis axes[JLT_FAMILY_AXES_MAX];
    jlt_progress progress;
    size_t done = 0, failed = 0, starts = 0, all = 1, count = 0;
    jlt_exit code = read_sweep(axes, &count, &all, o);

    if (code == JLT_EXIT_DONE) code = jlt_motion_family_open(&family, base, &o->motion, axes, count, "--sweep");
    if (code != JLT_EXIT_DONE) goto done;
    jlt_motion_options motion = o->motion;
    motion.swept = axes;
    motion.swept_count = count;
    jlt_motion_header(common->table.file, &motion, base);
    jlt_fates_table_share_names(common->table.file, base, axes, count);
    jlt_progress_start(&progress, "starts");
    for (size_t i = 0; code == JLT_EXIT_DONE && i < all && !jlt_motion_interrupted(&o->motion); i++) {
        jlt_shares sum = { .empty = 0 };
        jlt_system *system = NULL;
        double at[JLT_FAMILY_AXES_MAX];
        jlt_grid_point(at, axes, count, i);
        for (size_t k = 0; k < count; k++) *family.entries[k] = at[k];
        const jlt_status st = jlt_motion_family_make(&family, &system);
        if (st != JLT_OK && st != JLT_ERR_EMPTY) code = jlt_motion_family_fail(&family, st, "--sweep", axes, count);
        else if (st == JLT_OK) code = follow_all(&(crowd){ .o = o, .system = system, .sum = &sum, .progress = &progress, .before = done,
                                                       .whole = all });
        jlt_system_destroy(system);
        if (code != JLT_EXIT_DONE || jlt_motion_interrupted(&o->motion)) break;
        done += sum.all.starts + sum.empty;
        starts += sum.all.starts;
        failed += jlt_shares_failed(&sum);
        jlt_fates_table_shares(common->table.file, common->points, base, at, count, &sum);
    }
    jlt_progress_end(&progress);
    if (code == JLT_EXIT_DONE) code = jlt_common_save(common);
    if (code == JLT_EXIT_DONE && jlt_motion_interrupted(&o->motion))
        fprintf(stderr, "jellett: interrupted; the whole rows so far are saved in %s\n", common->table.path);
    if (code == JLT_EXIT_DONE && common->plot != NULL) code = draw_sweep(o, base, &axes[0]);
    if (code == JLT_EXIT_DONE && failed > 0) code = jlt_motion_failures(failed, starts);
    if (code == JLT_EXIT_DONE && starts == 0 && axes[0].part == 0 && !jlt_motion_interrupted(&o->motion)) code = jlt_motion_fail(JLT_ERR_EMPTY, base, "--sweep");
done:
    jlt_motion_family_clear(&family);
    return code;
}

static jlt_exit run(int argc, char **argv)
{
    options o = { .returns = 200 };
    jlt_system *system = NULL;
    jlt_grid_axis axes[JLT_CHART_DIM_MAX];
    jlt_motion_map map = { .points = NULL };
    jlt_exit code;

    jlt_motion_begin(&o.motion, argc, argv);
    jlt_motion_many_begin(&o.motion);
    argp_parse(&parser, argc, argv, 0, NULL, &o);
    jlt_motion_many_choose(&o.motion, o.motion.grid != NULL || o.motion.start_count != 1, false);
    o.motion.other = default_grid;
    code = jlt_motion_system(&system, &o.motion);
    if (code == JLT_EXIT_DONE && grid_of(&o, system) == NULL && o.motion.start_count == 0)
        code = jlt_command_fail(JLT_EXIT_USAGE, "say where orbits start: --start or --grid");
    if (code == JLT_EXIT_DONE) code = jlt_motion_axes(axes, system, grid_of(&o, system), "--grid");
    if (code == JLT_EXIT_DONE && o.sweep == NULL) code = jlt_motion_map_open(&map, &o.motion, system, grid_of(&o, system), axes);
    if (code == JLT_EXIT_DONE) code = jlt_motion_check_starts(system, o.motion.starts, o.motion.start_count);
    if (code == JLT_EXIT_DONE) code = jlt_common_write(&o.motion.common);
    if (code == JLT_EXIT_DONE) code = o.sweep != NULL ? sweep(&o, system) : one_system(&o, system, &map);
    jlt_motion_map_close(&map);
    jlt_system_destroy(system);
    jlt_motion_end(&o.motion);
    return code;
}

const jlt_command jlt_command_fates = {
    "fates", "[MODEL] [OPTION...]", "How orbits end, when, or that they go on; the share that turns over", run, &parser
};
