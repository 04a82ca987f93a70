#include "cli/common.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#if defined(_OPENMP)
#include <omp.h>
#endif

#include "base/options.h"
#include "cli/grid.h"
#include "cli/merged.h"
#include "cli/plot.h"
#include "cli/table.h"
#include "core/memory.h"
#include "integrate/invariant.h"
#include "kernel/descriptor.h"
#include "report/picture.h"
#include "top/top.h"

enum { METHOD = 1000, KEEP, PLAN, AT };

static const struct argp_option common_table[] = {
    { NULL, 0, NULL, 0, "The system:", 10 },
    { "set", 's', "PARAM=VALUE,...", TTC_OPTIONS_REPEATED,
      "Values of parameters (1/3, 0.51, 1e-3). The others have the table's defaults, which `jellett models MODEL` shows; "
      "those of the spherical top are (5.1) of the paper", 10 },
    { "@plan", PLAN, NULL, OPTION_HIDDEN, NULL, 12 },
    { "@set", AT, "PARAM=VALUE,...", OPTION_HIDDEN, NULL, 12 },
    { 0 },
};

static const struct argp_option files_table[] = {
    { NULL, 0, NULL, 0, "Output:", 12 },
    { "output", 'o', "FILE", 0,
      "Write the results to FILE; a table to FILE.npy becomes an array of NumPy. Default: standard output", 12 },
    { "plot", 'p', "FILE", 0, "Draw a picture: FILE.svg, FILE.png or FILE.pdf", 12 },
    { "keep", KEEP, "FILE", 0, "Keep the picture's gnuplot script, with all its data: gnuplot FILE draws the picture again", 12 },
    { 0 },
};

static const struct argp_option certificate_table[] = {
    { NULL, 0, NULL, 0, "Output:", 12 },
    { "output", 'o', "FILE", 0, "Where the results go; default standard output", 12 },
    { 0 },
};

static const struct argp_option accuracy_table[] = {
    { NULL, 0, NULL, 0, "The computation:", 11 },
    { "tol", 't', "VALUE", 0,
      "Tolerance of a step, in units of the problem, 1e-16 to 0.1; default 1e-12, and 1e-13 for continue, "
      "manifolds, orbits and certify. With every method the error of ten returns is then about as large; a pulse "
      "far narrower than a step may be missed", 11 },
    { "method", METHOD, "METHOD", 0,
      "Method of integration: gauss (default), dop853, taylor (derivatives by gauss), rk8pd, rkf45, msadams", 11 },
    { 0 },
};

