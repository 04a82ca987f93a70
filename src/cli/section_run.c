#include "cli/section_run.h"

#include "base/text.h"

#include <math.h>
#include <string.h>

#include "cli/interrupt.h"
#include "core/memory.h"
#include "kernel/batch_isa.h"

/* For each thread: BLOCK, orbits followed together, so many that lanes rarely idle while the last ones end; ROWS, rows written
 * together. ROWS_MAX: the most rows written together, for all threads. */
enum { BLOCK = 256, ROWS = 1024, ROWS_MAX = 1 << 16 };

struct jlt_section_run_company {
    jlt_section_batch *batch;
    size_t users; /* how many runs still use it */
};

static void show(jlt_section_run *f, size_t done) { jlt_progress_show(&f->progress, done, f->all); }

/* Orbits of a batch count as half done when they are followed, and as done when their rows are written. */
static void show_batch(void *context, size_t made)
{
    jlt_section_run *f = context;
    show(f, f->before + made / 2);
}

static void show_written(jlt_section_run *f, size_t orbits, size_t number)
{
    if (f->all == 0) show(f, f->sum.rows);
    else if (f->batch == NULL) show(f, f->sum.orbits * f->returns + number);
    else show(f, f->before + f->block / 2 + (orbits * f->returns + number) / 2);
}

static jlt_status put(jlt_section_run *f, const jlt_return *at, const double *before)
{
    if (at->number < f->first && at->fate == JLT_FATE_ALIVE) return JLT_OK;
    jlt_section_row_fill(f->row, f->system->flow.chart, f->sum.orbits, at, before);
    JLT_PASS(jlt_writer_put(&f->writer, f->row));
    f->sum.rows++;
    if (at->number > 0 || f->o->motion.grid == NULL) jlt_section_picture_add(f->picture, at->q); /* without the grid of starts */
    return JLT_OK;
}

static bool stopped(const jlt_section_run *f)
{
    return jlt_motion_interrupted(&f->o->motion) && (!f->cut || jlt_interrupt_clock() - f->cut_at > 0.5);
}

/* The point at which to compute DP of the next return; NaN if the chart lifts it to another state than the orbit's. */
static void point_before(double *before, const jlt_section_run *f, const jlt_return *at)
{
    const jlt_chart *chart = f->system->flow.chart;
    const bool is_lifted = f->table.check && jlt_chart_follows(chart, at->x);

    for (unsigned k = 0; k < chart->dim; k++) before[k] = is_lifted ? at->q[k] : NAN;
}

static void count_saddle(jlt_section_run_totals *sum, const jlt_saddle_watch *saddle)
{
    if (!saddle->has_left) return;
    if (sum->beside++ > 0) return;
    sum->first_beside = sum->orbits;
    sum->from_return = saddle->at;
}

/* Write the rows of orbit number `index` of its block, and follow it unless the batch has done so. */
static jlt_status run_orbit(jlt_section_run *f, const double *q, size_t index)
{
    jlt_section_run_totals *sum = &f->sum;
    jlt_saddle_search saddles = { .number = 0 };
    jlt_return at;
    double before[JLT_CHART_DIM_MAX], q_before[JLT_CHART_DIM_MAX];

    JLT_PASS(f->batch != NULL ? jlt_section_batch_start(f->batch, &at, f->begins + index)
                              : jlt_section_start(f->section, &at, q, f->o->time_direction));
    if (at.fate == JLT_FATE_ALIVE) { /* the coordinates asked for, which those of the state are but for rounding */
        memcpy(at.q, q, f->system->flow.chart->dim * sizeof *q);
        jlt_chart_wrap(f->system->flow.chart, at.q);
    }
    if (f->levels.system == NULL) JLT_PASS(jlt_section_levels_open(&f->levels, f->system, q));
    jlt_section_levels_note(&f->levels, sum->orbits, &at);
    JLT_PASS(put(f, &at, NULL));
    while (at.fate == JLT_FATE_ALIVE && at.number < f->returns && !stopped(f)) {
        point_before(before, f, &at);
        memcpy(q_before, at.q, sizeof q_before);
        JLT_PASS(f->batch != NULL ? jlt_section_batch_next(f->batch, &at) : jlt_section_next(f->section, &at));
        if (at.interrupted) break;
        jlt_section_levels_note(&f->levels, sum->orbits, &at);
        JLT_PASS(put(f, &at, before));
        if (at.fate == JLT_FATE_ALIVE)
            JLT_PASS(jlt_saddle_search_note(&saddles, &f->map, &f->system->flow, q_before, at.q, at.number,
                                            f->o->time_direction));
        show_written(f, index, at.number);
    }
    jlt_section_picture_end(f->picture, at.fate);
    if (at.least <= 0) sum->lost[at.lost]++, sum->invalid++;
    if (isnan(at.least)) sum->unknown++;
    jlt_failures_add(&sum->failures, at.fate, at.unbounded, at.t);
    count_saddle(sum, &saddles.watch);
    sum->orbits++;
    return JLT_OK;
}

