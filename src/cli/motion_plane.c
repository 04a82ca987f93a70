#include "cli/motion_plane.h"

#include <math.h>
#include <string.h>

#include "core/memory.h"
#include "kernel/descriptor.h"

static jlt_exit read_section(jlt_motion_plane *out, const jlt_motion_options *options, const jlt_descriptor *d)
{
    const char *text = options->section;
    jlt_exit code;

    if (text == NULL)
        return jlt_command_fail(JLT_EXIT_USAGE,
                                "say which section of %s: --section STATE=VALUE; no proved record 'section' describes one",
                                d->model);
    if (strchr(text, '=') == NULL || strchr(text, ':') != NULL)
        return jlt_command_fail(JLT_EXIT_USAGE, "--section: '%s' is no section (write STATE=VALUE)", text);
    code = jlt_grid_axis_parse(&out->section, text, strlen(text), "--section");
    if (code == JLT_EXIT_DONE && !jlt_descriptor_state(d, out->section.name, &out->column))
        code = jlt_command_fail(JLT_EXIT_INPUT, "--section: %s has no state '%s'", d->model, out->section.name);
    if (code != JLT_EXIT_DONE) return code;
    const jlt_quantity *state = &d->states[out->column];
    if (out->section.low > state->low && out->section.low < state->high) return JLT_EXIT_DONE;
    return jlt_assign_refuse_interval("--section", state);
}

/* The first reversor that the table proves and whose fixed points lie on the section; NULL: none. */
static const signed char *proved_reversor(const jlt_motion_plane *p, const jlt_descriptor *d)
{
    for (unsigned i = 0; i < d->reversor_count; i++) {
        const jlt_reversor *reversor = &d->reversors[i];
        if (reversor->signs[p->column] < 0 && d->claims[reversor->claim].verdict == JLT_PROVED) return reversor->signs;
    }
    return NULL;
}

/* Set the reversor: from --mirror, an empty list for none, or, if that is not given, the one that the table proves. */
static jlt_exit read_mirror(jlt_motion_plane *out, const char *text, const jlt_descriptor *d)
{
    const signed char *proved = text == NULL ? proved_reversor(out, d) : NULL;
    size_t index;

    out->mirrored = proved != NULL || (text != NULL && *text != '\0');
    for (unsigned i = 0; i < d->state_count; i++) out->signs[i] = proved != NULL ? proved[i] : 1;
    while (text != NULL && *text != '\0') {
        const size_t length = strcspn(text, ",");
        char name[64];
        snprintf(name, sizeof name, "%.*s", (int)length, text);
        if (!jlt_descriptor_state(d, name, &index))
            return jlt_command_fail(JLT_EXIT_INPUT, "--mirror: %s has no state '%s'", d->model, name);
        out->signs[index] = -1;
        text += length + (text[length] == ',');
    }
    return JLT_EXIT_DONE;
}

/* Read STATE=NUMBER,... into indices of states and numbers, *count of each. */
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

static bool is_solved_for(const jlt_motion_plane *p, size_t state)
{
    for (unsigned i = 0; i < p->level_count; i++)
        if (p->levels[i].state == state) return true;
    return false;
}

/* Set the periods: those that the table proves, then those of --modulo. States that are solved for get none: levels have many
 * solutions for an angle. */
static jlt_exit read_modulo(jlt_motion_plane *out, const char *text, const jlt_descriptor *d)
{
    size_t states[JLT_CHART_STATES_MAX], count;
    double numbers[JLT_CHART_STATES_MAX];
    const jlt_exit code = read_states(states, numbers, &count, text, d, "--modulo");

    for (unsigned i = 0; i < d->state_count; i++) {
        const bool is_proved = jlt_descriptor_proves(d, "periodic", d->states[i].name);
        out->periods[i] = is_proved && !is_solved_for(out, i) ? d->states[i].period : 0;
    }
    for (size_t i = 0; code == JLT_EXIT_DONE && i < count; i++) {
        const char *name = d->states[states[i]].name;
        out->periods[states[i]] = numbers[i];
        if (!(numbers[i] >= 0))
            return jlt_command_fail(JLT_EXIT_INPUT, "--modulo: the period of %s must be positive, or 0 for none", name);
        if (numbers[i] > 0 && is_solved_for(out, states[i]))
            return jlt_command_fail(JLT_EXIT_INPUT,
                                    "--solve: %s is an angle by --modulo, for which a level has many solutions: solve for "
                                    "another state",
                                    name);
    }
    return code;
}