static error_t parse_common(int key, char *value, struct argp_state *state)
{
    jlt_common *self = state->input;

    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = self;
        state->child_inputs[1] = &self->look;
        return 0;
    case 's': jlt_common_list(&self->set, value, "--set"); return 0;
    case PLAN: self->plan = true; return 0;
    case AT:
        self->at_point = true;
        jlt_common_replace(&self->set, value);
        return 0;
    case ARGP_KEY_ARG:
        if (self->model != NULL) argp_error(state, "one model at most: '%s' is too many", value);
        self->model = value;
        return 0;
    case ARGP_KEY_END:
        if (self->at_point) self->output = self->plot = self->keep = self->axes = NULL;
        if (self->at_point) jlt_look_default(&self->look);
        if (self->keep != NULL && self->plot == NULL)
            argp_error(state, "--keep keeps the script of a picture: add --plot FILE");
        jlt_common_not_swept(self, &self->set, "--set");
        if (self->look.asked && self->plot == NULL) argp_error(state, "options of a picture, and no picture: add --plot FILE");
        if (!self->plan) jlt_common_check_files(self, NULL, NULL);
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static error_t parse_files(int key, char *value, struct argp_state *state)
{
    jlt_common *self = state->input;

    switch (key) {
    case 'o':
        if (jlt_merged_is_database(value))
            argp_error(state, "--output: '%s' would be a database, which 'jellett merge' alone writes: name a .csv or .npy", value);
        if (jlt_picture_is_named(value))
            argp_error(state, "--output: '%s' would be text under a picture's name; --plot draws one: name a .csv or .npy", value);
        self->output = value;
        return 0;
    case 'p':
        if (!jlt_picture_known(value)) argp_error(state, "--plot: '%s' is no .svg, .png or .pdf", value);
        self->plot = value;
        return 0;
    case KEEP:
        if (jlt_picture_is_named(value)) argp_error(state, "--keep: '%s' would be a script under a picture's name", value);
        self->keep = value;
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static void no_method(const struct argp_state *state, const char *name)
{
    char known[256] = "";
    size_t used = 0;

    for (size_t i = 0; jlt_method_at(i) != NULL && used < sizeof known; i++)
        used += (size_t)snprintf(known + used, sizeof known - used, "%s %s", i == 0 ? "" : ",", jlt_method_at(i)->name);
    argp_error(state, "--method: there is no method '%s'; there are%s", name, known);
}

static error_t parse_accuracy(int key, char *value, struct argp_state *state)
{
    const jlt_accuracy *self = state->input;

    switch (key) {
    case 't':
        jlt_common_number(self->tolerance, value, "--tol");
        if (!(*self->tolerance >= 1e-16 && *self->tolerance <= 0.1))
            exit((int)jlt_command_fail(JLT_EXIT_INPUT, "--tol %s: a tolerance lies between 1e-16 and 0.1", value));
        return 0;
    case METHOD:
        *self->method = jlt_method_find(value);
        if (*self->method == NULL) no_method(state, value);
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp of_files = { files_table, parse_files, NULL, NULL, NULL, NULL, NULL };
static const struct argp of_certificate = { certificate_table, parse_files, NULL, NULL, NULL, NULL, NULL };
static const struct argp no_picture = { NULL, NULL, NULL, NULL, NULL, NULL, NULL };
static const struct argp_child children[] = { { &of_files, 0, NULL, 0 }, { &jlt_plot_argp, 0, NULL, 0 }, { 0 } };
static const struct argp_child without_picture[] = { { &of_certificate, 0, NULL, 0 }, { &no_picture, 0, NULL, 0 }, { 0 } };

const struct argp jlt_common_argp = { common_table, parse_common, NULL, NULL, children, NULL, NULL };
const struct argp jlt_common_certificate_argp = { common_table, parse_common, NULL, NULL, without_picture, NULL, NULL };
const struct argp jlt_accuracy_argp = { accuracy_table, parse_accuracy, NULL, NULL, NULL, NULL, NULL };

void jlt_common_no_table(const jlt_common *self, const struct argp_state *state, const char *what)
{
    if (jlt_stream_is_array(self->output))
        argp_error(state, "%s is no table: --output %s would be an array, which takes tables alone", what, self->output);
}

void jlt_common_incomplete(const jlt_common *self, const struct argp_state *state, const char *words)
{
    const jlt_descriptor *model;
    const jlt_exit code = jlt_common_model(self, &model);

    if (code != JLT_EXIT_DONE) exit((int)code);
    argp_error(state, "%s", words);
}

error_t jlt_common_inputs(struct argp_state *state, const struct argp_child *its)
{
    for (unsigned i = 0; its[i].argp != NULL; i++) state->child_inputs[i] = state->input;
    return 0;
}

void jlt_common_begin(jlt_common *self, int argc, char **argv)
{
    *self = (jlt_common){ .command = jlt_command_line(argc, argv), .argc = argc };
    self->argv = malloc(((size_t)argc + 1) * sizeof *argv);
    if (self->argv == NULL) self->argc = 0;
    else memcpy(self->argv, argv, (size_t)argc * sizeof *argv);
    jlt_look_default(&self->look);
}

void jlt_common_end(jlt_common *self)
{
    jlt_assign_clear(&self->set);
    jlt_stream_discard(&self->table);
    if (self->points != NULL) fclose(self->points);
    free(self->drawn);
    free(self->command);
    free(self->argv);
    self->command = self->drawn = NULL;
    self->points = NULL;
}

jlt_exit jlt_common_write(jlt_common *self)
{
    const jlt_exit code = jlt_stream_open(&self->table, self->output);

    if (code != JLT_EXIT_DONE || self->plot == NULL) return code;
    self->points = open_memstream(&self->drawn, &self->drawn_size);
    return self->points != NULL ? JLT_EXIT_DONE : jlt_command_no_memory();
}

jlt_exit jlt_common_save(jlt_common *self)
{
    if (self->points != NULL) fclose(self->points);
    self->points = NULL;
    return jlt_stream_close(&self->table);
}

jlt_exit jlt_common_model(const jlt_common *self, const jlt_descriptor **descriptor)
{
    bool has_said;
    const jlt_exit code = jlt_table_open(descriptor, &has_said, self->model != NULL ? self->model : JLT_DEFAULT_MODEL, self->lanes);

    if (code == JLT_EXIT_DONE && !has_said && !self->at_point) jlt_command_warn_unproved(*descriptor);
    return code;
}

jlt_exit jlt_common_open(const jlt_common *self, const jlt_descriptor **descriptor, double **params)
{
    const jlt_exit code = jlt_common_model(self, descriptor);

    return code == JLT_EXIT_DONE ? jlt_assign_params(params, *descriptor, &self->set, self->own_sweep) : code;
}

const char **jlt_common_exact(const jlt_common *self, const jlt_descriptor *descriptor, char *const *defaults)
{
    const char **exact = calloc(descriptor->param_count + 1, sizeof *exact);

    for (size_t i = 0; exact != NULL && i < descriptor->param_count; i++) {
        exact[i] = jlt_assign_fraction(&self->set, descriptor->params[i].name);
        if (exact[i] == NULL) exact[i] = defaults[i];
    }
    return exact;
}

bool jlt_common_runs(const jlt_common *self, const char *name)
{
    return self->at_point && jlt_assign_names(self->sweep, name);
}

double *jlt_common_steady(const jlt_common *self, const jlt_descriptor *descriptor, const double *params)
{
    double *steady = malloc((descriptor->param_count + 1) * sizeof *steady);

    for (unsigned k = 0; steady != NULL && k < descriptor->param_count; k++)
        steady[k] = jlt_common_runs(self, descriptor->params[k].name) ? NAN : params[k];
    return steady;
}

jlt_exit jlt_common_proved(const jlt_descriptor *d)
{
    const jlt_claim *doubted = jlt_descriptor_doubted_integral(d);

    if (doubted == NULL) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_INPUT, "--project: %s is not proved to be an integral of this table", doubted->name);
}

jlt_exit jlt_common_one_step(const jlt_method *method)
{
    if (method == NULL || !method->multistep) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_USAGE, "--project cannot be used with the multistep method %s: take gauss or dop853",
                            method->name);
}

jlt_exit jlt_common_no_kernels(const jlt_descriptor *d, const jlt_method *method)
{
    return jlt_command_fail(JLT_EXIT_INPUT, "%s has no kernels for --method %s: take another, such as gauss", d->model,
                            method != NULL ? method->name : jlt_method_find(NULL)->name);
}

jlt_exit jlt_common_project(const jlt_descriptor *d)
{
    if (d->integral_count == 0)
        return jlt_command_fail(JLT_EXIT_USAGE,
                                "--project: %s has no integrals to go back to: write 'integral NAME = ...' in its table", d->model);
    if (d->integral_count > JLT_INVARIANTS_MAX)
        return jlt_command_fail(JLT_EXIT_USAGE, "--project: %s has %u integrals; it serves up to %d", d->model, d->integral_count,
                                JLT_INVARIANTS_MAX);
    return jlt_common_proved(d);
}

jlt_exit jlt_common_still(void)
{
    puts("  nothing moves: no tier is needed");
    return JLT_EXIT_PLANNED;
}

/* The table of the model leads to others, which are read without being named. */
static jlt_exit check_place(const jlt_command_file *file)
{
    JLT_FREED char *real = file->path == NULL ? NULL : realpath(file->path, NULL); /* where a link leads */

    if (file->path != NULL && (jlt_table_is_named(file->path) || (real != NULL && jlt_table_is_named(real))))
        return jlt_command_fail(JLT_EXIT_USAGE, "%s: '%s' is a table's name, and tables are written by hand: name another file",
                                file->option, file->path);
    return jlt_command_check_output(file->path);
}

void jlt_common_check_files(const jlt_common *self, const char *option, const char *path)
{
    const char *table = self->model != NULL && jlt_table_is_file(self->model) ? self->model : NULL;
    const jlt_command_file optional[] = {
        { "--plot", self->plot }, { "--keep", self->keep }, { option, path }, { "MODEL", table }
    };
    jlt_command_file files[5] = { { "--output", self->output } };
    size_t count = 1;
    jlt_exit code;

    for (size_t i = 0; i < 4; i++)
        if (optional[i].path != NULL) files[count++] = optional[i];
    code = jlt_command_distinct(files, count);
    for (size_t i = 0; code == JLT_EXIT_DONE && i < count; i++)
        if (files[i].path != table) code = check_place(&files[i]);
    if (code != JLT_EXIT_DONE) exit((int)code);
}

void jlt_common_replace(jlt_assign_list *list, const char *text)
{
    const jlt_exit code = jlt_assign_replace(list, text, "--sweep");

    if (code != JLT_EXIT_DONE) exit((int)code);
}

void jlt_common_list(jlt_assign_list *list, const char *text, const char *option)
{
    const jlt_exit code = jlt_assign_parse(list, text, option);

    if (code != JLT_EXIT_DONE) exit((int)code);
}

void jlt_common_not_swept(const jlt_common *self, const jlt_assign_list *list, const char *option)
{
    for (size_t i = 0; !self->at_point && i < list->count; i++)
        if (jlt_assign_names(self->sweep, list->items[i].name) || jlt_assign_names(self->own_sweep, list->items[i].name))
            exit((int)jlt_command_fail(JLT_EXIT_USAGE, "%s: --sweep gives %s its values: leave it out of one of them", option,
                                       list->items[i].name));
}

size_t jlt_common_processors(void)
{
#if defined(_OPENMP)
    const long count = omp_get_max_threads();
#else
    const long count = sysconf(_SC_NPROCESSORS_ONLN);
#endif
    return count > 1024 ? 1024 : count > 1 ? (size_t)count : 1;
}

void jlt_common_count(size_t *value, const char *text, size_t low, size_t high, const char *option)
{
    const jlt_exit code = jlt_grid_count(value, text, low, high, option);

    if (code != JLT_EXIT_DONE) exit((int)code);
}

void jlt_common_number(double *value, const char *text, const char *option)
{
    const jlt_exit code = jlt_grid_number(value, text, strlen(text), option);

    if (code != JLT_EXIT_DONE) exit((int)code);
}

void jlt_common_positive(double *value, const char *text, const char *option)
{
    jlt_common_number(value, text, option);
    if (!(*value > 0)) exit((int)jlt_command_fail(JLT_EXIT_INPUT, "%s: '%s' is not positive", option, text));
}
