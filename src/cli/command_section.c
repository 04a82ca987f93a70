#include "cli/motion_many.h"
#include "cli/progress.h"
#include "cli/section_picture.h"
#include "cli/section_table.h"
#include "cli/swept.h"
#include "cli/writer.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Of many orbits, for each thread: those that are followed at once, so many that lanes seldom wait for the last ones; rows that are
 * written at once. For all threads together: the most of these rows. */
enum { BLOCK = 256, ROWS = 1024, ROWS_MAX = 1 << 16 };

typedef struct {
    jlt_motion_options motion;
    jlt_grid_axis axes[JLT_CHART_DIM_MAX]; /* of the grid */
    size_t returns, skip;
    int time_direction;
    bool check;
    bool project;
} options;

enum { SKIP = 2000, BACKWARD, CHECK, PROJECT };

static const struct argp_option option_table[] = {
    { "start", 'a', "NAME=VALUE,...", 0, "A start on the section, every coordinate of it; may be repeated", 1 },
    { "grid", 'g', "COUNTxCOUNT", 0,
      "A grid of starts over the whole section, or of NAME=LOW:HIGH:COUNT,...; points where the levels are empty are passed "
      "over", 1 },
    { "returns", 'n', "N", 0, "Returns of every orbit; default 100", 1 },
    { "skip", SKIP, "N|0", 0, "Returns left out before these, and the start with them; an end among them is shown", 1 },
    { "backward", BACKWARD, NULL, 0, "Go backwards in time", 1 },
    { "check", CHECK, NULL, 0,
      "The derivative DP of every return by the variational equations, and its determinant against the flux through the "
      "section and the integral of the divergence", 1 },
    { "project", PROJECT, NULL, 0, "Back onto the integrals' levels of the start: in lanes at every crossing, else after every step", 2 },
    { 0 },
};

static const struct argp_child children[] = { { &jlt_motion_argp, 0, NULL, 0 }, { &jlt_contact_argp, 0, NULL, 0 },
                                              { &jlt_motion_many_argp, 0, NULL, 0 }, { &jlt_plot_axes_argp, 0, NULL, 0 },
                                              { &jlt_swept_argp, 0, NULL, 0 }, { 0 } };

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case ARGP_KEY_INIT: return jlt_common_inputs(state, children);
    case 'a': o->motion.starts[o->motion.start_count++] = value; return 0;
    case 'g': o->motion.grid = value; return 0;
    case 'n': jlt_common_count(&o->returns, value, 1, SIZE_MAX / 4, "--returns"); return 0;
    case SKIP: jlt_common_count(&o->skip, value, 0, SIZE_MAX / 4, "--skip"); return 0;
    case BACKWARD: o->time_direction = -1; return 0;
    case CHECK: o->check = true; return 0;
    case PROJECT: o->project = true; return 0;
    case ARGP_KEY_END:
        if (o->motion.start_count == 0 && o->motion.grid == NULL) argp_error(state, "say where to start: --start or --grid");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[MODEL]",
    "The Poincare map of the spherical top at levels of E and G: the returns of orbits, and what becomes of them. For another model, on "
    "--section STATE=VALUE, in all its other states or, with --level and --solve, fewer."
    "\vColumns: orbit, return, t, the coordinates, quantities beside them (of the spherical top three velocities), fate. Return 0 is the "
    "start. An orbit that ends has a last row with its fate: pole+ or pole- (the axis is vertical; velocities are the limits), lost_contact, "
    "equilibrium (it has come to rest to within 1000 tolerances; the limits), left_domain (the model's domain ends there), "
    "budget (one return took more than 100000 steps); or, where the method failed, nonfinite, no_convergence or no_progress: "
    "then the status is 4, and all other orbits are there. Coordinates of the section are empty in that row, and so is what the "
    "levels do not tell at a pole. With --check: trace and det of DP at that return, divergence (its integral on the levels), and defect, "
    "det less flux(start)/flux(end) exp(divergence) relative to the size of DP; status 1 when one is beyond what an error of a tolerance "
    "a step makes of it, which is much where the section is crossed slowly.\n\n"
    "More than one orbit go at once, in lanes of vectors and on all processors, by a Runge-Kutta method that --tol chooses, and near a pole "
    "or at rest one at a time; jellett plan section ... and the header tell by which method, or why there are no lanes. They go in blocks "
    "of 256 a thread, and a block's rows are written when it is done; rows beyond 1024 of an orbit, or beyond 256 MiB, wait in a file in "
    "TMPDIR. One orbit alone, and all with --method, go by the method named, gauss by default.\n\n"
    "  jellett section --level E=2.15,G=-0.56 --start eta=0.1,gamma3=-0.6 \\\n"
    "    --returns 10 --tol 1e-13\n"
    "  jellett section --grid 24x16 --returns 400 --plot section.svg > section.csv\n"
    "  jellett section --threads 2 --grid 100x100 > section.csv",
    children, NULL, NULL,
};