static bool has_angles(const jlt_motion_plane *p, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        if (p->periods[i] != 0) return true;
    return false;
}

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
    if (*index == d->integral_count && claim->condition[0] == '\0')
        return jlt_command_fail(JLT_EXIT_INPUT,
                                "--level: %s is an integral of %s on zero levels of other claims alone ('modulo'), and sections "
                                "fix levels of integrals that are kept everywhere",
                                name, d->model);
    if (*index == d->integral_count)
        return jlt_command_fail(JLT_EXIT_INPUT,
                                "--level: %s is an integral of %s only when %s: give these values by --set, and write "
                                "'variant NAME : %s' in the table",
                                name, d->model, claim->condition, claim->condition);
    return JLT_EXIT_DONE;
}

jlt_exit jlt_motion_plane_refuse(const jlt_descriptor *d, const char *name, const char *option)
{
    fprintf(stderr, "jellett: %s: there is no '%s'; there are the parameters", option, name);
    for (unsigned i = 0; i < d->param_count; i++) fprintf(stderr, "%s %s", i == 0 ? "" : ",", d->params[i].name);
    fputs(d->param_count == 0 ? " (none)" : "", stderr);
    for (unsigned i = 0; i < d->integral_count; i++)
        fprintf(stderr, "%s %s", i == 0 ? ", and the levels of" : ",", d->integrals[i].name);
    fputc('\n', stderr);
    return JLT_EXIT_INPUT;
}

static jlt_exit add_level(jlt_motion_plane *out, const char *name, double value, bool swept, const jlt_descriptor *d)
{
    if (swept && jlt_descriptor_claim(d, "integral", name) == NULL) return jlt_motion_plane_refuse(d, name, "--sweep");
    if (d->integral_count > JLT_CHART_INTEGRALS_MAX)
        return jlt_command_fail(JLT_EXIT_INPUT, "--level: %s has %u integrals; levels are served of tables with up to %d", d->model,
                                d->integral_count, JLT_CHART_INTEGRALS_MAX);
    if (out->level_count == JLT_INVARIANTS_MAX)
        return jlt_command_fail(JLT_EXIT_INPUT, "--level: at most %d levels at once", JLT_INVARIANTS_MAX);
    JLT_PASS(find_integral(&out->levels[out->level_count].integral, name, d));
    out->levels[out->level_count++].value = value;
    return JLT_EXIT_DONE;
}

/* Take the levels of --level, and those that are swept, and the states to solve for. */
static jlt_exit read_levels(jlt_motion_plane *out, const jlt_motion_options *options, const jlt_descriptor *d)
{
    const jlt_assign_list *list = &options->level;
    size_t states[JLT_CHART_STATES_MAX], count;
    double guesses[JLT_CHART_STATES_MAX];

    for (size_t i = 0; i < list->count; i++)
        JLT_PASS(add_level(out, list->items[i].name, list->items[i].value,
                           jlt_common_runs(&options->common, list->items[i].name), d));
    for (size_t i = 0; i < options->swept_count; i++) {
        const jlt_grid_axis *axis = &options->swept[i];
        if (jlt_descriptor_param(d, axis->name, &(size_t){ 0 }) || jlt_motion_plane_value(out, axis->name) != NULL) continue;
        JLT_PASS(add_level(out, axis->name, axis->low, true, d));
    }
    JLT_PASS(read_states(states, guesses, &count, options->solve, d, "--solve"));
    if (count != out->level_count)
        return jlt_command_fail(JLT_EXIT_USAGE,
                                "each level needs a state to solve for; levels: %u, states that --solve names: %zu (write --solve "
                                "STATE=GUESS,...)",
                                out->level_count, count);
    for (size_t i = 0; i < count; i++) {
        out->levels[i].state = (unsigned)states[i];
        out->levels[i].guess = guesses[i];
        if (states[i] == out->column)
            return jlt_command_fail(JLT_EXIT_INPUT, "--solve: %s is fixed by --section already", d->states[states[i]].name);
    }
    if (d->state_count < 2)
        return jlt_command_fail(JLT_EXIT_INPUT,
                                "%s has one state; a section has a coordinate beside the state that --section fixes", d->model);
    if (count + 1 >= d->state_count)
        return jlt_command_fail(JLT_EXIT_INPUT, "--level: %s has %u states, and the section would have no coordinate left",
                                d->model, d->state_count);
    return JLT_EXIT_DONE;
}

static void note_size(jlt_motion_plane *out, size_t state, double value)
{
    if (state < JLT_CHART_STATES_MAX) out->sizes[state] = fmax(out->sizes[state], fabs(value));
}

