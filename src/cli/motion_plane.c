#include "cli/motion.h"

#include <stdlib.h>
#include <string.h>

#include "core/digits.h"
#include "kernel/descriptor.h"

/* What --section and its options say, in the order of the table's states. */
typedef struct {
    jlt_grid_axis section;
    size_t column;
    int signs[JLT_CHART_STATES_MAX];
    double periods[JLT_CHART_STATES_MAX];
    jlt_level levels[JLT_INVARIANTS_MAX];
    unsigned level_count;
} plane;

static jlt_exit read_section(plane *out, const jlt_motion_options *options, const jlt_descriptor *d)
{
    const char *text = options->section;
    jlt_exit code;

    if (text == NULL) return jlt_command_fail(JLT_EXIT_USAGE, "say which section of %s: --section STATE=VALUE", d->model);
    if (strchr(text, '=') == NULL || strchr(text, ':') != NULL)
        return jlt_command_fail(JLT_EXIT_USAGE, "--section: '%s' is no section (write STATE=VALUE)", text);
    code = jlt_grid_axis_parse(&out->section, text, strlen(text), "--section");
    if (code == JLT_EXIT_DONE && !jlt_descriptor_state(d, out->section.name, &out->column))
        code = jlt_command_fail(JLT_EXIT_INPUT, "--section: %s has no state '%s'", d->model, out->section.name);
    return code;
}

static jlt_exit read_mirror(plane *out, const char *text, const jlt_descriptor *d)
{
    size_t index;

    for (unsigned i = 0; i < d->state_count; i++) out->signs[i] = 1;
    while (text != NULL && *text != '\0') {
        const size_t length = strcspn(text, ",");
        char name[64];
        snprintf(name, sizeof name, "%.*s", (int)length, text);
        if (!jlt_descriptor_state(d, name, &index))
            return jlt_command_fail(JLT_EXIT_INPUT, "--mirror: %s has no state '%s'", d->model, name);
        out->signs[index] = -1;
        text += length;
        if (*text == ',') text++;
    }
    return JLT_EXIT_DONE;
}

/* STATE=NUMBER,...: states and numbers, *count of them. */
static jlt_exit read_states(size_t *states, double *numbers, size_t *count, const char *text, const jlt_descriptor *d,
                            const char *option)
{
    jlt_grid_axis axes[JLT_CHART_STATES_MAX];
    jlt_exit code;

    *count = 0;
    if (text == NULL) return JLT_EXIT_DONE;
    if (strchr(text, '=') == NULL || strchr(text, ':') != NULL)
        return jlt_command_fail(JLT_EXIT_USAGE, "%s: '%s' is no list (write STATE=NUMBER,...)", option, text);
    code = jlt_grid_parse(axes, count, JLT_CHART_STATES_MAX, text, option);
    for (size_t i = 0; code == JLT_EXIT_DONE && i < *count; i++) {
        numbers[i] = axes[i].low;
        if (!jlt_descriptor_state(d, axes[i].name, &states[i]))
            code = jlt_command_fail(JLT_EXIT_INPUT, "%s: %s has no state '%s'", option, d->model, axes[i].name);
    }
    return code;
}

static bool is_solved_for(const plane *p, size_t state)
{
    for (unsigned i = 0; i < p->level_count; i++)
        if (p->levels[i].state == state) return true;
    return false;
}

/* Periods that the table proves, but of a state that levels determine, which may have many values there; then what is said. */
static jlt_exit read_modulo(plane *out, const char *text, const jlt_descriptor *d)
{
    size_t states[JLT_CHART_STATES_MAX], count;
    double numbers[JLT_CHART_STATES_MAX];
    const jlt_exit code = read_states(states, numbers, &count, text, d, "--modulo");

    for (unsigned i = 0; i < d->state_count; i++) {
        const jlt_claim *claim = jlt_descriptor_claim(d, "periodic", d->states[i].name);
        out->periods[i] = claim != NULL && claim->verdict == JLT_PROVED && !is_solved_for(out, i) ? d->states[i].period : 0;
    }
    for (size_t i = 0; code == JLT_EXIT_DONE && i < count; i++) {
        const char *name = d->states[states[i]].name;
        out->periods[states[i]] = numbers[i];
        if (!(numbers[i] >= 0))
            return jlt_command_fail(JLT_EXIT_INPUT, "--modulo: the period of %s must be positive, or 0 for none", name);
        if (numbers[i] > 0 && is_solved_for(out, states[i]))
            return jlt_command_fail(JLT_EXIT_INPUT, "--solve: %s is an angle by --modulo, of which levels know many: solve for another "
                                    "state", name);
    }
    return code;
}