/* Counts for the closing words. */
typedef struct {
    size_t orbits, empty, rows, invalid, unknown, failed;
    size_t lost[JLT_OBSERVED_CONDITIONS_MAX]; /* of the invalid: by condition, the one that is lost most */
} totals;

/* How orbits are followed: by the section, or many at once by the batch. */
typedef struct {
    const options *o;
    jlt_system *system;
    totals *sum;
    jlt_section_picture *picture;
    jlt_section_table table;
    jlt_writer writer; /* of the table */
    jlt_section_row *row;
    jlt_map *map;      /* of --check */
    jlt_section *section;
    jlt_section_batch *batch; /* NULL: one at a time */
    jlt_progress progress;
    size_t returns, all;      /* of each orbit, if it does not end; of all orbits, 0: endless */
    size_t first;             /* number of the first return that is shown */
    size_t before;            /* returns of the blocks before */
    size_t block;             /* returns of the block that is being followed */
    bool cut;                 /* an interrupt came before the batch was done: its rows are written, for half a second */
    struct timespec cut_at;
} follower;

static void show(follower *f, size_t done) { jlt_progress_show(&f->progress, done, f->all); }

/* Many at once are half done when they are followed, and done when they are written. */
static void show_batch(void *context, size_t made)
{
    follower *f = context;
    show(f, f->before + made / 2);
}

static void show_written(follower *f, size_t orbits, size_t number)
{
    if (f->all == 0) show(f, f->sum->rows);
    else if (f->batch == NULL) show(f, f->sum->orbits * f->returns + number);
    else show(f, f->before + f->block / 2 + (orbits * f->returns + number) / 2);
}

static jlt_status put(follower *f, const jlt_return *at, const double *before)
{
    if (at->number < f->first && at->fate == JLT_FATE_ALIVE) return JLT_OK;
    jlt_section_row_fill(f->row, f->system->flow.chart, f->sum->orbits, at, before);
    const jlt_status st = jlt_writer_put(&f->writer, f->row);

    if (st != JLT_OK) return st;
    f->sum->rows++;
    return jlt_section_picture_add(f->picture, at->q);
}

static bool stopped(const follower *f)
{
    struct timespec now;

    if (!jlt_motion_interrupted(&f->o->motion)) return false;
    if (!f->cut) return true;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - f->cut_at.tv_sec) + 1e-9 * (double)(now.tv_nsec - f->cut_at.tv_nsec) > 0.5;
}

/* Orbit number `index` of its block. */
static jlt_status run_orbit(follower *f, const double *q, size_t index)
{
    totals *sum = f->sum;
    jlt_return at;
    double before[JLT_CHART_DIM_MAX];
    jlt_status st = f->batch != NULL ? jlt_section_batch_start(f->batch, &at, index)
                                     : jlt_section_start(f->section, &at, q, f->o->time_direction);

    if (st != JLT_OK) return st;
    JLT_TRY(put(f, &at, NULL));
    while (at.fate == JLT_FATE_ALIVE && at.number < f->returns && !stopped(f)) {
        memcpy(before, at.q, f->system->flow.chart->dim * sizeof *before);
        JLT_TRY(f->batch != NULL ? jlt_section_batch_next(f->batch, &at) : jlt_section_next(f->section, &at));
        if (at.interrupted) break;
        JLT_TRY(put(f, &at, before));
        show_written(f, index, at.number);
    }
    jlt_section_picture_end(f->picture, at.fate);
    if (at.least <= 0) sum->lost[at.lost]++, sum->invalid++;
    if (isnan(at.least)) sum->unknown++;
    if (jlt_section_failed(at.fate)) sum->failed++;
    sum->orbits++;
done:
    return st;
}