jlt_exit jlt_section_run_verdict(const jlt_section_run *f)
{
    char lost[512];
    const jlt_section_run_totals *sum = &f->sum;
    const jlt_section_run_options *o = f->o;
    const bool interrupted = jlt_motion_interrupted(&o->motion);

    if (interrupted && sum->rows > f->table.dropped)
        fprintf(stderr, "jellett: interrupted; %zu whole rows of %zu orbits are saved in %s\n", sum->rows - f->table.dropped,
                sum->orbits, f->o->motion.common.table.path);
    if (sum->empty > 0)
        fprintf(stderr, "jellett: at %zu point%s of the grid there is no state on these levels\n", sum->empty,
                ttc_text_plural(sum->empty));
    jlt_section_table_lost(lost, sizeof lost, sum->lost, sum->invalid, f->table.system->observed);
    if (sum->invalid > 0 && !o->motion.flow.end_where_invalid)
        fprintf(stderr,
                "jellett: %zu of %zu orbits lose %s, and the model does not hold from there on; they were followed all the same "
                "(--contact end stops them there)\n",
                sum->invalid, sum->orbits, lost);
    if (sum->unknown > 0)
        fprintf(stderr,
                "jellett: of %zu of %zu orbits it is not known whether the model holds: a condition of it has no value there\n",
                sum->unknown, sum->orbits);
    if (sum->beside > 0)
        fprintf(stderr,
                "jellett: %zu of %zu orbits pass nearer to a saddle than errors tell separatrices apart, orbit %zu first, in "
                "return %zu: what follows is one of the motions beside it\n",
                sum->beside, sum->orbits, sum->first_beside, sum->from_return);
    jlt_section_levels_tell(&f->levels, o->time_direction);
    JLT_PASS(jlt_motion_failures(f->system, &sum->failures, sum->orbits));
    return !o->check || jlt_section_table_verdict(&f->table) ? JLT_EXIT_DONE : JLT_EXIT_FAILED;
}

bool jlt_section_run_is_of_many(const jlt_section_run_options *o)
{
    return o->motion.grid != NULL || o->motion.start_count > 1 || o->motion.common.sweep != NULL
           || (o->project && o->motion.section == NULL);
}

static size_t starts_of(const jlt_section_run *f)
{
    const jlt_motion_options *motion = &f->o->motion;
    return motion->start_count + (motion->grid != NULL ? jlt_motion_grid_size(f->o->axes, f->system) : 0);
}

static jlt_exit read_starts(const jlt_section_run *f, double *q, size_t first, size_t count)
{
    jlt_exit code = JLT_EXIT_DONE;

    for (size_t i = 0; i < count && code == JLT_EXIT_DONE; i++)
        code = jlt_motion_any_start(q + i * f->system->flow.chart->dim, &f->o->motion, f->o->axes, f->system, first + i);
    return code;
}

/* Let a run with fewer starts than a block share a batch with other runs: read its starts into `joined`. */
static jlt_exit open_to_others(jlt_section_run *f)
{
    const size_t all = starts_of(f);

    if (all >= BLOCK * f->o->motion.threads) return JLT_EXIT_DONE;
    f->joined = calloc(all, f->system->flow.chart->dim * sizeof *f->joined);
    return f->joined != NULL ? read_starts(f, f->joined, 0, all) : jlt_command_no_memory();
}

jlt_exit jlt_section_run_open(jlt_section_run *f)
{
    const jlt_section_run_options *o = f->o;
    jlt_exit code;

    f->batch_options = (jlt_section_batch_options){ .backwards = o->time_direction < 0, .progress = show_batch, .context = f };
    f->returns = o->skip + o->returns;
    f->first = o->skip > 0 ? o->skip + 1 : 0;
    f->all = f->returns > ((size_t)1 << 40) ? 0 : starts_of(f) * f->returns;
    if (jlt_section_run_is_of_many(o)) {
        code = jlt_motion_many_open(&f->batch, &f->batch_options, &o->motion, f->system);
        if (code == JLT_EXIT_DONE && o->motion.in_lanes) code = open_to_others(f);
    } else {
        code = o->project ? jlt_motion_project(f->system) : JLT_EXIT_DONE;
        const jlt_status st = code == JLT_EXIT_DONE ? jlt_section_create(&f->section, &f->system->flow) : JLT_OK;
        if (st != JLT_OK) code = jlt_motion_fail(st, f->system, "section");
    }
    return code;
}

