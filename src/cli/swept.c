#include "cli/swept.h"

#include "base/text.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "cli/program.h"
#include "cli/progress.h"
#include "cli/swept_rows.h"
#include "cli/worker.h"
#include "kernel/descriptor.h"

enum { SWEEP = 2900 };

static const struct argp_option option_table[] = {
    { "sweep", SWEEP, "PARAM|LEVEL=LOW:HIGH:COUNT,...", 0,
      "Repeat the whole computation at every point of a grid of parameters and levels; their values are the first columns "
      "of each row. A picture then shows one column over another, by default over the first of these values", 10 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    jlt_common *common = state->input;

    if (key != SWEEP) return ARGP_ERR_UNKNOWN;
    common->sweep = value;
    return 0;
}

const struct argp jlt_swept_argp = { option_table, parse, NULL, NULL, NULL, NULL, NULL };

typedef struct {
    const jlt_swept_form *form;
    jlt_common *common;
    const jlt_descriptor *model;
    jlt_swept_rows rows;
    size_t all;   /* points */
    jlt_worker worker;
    char *told;   /* the last messages of a point that were shown */
    size_t repeated, repeated_at; /* later points at which they were the same; the last of these */
    size_t refused; /* points that refused their input */
    jlt_exit worst; /* largest status of the other points */
} sweep;

/* ---- the command line of a point ---- */

/* The command line of a point: the hidden options come after all typed ones, so that they win, but before a "--", behind which are
 * only operands. */
static char **arguments(const void *context, size_t point, int *argc)
{
    const sweep *self = context;
    const int count = self->common->argc;
    char *const *typed = self->common->argv, **argv = calloc((size_t)count + 3, sizeof *argv);
    int used = 0, at = 0;
    bool whole = argv != NULL;

    for (; whole && at < count && strcmp(typed[at], "--") != 0; at++) whole = (argv[used++] = strdup(typed[at])) != NULL;
    for (int params = 1; whole && params >= 0; params--) {
        char *option = jlt_grid_assignments(params != 0 ? JLT_COMMAND_HIDDEN "set" : JLT_COMMAND_HIDDEN "level", self->rows.axes,
                                            self->rows.count, point, self->model, params != 0);
        whole = option != NULL;
        if (whole && option[0] != '\0') argv[used++] = option;
        else free(option);
    }
    for (; whole && at < count; at++) whole = (argv[used++] = strdup(typed[at])) != NULL;
    *argc = used;
    if (whole) return argv;
    jlt_command_free(argv, used);
    return NULL;
}

static size_t next_point(const void *context, size_t point)
{
    return point + 1 < ((const sweep *)context)->all ? point + 1 : SIZE_MAX;
}

/* ---- what a point wrote ---- */

/* Print at how many points the last messages were repeated. */
static void tell_repeated(sweep *self)
{
    char where[JLT_GRID_PLACE_MAX];

    if (self->repeated == 0) return;
    (void)jlt_grid_place(where, self->rows.axes, self->rows.count, self->repeated_at);
    fprintf(stderr, "jellett: the same at %zu more point%s, up to %s\n", self->repeated, ttc_text_plural(self->repeated), where);
    self->repeated = 0;
}

/* Print the messages of a point, or count them if they are those that were printed last. */
static void tell(sweep *self, size_t point, const char *words)
{
    char where[JLT_GRID_PLACE_MAX];

    if (*words == '\0') return;
    if (self->told != NULL && strcmp(self->told, words) == 0) {
        self->repeated++;
        self->repeated_at = point;
        return;
    }
    tell_repeated(self);
    (void)jlt_grid_place(where, self->rows.axes, self->rows.count, point);
    fprintf(stderr, "jellett: at %s:\n%s", where, words);
    free(self->told);
    self->told = strdup(words);
}

static jlt_exit compute(sweep *self, size_t point)
{
    jlt_exit status;
    int by;
    const jlt_exit code = jlt_worker_run(&self->worker, &status, &by, point);

    if (code != JLT_EXIT_DONE || *self->worker.interrupt != 0) return code;
    tell(self, point, self->worker.words);
    if (by != 0) {
        if (by == JLT_WORKER_WITHOUT_MEANS) fprintf(stderr, "jellett: the command lacked memory or threads there\n");
        else fprintf(stderr, "jellett: the command was ended there by signal %d\n", by);
        self->worst = JLT_EXIT_NUMERICAL;
        return JLT_EXIT_DONE;
    }
    if (status == JLT_EXIT_USAGE || status == JLT_EXIT_IO) return status;
    if (status == JLT_EXIT_INPUT) self->refused++;
    else if (status > self->worst) self->worst = status;
    return jlt_swept_rows_take(&self->rows, point, self->worker.rows);
}

/* ---- all points ---- */

static jlt_exit open_sweep(sweep *self)
{
    const jlt_common *common = self->common;

    JLT_PASS(jlt_common_model(common, &self->model));
    self->rows.model = self->model;
    JLT_PASS(jlt_grid_parse(self->rows.axes, &self->rows.count, JLT_SWEPT_AXES_MAX, common->sweep, "--sweep"));
    JLT_PASS(jlt_grid_size(&self->all, self->rows.axes, self->rows.count, common->sweep, "--sweep"));
    for (size_t k = 0; k < self->rows.count; k++) {
        if (self->form->has_levels || jlt_descriptor_param(self->model, self->rows.axes[k].name, &(size_t){ 0 })) continue;
        fprintf(stderr, "jellett: --sweep: %s has no parameter '%s'; there are", self->model->model, self->rows.axes[k].name);
        for (unsigned i = 0; i < self->model->param_count; i++)
            fprintf(stderr, "%s %s", i > 0 ? "," : "", self->model->params[i].name);
        fputs(self->model->param_count == 0 ? " none\n" : "\n", stderr);
        return JLT_EXIT_INPUT;
    }
    return JLT_EXIT_DONE;
}

/* Print the plan of the first point, in this process. */
static jlt_exit plan(const sweep *self)
{
    char where[JLT_GRID_PLACE_MAX];
    int argc = 0;
    char **argv = arguments(self, 0, &argc);

    if (argv == NULL) return jlt_command_no_memory();
    (void)jlt_grid_place(where, self->rows.axes, self->rows.count, 0);
    printf("at %s, the first of %zu points:\n", where, self->all);
    const jlt_exit code = jlt_program_call(self->form->command, argc, argv);
    jlt_command_free(argv, argc);
    return code;
}

static jlt_exit compute_all(sweep *self)
{
    const jlt_work work = { self->form->command, arguments, self, next_point };
    jlt_progress progress;
    jlt_exit code = jlt_worker_open(&self->worker, &work);
    const volatile sig_atomic_t *const interrupt = self->worker.interrupt;

    jlt_progress_start(&progress, "points");
    for (size_t i = 0; code == JLT_EXIT_DONE && *interrupt == 0 && i < self->all; i++) {
        code = compute(self, i);
        jlt_progress_show(&progress, i + 1, self->all);
    }
    jlt_progress_end(&progress);
    tell_repeated(self);
    jlt_worker_close(&self->worker);
    if (code == JLT_EXIT_DONE) code = jlt_swept_rows_finish(&self->rows);
    if (code == JLT_EXIT_DONE && self->rows.names == NULL && *interrupt == 0)
        code = self->worst != JLT_EXIT_DONE ? self->worst : JLT_EXIT_INPUT;
    if (code == JLT_EXIT_DONE && self->rows.names == NULL) fputs("jellett: interrupted; nothing is saved\n", stderr);
    if (code != JLT_EXIT_DONE || self->rows.names == NULL) return code;
    if (self->refused > 0)
        fprintf(stderr, "jellett: %zu of %zu points refused what was asked, and have no rows\n", self->refused, self->all);
    code = jlt_common_save(self->common);
    if (code == JLT_EXIT_DONE && *interrupt != 0)
        fprintf(stderr, "jellett: interrupted; whole points are saved in %s\n", self->common->table.path);
    else if (code == JLT_EXIT_DONE && self->common->plot != NULL) code = jlt_swept_rows_draw(&self->rows);
    return code == JLT_EXIT_DONE ? self->worst : code;
}

bool jlt_swept_done(jlt_exit *code, const jlt_swept_form *form, jlt_common *common)
{
    sweep self = { .form = form, .common = common, .rows = { .common = common, .what = form->command->name, .lead = form->lead } };

    if (common->sweep == NULL || common->at_point) return false;
    *code = open_sweep(&self);
    if (*code == JLT_EXIT_DONE && common->plan) *code = plan(&self);
    else if (*code == JLT_EXIT_DONE) {
        *code = jlt_common_write(common);
        if (*code == JLT_EXIT_DONE) *code = compute_all(&self);
    }
    jlt_swept_rows_clear(&self.rows);
    free(self.told);
    return true;
}