static jlt_exit closing_words(const follower *f)
{
    char lost[512];
    const totals *sum = f->sum;
    const options *o = f->o;
    const bool interrupted = jlt_motion_interrupted(&o->motion);

    if (interrupted)
        fprintf(stderr, "jellett: interrupted; %zu whole rows of %zu orbits are saved in %s\n", sum->rows, sum->orbits,
                f->o->motion.common.table.path);
    if (sum->empty > 0)
        fprintf(stderr, "jellett: %zu points of the grid have no state on these levels\n", sum->empty);
    jlt_section_table_lost(lost, sizeof lost, sum->lost, sum->invalid, f->table.system->observed);
    if (sum->invalid > 0 && !o->motion.flow.end_where_invalid)
        fprintf(stderr,
                "jellett: %zu of %zu orbits lose %s, and the model does not hold from there on; they were followed all the same "
                "(--contact end stops them there)\n",
                sum->invalid, sum->orbits, lost);
    if (sum->unknown > 0)
        fprintf(stderr, "jellett: of %zu of %zu orbits it is not known whether the model holds: a condition of it has no value there\n",
                sum->unknown, sum->orbits);
    if (sum->failed > 0) return jlt_motion_failures(sum->failed, sum->orbits);
    return !o->check || jlt_section_table_verdict(&f->table) ? JLT_EXIT_DONE : JLT_EXIT_FAILED;
}

/* Whether orbits are followed together: an orbit put back onto integrals of a section that tables describe as well, which lanes can. */
static bool are_many(const options *o)
{
    return o->motion.grid != NULL || o->motion.start_count > 1 || (o->project && o->motion.section == NULL);
}

/* Whatever orbits are followed with. */
static jlt_exit open_follower(follower *f)
{
    const options *o = f->o;
    jlt_section_batch_options batch = { .backwards = o->time_direction < 0, .progress = show_batch, .context = f };
    jlt_exit code;

    if (are_many(o)) {
        code = jlt_motion_many_open(&f->batch, &batch, &o->motion, f->system);
    } else {
        code = o->project ? jlt_motion_project(f->system) : JLT_EXIT_DONE;
        const jlt_status st = code == JLT_EXIT_DONE ? jlt_section_create(&f->section, &f->system->flow) : JLT_OK;
        if (st != JLT_OK) code = jlt_motion_fail(st, f->system, "section");
    }
    if (code != JLT_EXIT_DONE || !o->check) return code;
    const jlt_status st = jlt_map_create(&f->map, &f->system->flow);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, f->system, "section");
}

/* Orbits from so many starts, the first of which has the number `first`. */
static jlt_exit run_block(follower *f, const double *q, size_t first, size_t count)
{
    const options *o = f->o;
    const jlt_system *system = f->system;
    jlt_status st;

    f->before = first * f->returns;
    f->block = count * f->returns;
    if (f->batch != NULL) {
        st = jlt_section_batch_run(f->batch, q, count, f->returns);
        if (st == JLT_ERR_IO)
            return jlt_command_fail(JLT_EXIT_IO, "the temporary file of rows cannot be written: is there room in TMPDIR?");
        if (st != JLT_OK) return jlt_motion_fail(st, system, "section");
        f->cut = jlt_motion_interrupted(&o->motion);
        clock_gettime(CLOCK_MONOTONIC, &f->cut_at);
    }
    for (size_t i = 0; i < (f->batch != NULL ? jlt_section_batch_begun(f->batch) : count); i++) {
        st = run_orbit(f, q + i * system->flow.chart->dim, i);
        if (first + i >= o->motion.start_count && (st == JLT_ERR_EMPTY || st == JLT_ERR_DOMAIN)) f->sum->empty++;
        else if (ferror(f->writer.stream)) return JLT_EXIT_DONE; /* it says so when it is closed */
        else if (st != JLT_OK)
            return jlt_motion_fail(st, system, first + i < o->motion.start_count ? o->motion.starts[first + i] : "a start of the grid");
        if (stopped(f)) break;
    }
    st = jlt_writer_flush(&f->writer);
    return st == JLT_ERR_NOMEM ? jlt_command_no_memory() : JLT_EXIT_DONE;
}

