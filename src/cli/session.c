#include "cli/session.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/grid.h"
#include "cli/interrupt.h"
#include "kernel/descriptor.h"
#include "report/picture.h"

enum { METHOD = 1000, KEEP };

static const struct argp_option option_table[] = {
    { NULL, 0, NULL, 0, "The system:", 10 },
    { "set", 's', "NAME=VALUE,...", 0, "Parameters; the table's defaults hold for the others", 10 },
    { "start", 'a', "NAME=VALUE,...", 0, "The start: a value for every state of the model", 10 },
    { NULL, 0, NULL, 0, "The computation:", 11 },
    { "tol", 't', "VALUE", 0, "Tolerance of the local error; default 1e-12", 11 },
    { "method", METHOD, "NAME", 0, "gauss (default), dop853, taylor, rk8pd, rkf45, msadams", 11 },
    { NULL, 0, NULL, 0, "Output:", 12 },
    { "output", 'o', "FILE", 0, "Write rows there; default standard output", 12 },
    { "plot", 'p', "FILE", 0, "Draw .svg, .png or .pdf", 12 },
    { "keep", KEEP, "FILE", 0, "Keep the gnuplot script, data included", 12 },
    { 0 },
};

static void parse_list(jlt_assign_list *list, const char *value, const char *option)
{
    const jlt_exit code = jlt_assign_parse(list, value, option);

    if (code != JLT_EXIT_DONE) exit((int)code);
}

static void parse_tolerance(jlt_session *self, const char *value)
{
    jlt_exit code = jlt_grid_number(&self->tolerance, value, strlen(value), "--tol");

    if (code == JLT_EXIT_DONE && !(self->tolerance >= 1e-16 && self->tolerance <= 0.1))
        code = jlt_command_fail(JLT_EXIT_INPUT, "--tol %s: a tolerance lies between 1e-16 and 0.1", value);
    if (code != JLT_EXIT_DONE) exit((int)code);
}

static error_t parse(int key, char *value, struct argp_state *state)
{
    jlt_session *self = state->input;

    switch (key) {
    case 's': parse_list(&self->set, value, "--set"); return 0;
    case 'a': parse_list(&self->start, value, "--start"); return 0;
    case 't': parse_tolerance(self, value); return 0;
    case METHOD:
        self->method = jlt_method_find(value);
        if (self->method == NULL)
            argp_error(state, "there is no method '%s'; there are gauss, dop853, taylor, rk8pd, rkf45, msadams", value);
        return 0;
    case 'o': self->output = value; return 0;
    case 'p':
        if (!jlt_picture_known(value)) argp_error(state, "--plot: '%s' is no .svg, .png or .pdf", value);
        self->plot = value;
        return 0;
    case KEEP: self->keep = value; return 0;
    case ARGP_KEY_ARG:
        if (self->model != NULL) argp_error(state, "one model at most: '%s' is too many", value);
        self->model = value;
        return 0;
    case ARGP_KEY_END:
        if (self->keep != NULL && self->plot == NULL)
            argp_error(state, "--keep keeps the script of a picture: add --plot FILE");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

const struct argp jlt_session_argp = { option_table, parse, NULL, NULL, NULL, NULL, NULL };

void jlt_session_begin(jlt_session *self, int argc, char **argv)
{
    *self = (jlt_session){ .tolerance = 1e-12, .method = jlt_method_find(NULL) };
    self->interrupt = jlt_interrupt_install();
    self->command = jlt_command_line(argc, argv);
}

void jlt_session_end(jlt_session *self)
{
    jlt_assign_clear(&self->set);
    jlt_assign_clear(&self->start);
    free(self->command);
    free(self->params);
    free(self->x);
    self->command = NULL;
    self->params = self->x = NULL;
}

bool jlt_session_interrupted(const jlt_session *self)
{
    return *self->interrupt != 0;
}

jlt_exit jlt_session_open(jlt_session *self)
{
    return jlt_assign_model(&self->descriptor, &self->params, self->model != NULL ? self->model : "spherical_top",
                            &self->set);
}

jlt_exit jlt_session_start(jlt_session *self)
{
    const jlt_descriptor *d = self->descriptor;
    unsigned char *given = calloc(d->state_count, 1);
    jlt_exit code = JLT_EXIT_DONE;
    size_t index = 0;

    self->x = calloc(d->state_count, sizeof *self->x);
    if (given == NULL || self->x == NULL) {
        code = jlt_session_fail(JLT_ERR_NOMEM, "the start");
        goto done;
    }
    code = jlt_assign_apply(self->x, given, &self->start, d->states, d->state_count, "state", d->model);
    for (unsigned i = 0; code == JLT_EXIT_DONE && i < d->state_count; i++)
        if (!given[i])
            code = jlt_command_fail(JLT_EXIT_INPUT, "--start: give %s as well (every state of %s has to be named)",
                                    d->states[i].name, d->model);
    if (code == JLT_EXIT_DONE && jlt_descriptor_check_state(d, self->x, &index) != JLT_OK)
        code = jlt_command_fail(JLT_EXIT_INPUT, "--start: %s must lie strictly between %g and %g", d->states[index].name,
                                d->states[index].low, d->states[index].high);
done:
    free(given);
    return code;
}

void jlt_session_caption(FILE *stream, const jlt_session *self)
{
    for (unsigned i = 0; i < self->descriptor->param_count; i++)
        fprintf(stream, "%s%s=%.6g", i == 0 ? "" : ", ", self->descriptor->params[i].name, self->params[i]);
}

jlt_exit jlt_session_fail(jlt_status status, const char *what)
{
    return jlt_command_fail(jlt_command_exit(status), "%s: %s", what, jlt_status_text(status));
}

jlt_exit jlt_session_draw(const jlt_session *self, const char *script)
{
    const jlt_status st = jlt_picture_draw(self->plot, script, self->keep);

    if (st == JLT_OK) return JLT_EXIT_DONE;
    if (st == JLT_ERR_UNSUPPORTED)
        return jlt_command_fail(JLT_EXIT_IO, "no gnuplot to be found: install gnuplot to draw pictures");
    return jlt_command_fail(jlt_command_exit(st), "cannot draw '%s': %s", self->plot,
                            st == JLT_ERR_IO ? strerror(errno) : jlt_status_text(st));
}