/* Note the sizes in a list of NAME=VALUE or NAME=LOW:HIGH:COUNT. Malformed items are skipped: reading the starts reports them. */
static void note_values(jlt_motion_plane *out, const char *text, const jlt_descriptor *d)
{
    char name[64];
    double low, high;
    size_t state;

    while (jlt_grid_ends(&text, name, sizeof name, &low, &high))
        if (jlt_descriptor_state(d, name, &state)) note_size(out, state, fmax(fabs(low), fabs(high))); /* an end may be NaN */
}

/* Note the typical sizes of states from all options that say where orbits begin. */
static void note_sizes(jlt_motion_plane *out, const jlt_motion_options *options)
{
    const jlt_descriptor *d = out->descriptor;

    note_size(out, out->column, out->section.low);
    for (unsigned i = 0; i < out->level_count; i++) note_size(out, out->levels[i].state, out->levels[i].guess);
    for (size_t i = 0; options->starts[i] != NULL; i++) note_values(out, options->starts[i], d);
    if (options->grid != NULL) note_values(out, options->grid, d);
}

/* Choose the most special field that holds for these parameters and for any values of those that run. */
static jlt_exit choose(jlt_motion_plane *out, const jlt_descriptor *d, const jlt_grid_axis *running, size_t count)
{
    JLT_FREED double *params = malloc((d->param_count + 1) * sizeof *params);
    size_t index;

    if (params == NULL) return jlt_command_no_memory();
    memcpy(params, out->params, d->param_count * sizeof *params);
    for (size_t i = 0; i < count; i++)
        if (jlt_descriptor_param(d, running[i].name, &index)) params[index] = NAN;
    out->descriptor = jlt_descriptor_choose(d, NULL, NULL, params);
    return JLT_EXIT_DONE;
}

jlt_exit jlt_motion_plane_read(jlt_motion_plane *out, const jlt_motion_options *options, const jlt_descriptor *descriptor,
                               const jlt_grid_axis *running, size_t count)
{
    out->descriptor = descriptor;
    out->flow = options->flow;
    JLT_PASS(jlt_assign_params(&out->params, descriptor, &options->common.set, options->common.own_sweep));
    /* Take the most special variant: integrals and densities that hold only for these parameters belong to it. */
    JLT_PASS(choose(out, descriptor, running, count));
    JLT_PASS(read_section(out, options, out->descriptor));
    if (descriptor->state_count > JLT_CHART_STATES_MAX)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s has %u states; sections serve up to %d", descriptor->model,
                                descriptor->state_count, JLT_CHART_STATES_MAX);
    JLT_PASS(read_mirror(out, options->mirror, out->descriptor));
    JLT_PASS(read_levels(out, options, out->descriptor));
    JLT_PASS(read_modulo(out, options->modulo, out->descriptor));
    note_sizes(out, options);
    return JLT_EXIT_DONE;
}

void jlt_motion_plane_clear(jlt_motion_plane *plane)
{
    free(plane->params);
    plane->params = NULL;
}

double *jlt_motion_plane_value(jlt_motion_plane *plane, const char *name)
{
    size_t index;

    if (jlt_descriptor_param(plane->descriptor, name, &index)) return &plane->params[index];
    for (unsigned i = 0; i < plane->level_count; i++)
        if (strcmp(plane->descriptor->integrals[plane->levels[i].integral].name, name) == 0) return &plane->levels[i].value;
    return NULL;
}

jlt_status jlt_motion_plane_make(const jlt_motion_plane *plane, jlt_system **system, unsigned *no_angle)
{
    const jlt_descriptor *d = plane->descriptor;
    jlt_status st = JLT_OK;

    *no_angle = d->state_count;
    JLT_TRY(jlt_system_plane(system, jlt_system_regular(d), plane->params, (unsigned)plane->column, plane->section.low,
                             plane->mirrored ? plane->signs : NULL, &plane->flow));
    if (has_angles(plane, d->state_count)) {
        unsigned state = 0;
        st = jlt_system_angles(*system, plane->periods, &state);
        if (st == JLT_ERR_DOMAIN) *no_angle = state;
    }
    if (st == JLT_OK && plane->level_count > 0) st = jlt_system_levels(*system, plane->levels, plane->level_count);
    if (st == JLT_OK) st = jlt_system_count(*system, plane->sizes);
done:
    if (st != JLT_OK) {
        jlt_system_destroy(*system);
        *system = NULL;
    }
    return st;
}

/* Points of the section that are looked at: number 0 is the origin, the others lie ever farther out, without symmetry. */
#define SAMPLES 8