static bool has_angles(const plane *p, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        if (p->periods[i] != 0) return true;
    return false;
}

/* The table's integral of this name, proved. */
static jlt_exit find_integral(unsigned *index, const char *name, const jlt_descriptor *d)
{
    const jlt_claim *claim = jlt_descriptor_claim(d, "integral", name);

    for (*index = 0; *index < d->integral_count; ++*index)
        if (strcmp(d->integrals[*index].name, name) == 0) break;
    if (claim == NULL) {
        fprintf(stderr, "jellett: --level: %s claims no integral '%s'%s", d->model, name, d->integral_count > 0 ? "; it has" : "");
        for (unsigned i = 0; i < d->integral_count; i++) fprintf(stderr, "%s %s", i == 0 ? "" : ",", d->integrals[i].name);
        fputc('\n', stderr);
        return JLT_EXIT_INPUT;
    }
    if (claim->verdict != JLT_PROVED)
        return jlt_command_fail(JLT_EXIT_INPUT, "--level: %s is %s integral of this table: %s", name,
                                claim->verdict == JLT_REFUTED ? "no" : "not proved to be an", claim->reason);
    if (*index == d->integral_count)
        return jlt_command_fail(JLT_EXIT_INPUT, "--level: %s is an integral of %s when %s alone: --set that, with a variant of it in the table",
                                name, d->model, claim->condition);
    return JLT_EXIT_DONE;
}

static jlt_exit read_levels(plane *out, const jlt_motion_options *options, const jlt_descriptor *d)
{
    const jlt_assign_list *list = &options->level;
    size_t states[JLT_CHART_STATES_MAX], count;
    double guesses[JLT_CHART_STATES_MAX];
    jlt_exit code = JLT_EXIT_DONE;

    out->level_count = (unsigned)list->count;
    for (size_t i = 0; code == JLT_EXIT_DONE && i < list->count; i++) {
        if (i == JLT_INVARIANTS_MAX)
            return jlt_command_fail(JLT_EXIT_INPUT, "--level: at most %d levels at once", JLT_INVARIANTS_MAX);
        code = find_integral(&out->levels[i].integral, list->items[i].name, d);
        out->levels[i].value = list->items[i].value;
    }
    if (code == JLT_EXIT_DONE) code = read_states(states, guesses, &count, options->solve, d, "--solve");
    if (code != JLT_EXIT_DONE) return code;
    if (count != list->count)
        return jlt_command_fail(JLT_EXIT_USAGE, "levels determine as many states: --level names %zu, and --solve %zu (write --solve "
                                "STATE=GUESS,...)", list->count, count);
    for (size_t i = 0; i < count; i++) {
        out->levels[i].state = (unsigned)states[i];
        out->levels[i].guess = guesses[i];
        if (states[i] == out->column)
            return jlt_command_fail(JLT_EXIT_INPUT, "--solve: %s is fixed by --section already", d->states[states[i]].name);
    }
    if (d->state_count < 2)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s has one state; a section has a coordinate beside the state that --section fixes",
                                d->model);
    if (count + 1 >= d->state_count)
        return jlt_command_fail(JLT_EXIT_INPUT, "--level: %s has %u states, and the section would have no coordinate left", d->model,
                                d->state_count);
    return JLT_EXIT_DONE;
}

