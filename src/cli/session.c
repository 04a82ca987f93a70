#include "cli/session.h"

#include "base/options.h"
#include "cli/interrupt.h"
#include "cli/table.h"
#include "core/memory.h"
#include "kernel/descriptor.h"

static const struct argp_option option_table[] = {
    { "start", 'a', "STATE=VALUE,...", TTC_OPTIONS_REPEATED, "The start: a value for every state of the model", 10 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    jlt_session *self = state->input;

    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &self->common;
        state->child_inputs[1] = &self->accuracy;
        return 0;
    case 'a': jlt_common_list(&self->start, value, "--start"); return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = { { &jlt_common_argp, 0, NULL, 0 }, { &jlt_accuracy_argp, 0, NULL, 0 }, { 0 } };

const struct argp jlt_session_argp = { option_table, parse, NULL, NULL, children, NULL, NULL };

void jlt_session_begin(jlt_session *self, int argc, char **argv)
{
    *self = (jlt_session){ .tolerance = 1e-12, .method = jlt_method_find(NULL) };
    self->accuracy = (jlt_accuracy){ &self->tolerance, &self->method };
    self->interrupt = jlt_interrupt_install();
    jlt_common_begin(&self->common, argc, argv);
}

void jlt_session_end(void *place)
{
    jlt_session *self = place;

    jlt_common_end(&self->common);
    jlt_assign_clear(&self->start);
    free(self->params);
    free(self->x);
    self->params = self->x = NULL;
}

bool jlt_session_interrupted(const jlt_session *self)
{
    return *self->interrupt != 0;
}

/* Set the tables that may serve in place of the model. kind: as for jlt_table_others. */
static jlt_exit look_at_others(jlt_session *self, const char *kind)
{
    if (self->common.model == NULL) return JLT_EXIT_DONE;
    return jlt_table_others(&self->others, self->descriptor, self->common.model, kind, false);
}

jlt_exit jlt_session_open(jlt_session *self)
{
    const jlt_exit code = jlt_common_open(&self->common, &self->descriptor, &self->params);

    return code == JLT_EXIT_DONE ? look_at_others(self, "reduction") : code;
}

jlt_exit jlt_session_look_at_larger(jlt_session *self)
{
    return look_at_others(self, NULL);
}

jlt_exit jlt_session_start(jlt_session *self)
{
    const jlt_descriptor *d = self->descriptor;
    JLT_FREED unsigned char *given = calloc(d->state_count, 1);
    const jlt_region *region;
    double value;
    size_t index = 0;

    self->x = calloc(d->state_count, sizeof *self->x);
    if (given == NULL || self->x == NULL) return jlt_session_fail(JLT_ERR_NOMEM, "the start");
    JLT_PASS(jlt_assign_apply(self->x, given, &self->start, d->states, d->state_count, "state", d->model));
    for (unsigned i = 0; i < d->state_count; i++)
        if (!given[i])
            return jlt_command_fail(JLT_EXIT_INPUT, "--start: give %s as well (every state of %s has to be named)",
                                    d->states[i].name, d->model);
    if (jlt_descriptor_check_state(d, self->x, &index) != JLT_OK)
        return jlt_assign_refuse_interval("--start", &d->states[index]);
    if (jlt_region_check(&region, &value, d, self->params, self->x) != JLT_OK)
        return region == NULL ? jlt_command_no_memory() : jlt_assign_refuse_region("--start", d, region, value);
    return JLT_EXIT_DONE;
}

void jlt_session_caption(jlt_plot *plot, const jlt_session *self)
{
    for (unsigned i = 0; i < self->descriptor->param_count; i++)
        jlt_plot_value(plot, self->descriptor->params[i].name, self->params[i]);
}

jlt_exit jlt_session_fail(jlt_status status, const char *what)
{
    return jlt_command_fail(jlt_command_exit(status), "%s: %s", what, jlt_status_text(status));
}