/* All starts, those of --start first. */
static jlt_exit run_all(follower *f, FILE *stream)
{
    const options *o = f->o;
    const size_t threads = o->check ? 1 : o->motion.threads, room = f->batch != NULL ? BLOCK * o->motion.threads : 1;
    const size_t rows = f->batch == NULL ? 1 : ROWS * threads < ROWS_MAX ? ROWS * threads : ROWS_MAX;
    const jlt_chart *chart = f->system->flow.chart;
    const unsigned dim = chart->dim;
    const size_t grid = o->motion.grid != NULL ? jlt_motion_grid_size(o->axes, f->system) : 0, all = o->motion.start_count + grid;
    double *q = calloc(room, dim * sizeof *q);
    jlt_exit code = JLT_EXIT_DONE;

    f->row = calloc(1, jlt_section_row_size(chart));
    if (q == NULL || f->row == NULL
        || jlt_writer_open(&f->writer, stream, jlt_section_table_row, &f->table, jlt_section_row_size(chart), rows,
                           (unsigned)threads) != JLT_OK)
        code = jlt_command_no_memory();
    f->returns = o->skip + o->returns;
    f->first = o->skip > 0 ? o->skip + 1 : 0;
    f->all = f->returns > ((size_t)1 << 40) ? 0 : all * f->returns;
    jlt_progress_start(&f->progress, "returns");
    for (size_t first = 0, count; first < all && code == JLT_EXIT_DONE; first += count) {
        for (count = 0; count < room && first + count < all && code == JLT_EXIT_DONE; count++)
            code = jlt_motion_any_start(q + count * dim, &o->motion, o->axes, f->system, first + count);
        if (code == JLT_EXIT_DONE) code = run_block(f, q, first, count);
        if (ferror(stream) || jlt_motion_interrupted(&o->motion)) break;
    }
    jlt_progress_end(&f->progress);
    jlt_writer_close(&f->writer);
    free(f->row);
    free(q);
    if (code == JLT_EXIT_DONE && f->sum->orbits == 0 && f->sum->empty > 0 && o->axes[0].part == 0)
        code = jlt_motion_fail(JLT_ERR_EMPTY, f->system, "--grid");
    return code;
}

static const jlt_swept_form swept = { &jlt_command_section, true, 3 };

static jlt_exit run(int argc, char **argv)
{
    options o = { .returns = 100, .time_direction = 1 };
    totals sum = { 0 };
    jlt_section_picture picture = { 0 };
    follower f = { .o = &o, .sum = &sum, .picture = &picture };
    jlt_common *common = &o.motion.common;
    jlt_system *system = NULL;
    jlt_exit code, verdict;

    jlt_motion_begin(&o.motion, argc, argv);
    jlt_motion_many_begin(&o.motion);
    argp_parse(&parser, argc, argv, 0, NULL, &o);
    jlt_motion_many_choose(&o.motion, are_many(&o), o.project);
    if (jlt_swept_done(&code, &swept, &o.motion.common)) goto done;
    code = jlt_motion_system(&system, &o.motion);
    if (code == JLT_EXIT_DONE && o.motion.common.plot != NULL) code = jlt_section_picture_open(&picture, &o.motion, system);
    if (code == JLT_EXIT_DONE) code = jlt_motion_axes(o.axes, system, o.motion.grid, "--grid");
    if (code == JLT_EXIT_DONE) code = jlt_motion_check_starts(system, o.motion.starts, o.motion.start_count);
    f.system = system;
    if (code == JLT_EXIT_DONE) code = open_follower(&f);
    if (code == JLT_EXIT_DONE) code = jlt_common_write(common);
    if (code != JLT_EXIT_DONE) goto done;
    jlt_motion_header(common->table.file, &o.motion, system);
    f.table = (jlt_section_table){ .system = system, .least = strcmp(o.motion.contact, "report") == 0, .check = o.check,
                                   .map = f.map, .time_direction = o.time_direction };
    jlt_section_table_names(common->table.file, &f.table);
    code = run_all(&f, common->table.file);
    if (code == JLT_EXIT_DONE) code = jlt_common_save(common);
    if (code != JLT_EXIT_DONE) goto done;
    verdict = closing_words(&f);
    if (o.motion.common.plot != NULL)
        code = jlt_section_picture_draw(&picture, &o.motion.common, system, o.motion.grid, o.axes, o.returns);
    if (code == JLT_EXIT_DONE) code = verdict;
done:
    jlt_section_destroy(f.section);
    jlt_section_batch_destroy(f.batch);
    jlt_system_destroy(system);
    jlt_motion_end(&o.motion);
    jlt_map_destroy(f.map);
    jlt_section_picture_close(&picture);
    return code;
}

const jlt_command jlt_command_section = {
    "section", "[MODEL] --start ...|--grid ... [OPTION...]", "Poincare map at levels of E and G: returns, fates, picture", run, &parser
};