jlt_exit jlt_motion_plane(jlt_system **system, const jlt_motion_options *options, const jlt_descriptor *descriptor)
{
    double *params = NULL;
    plane read;
    unsigned state;
    jlt_status st = JLT_OK;
    jlt_exit code = jlt_assign_params(&params, descriptor, &options->common.set);

    if (code != JLT_EXIT_DONE) return code;
    /* Integrals that hold for these parameters alone belong to a variant, which has the same states. */
    if (options->level.count > 0) descriptor = jlt_descriptor_choose(descriptor, NULL, NULL, params);
    if (strcmp(options->contact, "ignore") != 0 && descriptor->family[0]->valid_count == 0)
        code = jlt_command_fail(JLT_EXIT_USAGE, "--contact %s: %s has no condition to lose; its table says none by 'valid'",
                                options->contact, descriptor->model);
    if (code == JLT_EXIT_DONE) code = read_section(&read, options, descriptor);
    if (code == JLT_EXIT_DONE && descriptor->state_count > JLT_CHART_STATES_MAX)
        code = jlt_command_fail(JLT_EXIT_INPUT, "%s has %u states; sections serve up to %d", descriptor->model,
                                descriptor->state_count, JLT_CHART_STATES_MAX);
    if (code == JLT_EXIT_DONE) code = read_mirror(&read, options->mirror, descriptor);
    if (code == JLT_EXIT_DONE) code = read_levels(&read, options, descriptor);
    if (code == JLT_EXIT_DONE) code = read_modulo(&read, options->modulo, descriptor);
    if (code != JLT_EXIT_DONE) goto done;
    st = jlt_system_plane(system, descriptor, params, (unsigned)read.column, read.section.low,
                          options->mirror != NULL ? read.signs : NULL, &options->flow);
    if (st == JLT_OK && has_angles(&read, descriptor->state_count)) st = jlt_system_angles(*system, read.periods, &state);
    if (st == JLT_ERR_DOMAIN && *system != NULL)
        code = jlt_command_fail(JLT_EXIT_INPUT, "--modulo: %s is no angle: the field of %s changes when it grows by %.17g",
                                descriptor->states[state].name, descriptor->model, read.periods[state]);
    else if (st == JLT_OK && read.level_count > 0) st = jlt_system_levels(*system, read.levels, read.level_count);
    if (code == JLT_EXIT_DONE && st != JLT_OK) code = jlt_motion_fail(st, NULL, descriptor->model);
done:
    free(params);
    return code;
}

jlt_exit jlt_motion_project(jlt_system *system)
{
    const jlt_descriptor *d = system->instance->descriptor;

    if (d->integral_count == 0)
        return jlt_command_fail(JLT_EXIT_USAGE, "--project: %s has no integrals to go back to", d->model);
    if (d->integral_count > JLT_INVARIANTS_MAX)
        return jlt_command_fail(JLT_EXIT_USAGE, "--project: %s has %u integrals; it serves up to %d", d->model, d->integral_count,
                                JLT_INVARIANTS_MAX);
    for (unsigned i = 0; i < d->integral_count; i++)
        if (jlt_descriptor_claim(d, "integral", d->integrals[i].name)->verdict != JLT_PROVED)
            return jlt_command_fail(JLT_EXIT_INPUT, "--project: %s is not proved to be an integral of this table", d->integrals[i].name);
    if (system->flow.method->multistep)
        return jlt_command_fail(JLT_EXIT_USAGE, "--project: %s lives on past steps: take a one-step method", system->flow.method->name);
    system->flow.kept = (jlt_invariants){ d->integral_count, d->integral_values.call, d->integral_gradients.call, system->field.p };
    return JLT_EXIT_DONE;
}

void jlt_motion_plane_solved(FILE *stream, const jlt_system *system)
{
    char text[JLT_DIGITS_SIZE];

    fputs("; solved for", stream);
    for (unsigned i = 0; i < system->flow.chart->solved_count; i++) {
        const jlt_level *level = &system->chart.level.levels[i];
        jlt_digits_shortest(text, level->guess);
        fprintf(stream, "%s %s from %s", i == 0 ? "" : ",", system->instance->descriptor->states[level->state].name, text);
    }
}