/* Lift one of them. Out: x. Returns false if it is outside the domain. */
static bool sample(const jlt_chart *chart, double *x, unsigned point)
{
    double q[JLT_CHART_DIM_MAX];

    for (unsigned k = 0; k < chart->dim; k++) q[k] = point * point * (k + 0.3) / 7;
    return chart->lift(chart, x, NULL, q) == JLT_OK;
}

/* Warn if the section's state is an angle that seems to cross only against --direction: its rate has the wrong sign at all
 * samples. */
static void tell_other_way(const jlt_system *system)
{
    const jlt_chart *chart = system->flow.chart;
    double x[JLT_CHART_STATES_MAX], f[JLT_CHART_STATES_MAX];
    unsigned seen = 0;

    for (unsigned point = 0; chart->turn != 0 && point < SAMPLES; point++) {
        if (!sample(chart, x, point)) continue;
        seen++;
        system->instance->descriptor->rhs.call(x, system->instance->prepared, f);
        if (!(f[chart->column] * (int)system->flow.direction < 0)) return;
    }
    if (seen > 1)
        fprintf(stderr, "jellett: %s seems to cross its section the other way alone: --direction %s\n",
                system->instance->descriptor->states[chart->column].name, system->flow.direction == JLT_RISING ? "down" : "up");
}

/* Whether the section's state, no angle, has a rate that no state changes, at any sample: it never comes back. */
static bool leaves_for_good(const jlt_system *system)
{
    const jlt_chart *chart = system->flow.chart;
    const jlt_descriptor *d = system->instance->descriptor;
    double x[JLT_CHART_STATES_MAX], rows[JLT_CHART_STATES_MAX * JLT_CHART_STATES_MAX];
    unsigned seen = 0;

    for (unsigned point = 0; chart->turn == 0 && point < SAMPLES; point++) {
        if (!sample(chart, x, point)) continue;
        seen++;
        d->jacobian.call(x, system->instance->prepared, rows);
        for (unsigned i = 0; i < d->state_count; i++)
            if (rows[chart->column * d->state_count + i] != 0) return false;
    }
    return seen > 1;
}

static jlt_exit refuse_for_good(const char *section, const jlt_quantity *state, const jlt_descriptor *d)
{
    const jlt_claim *period = jlt_descriptor_claim(d, "periodic", state->name);

    fprintf(stderr, "jellett: %s changes at one rate everywhere on %s, and comes back to it only if it is an angle\n", state->name,
            section);
    if (period != NULL && period->verdict == JLT_PROVED)
        return jlt_command_fail(JLT_EXIT_INPUT, "--modulo %s=0 sets aside its period, which the table proves", state->name);
    if (period != NULL)
        return jlt_command_fail(JLT_EXIT_INPUT, "'periodic %s' is not proved of this table: %s", state->name, period->reason);
    return jlt_command_fail(JLT_EXIT_INPUT, "write 'periodic %s = PERIOD' in the table, or --modulo %s=PERIOD", state->name,
                            state->name);
}

jlt_exit jlt_motion_plane_system(jlt_system **system, const jlt_motion_options *options, const jlt_descriptor *descriptor)
{
    jlt_motion_plane plane = { .params = NULL };
    unsigned no_angle;
    jlt_exit code = jlt_motion_plane_read(&plane, options, descriptor, NULL, 0);

    if (code == JLT_EXIT_DONE) {
        const jlt_status st = jlt_motion_plane_make(&plane, system, &no_angle);
        if (no_angle < descriptor->state_count)
            code = jlt_command_fail(JLT_EXIT_INPUT, "--modulo: %s is no angle: the field of %s, its domain or a condition changes "
                                    "when it grows by %.17g",
                                    descriptor->states[no_angle].name, descriptor->model, plane.periods[no_angle]);
        else if (st != JLT_OK) code = jlt_motion_no_plane(st, descriptor->model);
        else if (options->mirror != NULL && plane.mirrored && !jlt_system_is_reversed(*system, plane.signs))
            code = jlt_command_fail(JLT_EXIT_INPUT, "--mirror %s: the field of %s is not reversed where these states change signs",
                                    options->mirror, descriptor->model);
        else if (leaves_for_good(*system)) code = refuse_for_good(options->section, &descriptor->states[plane.column], descriptor);
        else tell_other_way(*system);
    }
    jlt_motion_plane_clear(&plane);
    return code;
}

jlt_exit jlt_motion_project(jlt_system *system)
{
    JLT_PASS(jlt_common_project(system->instance->descriptor));
    JLT_PASS(jlt_common_one_step(system->flow.method));
    const jlt_status st = jlt_system_invariants(&system->flow.kept, system);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "--project");
}