bool jlt_section_run_are_enough(jlt_section_run *const *runs, size_t count)
{
    size_t starts = 0;

    for (size_t i = 0; i < count; i++) starts += runs[i]->joined != NULL ? starts_of(runs[i]) : 0;
    return starts >= BLOCK * runs[0]->o->motion.threads;
}

static void leave_batch(jlt_section_run *f)
{
    if (f->company == NULL) jlt_section_batch_destroy(f->batch);
    else if (--f->company->users == 0) {
        jlt_section_batch_destroy(f->batch);
        free(f->company);
    }
    f->batch = NULL;
    f->company = NULL;
}

/* Add to the first run's batch the flows of all runs that fit. Out: flow_of, shape (count,), their numbers, SIZE_MAX where a run
 * does not fit. Returns the number of starts of all that fit. */
static size_t gather(jlt_section_run *const *runs, size_t *flow_of, size_t count)
{
    size_t starts = starts_of(runs[0]);

    flow_of[0] = 0;
    for (size_t i = 1; i < count; i++) {
        jlt_section_run *f = runs[i];
        const bool fits = f->joined != NULL && f->company == NULL &&
                          jlt_section_batch_add(runs[0]->batch, &flow_of[i], &f->system->flow, f->batch_options.project) == JLT_OK;
        if (!fits) flow_of[i] = SIZE_MAX;
        else starts += starts_of(f);
    }
    return starts;
}

/* Let all runs that fit share the batch of the first run. */
static jlt_status share_batch(jlt_section_run *const *runs, const size_t *flow_of, size_t count)
{
    jlt_section_run_company *company = calloc(1, sizeof *company);
    size_t begins = 0;

    if (company == NULL) return JLT_ERR_NOMEM;
    company->batch = runs[0]->batch;
    for (size_t i = 0; i < count; i++) {
        if (flow_of[i] == SIZE_MAX) continue;
        if (i > 0) leave_batch(runs[i]);
        runs[i]->batch = company->batch;
        runs[i]->company = company;
        runs[i]->begins = begins;
        begins += starts_of(runs[i]);
        company->users++;
    }
    return JLT_OK;
}

static jlt_status follow_group(jlt_section_run *const *runs, size_t count)
{
    const unsigned dim = runs[0]->system->flow.chart->dim;
    JLT_FREED size_t *flow_of = malloc(count * sizeof *flow_of);

    if (flow_of == NULL) return JLT_ERR_NOMEM;
    const size_t starts = gather(runs, flow_of, count);
    JLT_FREED double *q = malloc(starts * dim * sizeof *q);
    JLT_FREED size_t *each = malloc(starts * sizeof *each);
    if (q == NULL || each == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0, at = 0; i < count; i++) {
        const size_t own = flow_of[i] == SIZE_MAX ? 0 : starts_of(runs[i]);
        if (own > 0) memcpy(q + at * dim, runs[i]->joined, own * dim * sizeof *q);
        for (size_t k = 0; k < own; k++) each[at++] = flow_of[i];
    }
    JLT_PASS(jlt_section_batch_run_each(runs[0]->batch, q, each, NULL, starts, runs[0]->returns));
    return share_batch(runs, flow_of, count);
}

void jlt_section_run_follow(jlt_section_run *const *runs, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (runs[i]->joined != NULL && runs[i]->company == NULL && follow_group(runs + i, count - i) != JLT_OK) return;
}

