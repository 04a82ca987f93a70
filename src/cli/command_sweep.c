/* `jellett sweep`: computes a study, or one shard of it. */
#include <argp.h>
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <string.h>
#include <sys/stat.h>
#if defined(_OPENMP)
#include <omp.h>
#endif

#include "base/options.h"
#include "base/text.h"
#include "cli/common.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/study.h"
#include "cli/sweep_rows.h"
#include "cli/worker.h"
#include "core/memory.h"
#include "shards/deal.h"
#include "shards/manifest.h"
#include "shards/rank.h"
#include "shards/shard.h"

typedef struct {
    const char *scene, *into, *shard;
    jlt_assign_list set;
    bool resume, dry;
} options;

enum { SHARD = 1000, RESUME, DRY };

/* How long a piece should take at least. */
static const double WORTH_SECONDS = 0.25;

static const struct argp_option option_table[] = {
    { "into", 'C', "FOLDER", 0,
      "Folder for the files of shards, made if it is missing; default STUDY.shards in the current folder", 0 },
    { "shard", SHARD, "I/N", 0,
      "Compute only shard I of N, I from 1 to N. /N: take I from the environment, where GNU parallel and "
      "PMIx set it. Default: take I and N from there, where Slurm, Open MPI, and other MPIs by PMI set both; otherwise 1/1", 0 },
    { "resume", RESUME, NULL, 0, "Continue where the shard's file ends; if there is none, begin", 0 },
    { "set", 's', "PARAM=VALUE,...", TTC_OPTIONS_REPEATED,
      "Values of parameters in place of the scene's", 0 },
    { "dry-run", DRY, NULL, 0, "Show the command of every piece of the shard, but run none", 0 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case 'C': o->into = value; return 0;
    case 's': jlt_common_list(&o->set, value, "--set"); return 0;
    case SHARD: o->shard = value; return 0;
    case RESUME: o->resume = true; return 0;
    case DRY: o->dry = true; return 0;
    case ARGP_KEY_ARG:
        if (o->scene != NULL) argp_error(state, "one study at a time: '%s' is too many", value);
        o->scene = value;
        return 0;
    case ARGP_KEY_NO_ARGS: argp_error(state, "which study?"); return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "STUDY",
    "Compute a study, or one shard of it, so that many processes share its rows, on one machine or on many. A study is a scene "
    "with one command, whose grid of starts, or sweep, is cut into pieces; the scene's 'over' adds a grid of parameters and levels."
    "\v  over = { a3 = (0.1, 0.7, 13); E = (1, 4, 31); };\n"
    "  piece = 256;\n"
    "  compute = ( { what = \"fates\"; grid = \"60x40\"; } );\n\n"
    "Every shard writes a file of its own, I-of-N.shard, and adds a record to it when a piece is done. Processes do not wait for "
    "each other, and finished pieces are kept whatever becomes of a process: --resume cuts off an incomplete record and computes "
    "what is missing. A file of another study, or of other kernels, is refused, with the difference. Only one process writes a "
    "file at a time. Each uses one thread unless OMP_NUM_THREADS says otherwise. 'jellett merge' makes one table of all files.\n\n"
    "Each piece is one call of the command; choose 'piece', the number of grid points in it, so that it takes a second or so. "
    "Where the command's status is 1 or 4 its rows are kept, and the study ends with this status.\n\n"
    "Examples:\n"
    "  jellett sweep tools/scenes/turnover.scene\n"
    "  jellett sweep study.scene --shard 3/8 --resume\n"
    "  mpirun -n 8 jellett sweep study.scene\n"
    "  parallel jellett sweep study.scene --shard {}/8 ::: $(seq 8)",
    NULL, NULL, NULL,
};

typedef struct {
    const options *o;
    jlt_study study;
    jlt_rank rank;
    jlt_shard shard;
    jlt_work work;
    jlt_worker worker;
    char *folder, *path;
    unsigned char *is_done; /* shape (own,), by position in the shard's order */
    size_t own, before, lost, failed, empty; /* pieces: of the shard; done before; killed; of status > 0; without rows */
    jlt_exit worst; /* largest status of the pieces that have rows */
} sweep;

static size_t piece_at(const sweep *self, size_t position)
{
    return jlt_deal_piece(position, self->rank.index - 1, self->rank.count);
}

/* Set the path FOLDER/I-of-N.shard, and make the folder. */
static jlt_exit place(sweep *self)
{
    const char *scene = self->o->scene, *slash = strrchr(scene, '/'), *name = slash != NULL ? slash + 1 : scene;
    const char *dot = strrchr(name, '.');
    const int length = dot != NULL && dot > name ? (int)(dot - name) : (int)strlen(name);

    if ((self->o->into != NULL ? (self->folder = strdup(self->o->into)) == NULL
                               : asprintf(&self->folder, "%.*s.shards", length, name) < 0)
        || asprintf(&self->path, "%s/%zu-of-%zu.shard", self->folder, self->rank.index, self->rank.count) < 0)
        return jlt_command_no_memory();
    if (!self->o->dry && mkdir(self->folder, 0777) != 0 && errno != EEXIST)
        return jlt_command_fail(JLT_EXIT_IO, "--into %s: %s", self->folder, strerror(errno));
    return JLT_EXIT_DONE;
}

static jlt_exit refuse_lock(const sweep *self, pid_t holder)
{
    if (holder > 0)
        return jlt_command_fail(JLT_EXIT_IO, "%s: process %ld computes this shard already: give each process a shard of its own",
                                self->path, (long)holder);
    if (holder == 0)
        return jlt_command_fail(JLT_EXIT_IO, "%s: another process computes this shard already: give each process a shard of its "
                                             "own", self->path);
    return jlt_command_fail(JLT_EXIT_IO, "cannot write and lock '%s': %s", self->path, strerror(errno));
}

static jlt_exit cannot_write(const sweep *self, jlt_status st)
{
    if (st == JLT_ERR_NOMEM) return jlt_command_no_memory();
    if (errno == ESTALE)
        return jlt_command_fail(JLT_EXIT_IO, "'%s' was moved, removed or replaced while this process wrote to it", self->path);
    return jlt_command_fail(JLT_EXIT_IO, "cannot write '%s': %s (what was done before is there: --resume goes on)", self->path,
                            strerror(errno));
}

static void note(sweep *self, jlt_exit status)
{
    if (status == JLT_EXIT_INPUT) self->empty++; /* the command has no rows at this point of `over` */
    else if (status > self->worst) self->worst = status;
}

typedef struct {
    size_t piece, position; /* in the shard's order */
} own_piece;

static int by_piece(const void *a, const void *b)
{
    const size_t left = ((const own_piece *)a)->piece, right = ((const own_piece *)b)->piece;

    return left < right ? -1 : left > right;
}

/* Mark the pieces that the file has already, and continue it behind its last whole record. */
static jlt_exit take_done(sweep *self, jlt_shard_reader *reader)
{
    JLT_FREED own_piece *all = calloc(self->own + 1, sizeof *all);
    jlt_shard_record record;
    jlt_status st = all != NULL ? JLT_OK : JLT_ERR_NOMEM;

    for (size_t i = 0; st == JLT_OK && i < self->own; i++) all[i] = (own_piece){ piece_at(self, i), i };
    if (st == JLT_OK) qsort(all, self->own, sizeof *all, by_piece);
    while (st == JLT_OK && (st = jlt_shard_reader_next(reader, &record)) == JLT_OK) {
        const own_piece *found = bsearch(&(own_piece){ record.piece, 0 }, all, self->own, sizeof *all, by_piece);
        if (found == NULL || self->is_done[found->position]) continue;
        self->is_done[found->position] = 1;
        self->before++;
        note(self, (jlt_exit)record.status);
    }
    if (st == JLT_ERR_EMPTY) st = jlt_shard_resume(&self->shard, self->study.manifest, reader->at);
    return st == JLT_OK ? JLT_EXIT_DONE : cannot_write(self, st);
}

/* Open and lock the shard's file: check that it is of this study, and cut off a torn record, or begin it. */
static jlt_exit open_file(sweep *self)
{
    jlt_shard_reader reader = { .descriptor = -1 };
    JLT_FREED char *study = NULL;
    pid_t holder;
    jlt_exit code = JLT_EXIT_DONE;
    jlt_status st = jlt_shard_open(&self->shard, &holder, self->path);

    if (st != JLT_OK) return refuse_lock(self, holder);
    st = jlt_shard_reader_open(&reader, &study, self->shard.descriptor);
    if (st == JLT_ERR_ARG)
        code = jlt_command_fail(JLT_EXIT_INPUT, "'%s' is no shard of a study, or its beginning is damaged: move it away to begin "
                                                 "again", self->path);
    else if (st != JLT_OK) code = cannot_write(self, st);
    else if (study != NULL && strcmp(study, self->study.manifest) != 0) {
        code = jlt_command_fail(JLT_EXIT_INPUT, "'%s' is of another study, or of other kernels ('there'):", self->path);
        (void)jlt_manifest_difference(stderr, study, self->study.manifest);
        fputs("jellett: choose another folder, or bring back what there was\n", stderr);
    } else if (reader.size > 0 && !self->o->resume) {
        code = jlt_command_fail(JLT_EXIT_INPUT, "'%s' is there already: --resume goes on with it", self->path);
    } else {
        const off_t size = reader.size;
        if (study != NULL) code = take_done(self, &reader);
        else if ((st = jlt_shard_begin(&self->shard, self->study.manifest)) != JLT_OK) code = cannot_write(self, st);
        if (code == JLT_EXIT_DONE && reader.at < size)
            fprintf(stderr, "jellett: %s: %lld bytes behind the last record that is whole are cut\n", self->path,
                    (long long)(size - reader.at));
        if (code == JLT_EXIT_DONE && reader.skipped > 0)
            fprintf(stderr, "jellett: %s: %lld bytes among its records are damaged and left out\n", self->path,
                    (long long)reader.skipped);
    }
    jlt_shard_reader_close(&reader);
    return code;
}

/* Whether the study goes on after this status: the piece has rows, or the command refused this point of `over`. */
static bool goes_on(const sweep *self, jlt_exit status)
{
    return status == JLT_EXIT_DONE || status == JLT_EXIT_FAILED || status == JLT_EXIT_NUMERICAL
           || (status == JLT_EXIT_INPUT && self->study.over_count > 0);
}

/* Compute the piece at this position in the shard's order, by which the worker numbers its pieces, and add it to the file. */
static jlt_exit compute(sweep *self, size_t position)
{
    const size_t number = piece_at(self, position);
    char at[JLT_GRID_PLACE_MAX];
    jlt_worker *worker = &self->worker;
    jlt_exit status;
    int by;
    const jlt_exit code = jlt_worker_run(worker, &status, &by, position);

    if (code != JLT_EXIT_DONE || *worker->interrupt != 0) return code; /* drop an unfinished piece */
    jlt_study_place(at, &self->study, number);
    if (by == JLT_WORKER_WITHOUT_MEANS)
        fprintf(stderr, "jellett: piece %zu (%s) lacked memory or threads, and is left out\n%s", number, at,
                self->lost == 0 ? worker->words : "");
    else if (by != 0) fprintf(stderr, "jellett: piece %zu (%s) was ended by signal %d, and is left out\n", number, at, by);
    if (by != 0) {
        self->lost++;
        return JLT_EXIT_DONE;
    }
    if (status != JLT_EXIT_DONE && self->failed++ == 0)
        fprintf(stderr, "jellett: piece %zu (%s) ended with status %d:\n%s", number, at, (int)status, worker->words);
    if (!goes_on(self, status)) return status;
    note(self, status);
    const size_t size = jlt_sweep_rows_of(worker->rows);
    const jlt_shard_record record = { number, (int)status, worker->rows, size, worker->words, worker->words_size };
    if (record.rows_size > 0) JLT_PASS(jlt_sweep_rows_check(&self->study, worker->rows));
    jlt_interrupt_hold();
    const jlt_status st = jlt_shard_add(&self->shard, &record);
    jlt_interrupt_release();
    return st == JLT_OK ? JLT_EXIT_DONE : cannot_write(self, st);
}

/* Suggest larger pieces if they take so little time that starting them costs a noticeable share. */
static void advise(const sweep *self, size_t done, double lasted)
{
    const double factor = WORTH_SECONDS * (double)done / lasted;

    if (done < 8 || factor < 5 || self->study.piece >= self->study.inner) return;
    fprintf(stderr, "jellett: a piece took %.2g s, much of which may be its start: 'piece = %.0f;' in the study wastes less\n",
            lasted / (double)done, fmin((double)self->study.inner, ceil(factor * (double)self->study.piece)));
}

static char **arguments_of(const void *context, size_t position, int *argc)
{
    const sweep *self = context;

    return jlt_study_arguments(&self->study, piece_at(self, position), argc);
}

static size_t next_position(const void *context, size_t position)
{
    const sweep *self = context;

    do position++;
    while (position < self->own && self->is_done[position]);
    return position < self->own ? position : SIZE_MAX;
}

static jlt_exit compute_all(sweep *self, bool *interrupted)
{
    const double begun = jlt_interrupt_clock();
    jlt_progress progress;
    size_t done = 0;
    self->work = (jlt_work){ self->study.command, arguments_of, self, next_position };
    jlt_exit code = jlt_worker_open(&self->worker, &self->work);
    const volatile sig_atomic_t *const interrupt = self->worker.interrupt;

    jlt_progress_start(&progress, "pieces");
    for (size_t i = 0; code == JLT_EXIT_DONE && *interrupt == 0 && i < self->own; i++) {
        if (self->is_done[i]) continue;
        code = compute(self, i);
        if (code == JLT_EXIT_DONE && *interrupt == 0) done++;
        jlt_progress_show(&progress, self->before + done, self->own);
    }
    jlt_progress_end(&progress);
    if (jlt_shard_sync(&self->shard) != JLT_OK && code == JLT_EXIT_DONE) code = cannot_write(self, JLT_ERR_IO);
    jlt_worker_close(&self->worker);
    if (*interrupt != 0)
        fprintf(stderr, "jellett: interrupted; %zu of the shard's %zu pieces are in %s, and --resume goes on\n",
                self->before + done - self->lost,
                self->own, self->path);
    else if (code == JLT_EXIT_DONE) {
        fprintf(stderr, "jellett: %s has its %zu piece%s%s; %zu of them now, in %.3g s\n", self->path, self->own - self->lost,
                ttc_text_plural(self->own - self->lost), self->lost > 0 ? ", but for some" : "", done - self->lost,
                jlt_interrupt_clock() - begun);
        advise(self, done, jlt_interrupt_clock() - begun);
    }
    *interrupted = *interrupt != 0;
    return code;
}

static jlt_exit show_all(const sweep *self)
{
    for (size_t i = 0; i < self->own; i++) {
        int argc = 0;
        char **argv = jlt_study_arguments(&self->study, piece_at(self, i), &argc);
        char *line = argv != NULL ? jlt_command_line(argc, argv) : NULL;
        jlt_command_free(argv, argc);
        if (line == NULL) return jlt_command_no_memory();
        printf("jellett %s\n", line);
        free(line);
    }
    return JLT_EXIT_DONE;
}

static jlt_exit run_shard(sweep *self)
{
    bool interrupted = false;
    jlt_exit code = place(self);

    self->own = jlt_deal_count(self->rank.index - 1, self->rank.count, self->study.pieces);
    if (code == JLT_EXIT_DONE && self->o->dry) return show_all(self);
    self->is_done = calloc(self->own + 1, 1);
    if (self->is_done == NULL) return jlt_command_no_memory();
    if (code == JLT_EXIT_DONE) code = open_file(self);
    if (code != JLT_EXIT_DONE) return code;
    fprintf(stderr, "jellett: shard %zu/%zu%s%s%s: %zu of %zu pieces, %zu of them are there\n", self->rank.index, self->rank.count,
            self->rank.engine[0] != '\0' ? " (" : "", self->rank.engine, self->rank.engine[0] != '\0' ? ")" : "", self->own,
            self->study.pieces, self->before);
    code = compute_all(self, &interrupted);
    if (code == JLT_EXIT_DONE && !interrupted && self->lost > 0)
        code = jlt_command_fail(JLT_EXIT_NUMERICAL, "%zu piece%s left out: --resume tries again", self->lost,
                                self->lost == 1 ? " was" : "s were");
    /* Fail if no point at all has rows. This needs all pieces: one of several shards may happen to have only such points. */
    if (code == JLT_EXIT_DONE && !interrupted && self->empty == self->study.pieces) code = JLT_EXIT_INPUT;
    else if (code == JLT_EXIT_DONE && !interrupted && self->own > 0 && self->empty == self->own)
        fprintf(stderr, "jellett: the command refused every point of %s: none of its pieces (%zu) has rows\n", self->path,
                self->own);
    return code == JLT_EXIT_DONE ? self->worst : code;
}

static jlt_exit run(int argc, char **argv)
{
    options o = { 0 };
    sweep self = { .o = &o, .shard.descriptor = -1 };
    char message[JLT_RANK_TEXT_MAX];
    jlt_exit code;

    ttc_options_parse(&parser, argc, argv, &o);
#if defined(_OPENMP)
    if (getenv("OMP_NUM_THREADS") == NULL) omp_set_num_threads(1); /* one process for each processor is expected */
#endif
    if (jlt_rank_find(&self.rank, message, o.shard) != JLT_OK) code = jlt_command_fail(JLT_EXIT_USAGE, "%s", message);
    else code = jlt_study_open(&self.study, o.scene, &o.set);
    if (code == JLT_EXIT_DONE) code = run_shard(&self);
    jlt_shard_close(&self.shard);
    jlt_study_clear(&self.study);
    jlt_assign_clear(&o.set);
    free(self.is_done);
    free(self.folder);
    free(self.path);
    return code;
}

const jlt_command jlt_command_sweep = {
    "sweep", "STUDY [--shard I/N] [OPTION...]",
    "Compute a study, or a shard of it, whose rows many processes share", run, NULL, NULL
};