/* Follow the orbits from the starts q, shape (count, dim), of which the first has number `first`, and write their rows. */
static jlt_exit run_block(jlt_section_run *f, const double *q, size_t first, size_t count)
{
    const jlt_section_run_options *o = f->o;
    const jlt_system *system = f->system;
    jlt_status st;

    f->before = first * f->returns;
    f->block = count * f->returns;
    if (f->batch != NULL && f->company == NULL) {
        st = jlt_section_batch_run(f->batch, q, count, f->returns);
        if (st == JLT_ERR_IO)
            return jlt_command_fail(JLT_EXIT_IO, "the temporary file of rows cannot be written: is there room in TMPDIR?");
        if (st != JLT_OK) return jlt_motion_fail(st, system, "section");
        f->cut = jlt_motion_interrupted(&o->motion);
        f->cut_at = jlt_interrupt_clock();
    }
    for (size_t i = 0; i < count && (f->batch == NULL || f->begins + i < jlt_section_batch_begun(f->batch)); i++) {
        st = run_orbit(f, q + i * system->flow.chart->dim, i);
        if (first + i >= o->motion.start_count && (st == JLT_ERR_EMPTY || st == JLT_ERR_DOMAIN)) f->sum.empty++;
        else if (ferror(f->writer.stream)) return JLT_EXIT_DONE; /* closing the stream reports it */
        else if (st != JLT_OK)
            return jlt_motion_fail(st, system,
                                   first + i < o->motion.start_count ? o->motion.starts[first + i] : "a start of the grid");
        if (stopped(f)) break;
    }
    st = jlt_writer_flush(&f->writer);
    return st == JLT_OK || ferror(f->writer.stream) ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "section");
}

/* Follow all starts, those of --start first, in blocks. */
static jlt_exit run_all(jlt_section_run *f, FILE *stream)
{
    const jlt_section_run_options *o = f->o;
    const size_t threads = o->motion.threads, room = f->batch != NULL ? BLOCK * o->motion.threads : 1;
    const size_t rows = f->batch == NULL ? 1 : ROWS * threads < ROWS_MAX ? ROWS * threads : ROWS_MAX;
    const jlt_chart *chart = f->system->flow.chart;
    const unsigned dim = chart->dim;
    const size_t all = starts_of(f);
    JLT_FREED double *q = calloc(room, dim * sizeof *q);
    jlt_exit code = JLT_EXIT_DONE;

    f->row = calloc(1, jlt_section_row_size(chart));
    if (q == NULL || f->row == NULL
        || jlt_writer_open(&f->writer, stream, jlt_section_table_row, &f->table, jlt_section_row_size(chart), rows,
                           (unsigned)threads) != JLT_OK)
        code = jlt_command_no_memory();
    if (o->check) f->writer.complete = jlt_section_table_check;
    jlt_progress_start(&f->progress, "returns");
    for (size_t first = 0, count; first < all && code == JLT_EXIT_DONE; first += count) {
        count = all - first < room ? all - first : room;
        code = read_starts(f, q, first, count);
        if (code == JLT_EXIT_DONE) code = run_block(f, q, first, count);
        if (ferror(stream) || jlt_motion_interrupted(&o->motion)) break;
    }
    jlt_progress_end(&f->progress);
    jlt_writer_close(&f->writer);
    free(f->row);
    if (code == JLT_EXIT_DONE && f->sum.orbits == 0 && f->sum.empty > 0 && o->axes[0].part == 0)
        code = jlt_motion_fail(JLT_ERR_EMPTY, f->system, "--grid");
    return code;
}

/* Open what computes DP, for which each thread needs memory: many runs may be open, but one is written at a time. */
static jlt_exit open_maps(jlt_map_batch **maps, const jlt_section_run *f)
{
    const jlt_motion_options *motion = &f->o->motion;
    const jlt_kernel_batch *kernels = motion->in_lanes ? jlt_batch_isa_best(f->system->instance->descriptor, 0) : NULL;
    const jlt_status st = jlt_map_batch_create(maps, &f->system->flow, kernels, NULL, (unsigned)motion->threads);

    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, f->system, "section");
}

jlt_exit jlt_section_run_write(jlt_section_run *f)
{
    const jlt_section_run_options *o = f->o;
    FILE *stream = o->motion.common.table.file;
    jlt_map_batch *maps = NULL;

    JLT_PASS(o->check ? open_maps(&maps, f) : JLT_EXIT_DONE);
    jlt_motion_header(stream, &o->motion, f->system);
    f->table = (jlt_section_table){ .system = f->system, .least = strcmp(o->motion.contact, "report") == 0, .check = o->check,
                                    .as_bits = o->motion.common.table.array != NULL, .maps = maps,
                                    .time_direction = o->time_direction };
    jlt_section_table_names(stream, &f->table);
    const jlt_exit code = run_all(f, stream);
    jlt_map_batch_destroy(maps);
    f->table.maps = NULL;
    return code;
}

void jlt_section_run_close(jlt_section_run *f)
{
    jlt_section_destroy(f->section);
    leave_batch(f);
    jlt_map_destroy(f->map);
    jlt_section_levels_close(&f->levels);
    free(f->joined);
}
