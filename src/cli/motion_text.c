/* Writes what headers and pictures say of a system, and the start that it has by default. */
#include "cli/motion.h"

#include <math.h>
#include <string.h>

#include "cli/motion_many.h"
#include "core/digits.h"
#include "core/memory.h"
#include "integrate/batch_method.h"
#include "kernel/descriptor.h"
#include "report/csv.h"
#include "report/decimal.h"

static bool is_swept(const jlt_motion_options *options, const char *name)
{
    for (size_t i = 0; i < options->swept_count; i++)
        if (strcmp(options->swept[i].name, name) == 0) return true;
    return jlt_common_runs(&options->common, name);
}

/* Whether a parameter of the table has the same value in all rows: no sweep changes it, or anything that it is computed from. */
static bool is_one(const jlt_motion_options *options, const jlt_surface *surface, const jlt_descriptor *d, unsigned param)
{
    const char *name = d->params[param].name;

    if (surface == NULL || jlt_link_source(&surface->link, name) != JLT_SOURCE_PARAMS) return !is_swept(options, name);
    for (unsigned i = 0; i < surface->params; i++)
        if (is_swept(options, surface->names[i])) return false;
    return true;
}

/* The parameters that a header names, NaN for those that a sweep changes: the asked table's, whose names users type, then those
 * that the section's table has beside. Out: shape (at most the number of both,). Returns their number. */
static size_t list_params(jlt_quantity *out, double *values, const jlt_motion_options *options, const jlt_system *system)
{
    const jlt_surface *surface = system->surface;
    const jlt_descriptor *d = system->instance->descriptor;
    size_t count = 0;

    for (unsigned i = 0; surface != NULL && i < surface->params; i++) {
        out[count] = (jlt_quantity){ .name = surface->names[i] };
        values[count++] = is_swept(options, surface->names[i]) ? NAN : system->values[i];
    }
    for (unsigned k = 0; k < d->param_count; k++) {
        if (surface != NULL && jlt_surface_value(surface, d->params[k].name) < surface->params) continue;
        out[count] = d->params[k];
        values[count++] = is_one(options, surface, d, k) ? system->instance->params[k] : NAN;
    }
    return count;
}

unsigned jlt_motion_levels(const jlt_system *system, const char **names, double *values)
{
    const jlt_surface *surface = system->surface;
    const unsigned count = surface != NULL ? surface->count - surface->params : system->flow.chart->solved_count;

    for (unsigned k = 0; k < count; k++) {
        const jlt_level *level = surface == NULL ? &system->chart.level.levels[k] : NULL;
        names[k] = surface != NULL ? surface->names[surface->params + k]
                                   : system->instance->descriptor->integrals[level->integral].name;
        values[k] = surface != NULL ? system->values[surface->params + k] : level->value;
    }
    return count;
}

const char *jlt_motion_method(const jlt_motion_options *options)
{
    if (options->in_lanes) return jlt_batch_method_for(options->flow.tolerance)->name;
    return options->flow.method != NULL ? options->flow.method->name : "each";
}

/* The levels that are the same in all rows, and the states that are solved for on levels. */
static void write_levels(FILE *stream, const jlt_system *system, const char *const *names, const double *levels, unsigned count)
{
    const unsigned solved = system->flow.chart->solved_count;
    char text[JLT_DIGITS_SIZE];
    bool fixed = false;

    for (unsigned k = 0; k < count; k++) fixed = fixed || !isnan(levels[k]);
    if (fixed) fputs("# levels", stream);
    for (unsigned k = 0; k < count; k++) jlt_decimal_write_named(stream, &(jlt_quantity){ .name = names[k] }, &levels[k], 1);
    for (unsigned i = 0; i < solved; i++) {
        const jlt_level *level = &system->chart.level.levels[i];
        jlt_digits_shortest(text, level->guess);
        fprintf(stream, "%s %s from %s", i > 0 ? "," : fixed ? "; solved for" : "# solved for",
                system->instance->descriptor->states[level->state].name, text);
    }
    if (fixed || solved > 0) fputc('\n', stream);
}

void jlt_motion_header(FILE *stream, const jlt_motion_options *options, const jlt_system *system)
{
    static const char *const directions[] = { "downwards", "in both directions", "upwards" };
    const jlt_chart *chart = system->flow.chart;

    const jlt_descriptor *d = system->instance->descriptor;
    const size_t room = d->param_count + (system->surface != NULL ? system->surface->params : 0) + 1;
    JLT_FREED double *params = malloc(room * sizeof *params);
    JLT_FREED jlt_quantity *quantities = malloc(room * sizeof *quantities);
    double levels[JLT_INVARIANTS_MAX];
    const char *names[JLT_INVARIANTS_MAX], *method = jlt_motion_method(options);
    char digits[JLT_DIGITS_SIZE];
    const unsigned level_count = jlt_motion_levels(system, names, levels);

    if (params == NULL || quantities == NULL) return;
    const size_t param_count = list_params(quantities, params, options, system);
    for (unsigned k = 0; k < level_count; k++)
        if (is_swept(options, names[k])) levels[k] = NAN;
    jlt_csv_header(stream, &(jlt_csv_settings){ options->common.command, d, quantities, param_count, params, names, levels,
                                                level_count, method, options->flow.tolerance, NULL });
    write_levels(stream, system, names, levels, level_count);
    jlt_digits_shortest(digits, ldexp(chart->level, system->flow.units.state[chart->column]));
    fprintf(stream, "# section %s=%s crossed %s; method %s, tolerance %.3g", d->states[chart->column].name,
            digits, directions[options->flow.direction + 1], method, options->flow.tolerance);
    if (jlt_observed_conditions(system->flow.observed) > 0)
        fprintf(stream, "; loss of %s: %s", jlt_observed_condition(system->observed, JLT_OBSERVED_ANY), options->contact);
    if (options->is_random) fprintf(stream, "; seed %zu\n", options->seed);
    else fputs("; nothing is random, so there is no seed\n", stream);
    jlt_motion_many_line(stream, "#", options, system);
}

void jlt_motion_caption(jlt_plot *plot, const jlt_system *system, const char *swept)
{
    const jlt_surface *surface = system->surface; /* its values are the asked table's, whose names users type */
    const jlt_descriptor *d = system->instance->descriptor;
    const char *names[JLT_INVARIANTS_MAX];
    double levels[JLT_INVARIANTS_MAX];
    const unsigned level_count = jlt_motion_levels(system, names, levels);
    const unsigned params = surface != NULL ? surface->params : d->param_count;

    for (unsigned i = 0; i < params + level_count; i++) {
        const bool level = i >= params;
        const char *name = level ? names[i - params] : surface != NULL ? surface->names[i] : d->params[i].name;
        const double value = level ? levels[i - params] : surface != NULL ? system->values[i] : system->instance->params[i];
        if (swept == NULL || strcmp(name, swept) != 0) jlt_plot_value(plot, name, value);
    }
}

static const char *unit_of(const jlt_system *system, unsigned coordinate)
{
    const jlt_descriptor *d = system->instance->descriptor;
    size_t index;

    if (system->surface != NULL && system->surface->section->is_angle[coordinate]) return "rad";
    if (system->surface != NULL) return system->surface->section->coordinates[coordinate].unit;
    return jlt_descriptor_state(d, system->flow.chart->names[coordinate], &index) ? d->states[index].unit : "";
}

/* The interval of a coordinate in its table, one period around 0 for an angle; infinite if there is none. */
static jlt_extent bounds_of(const jlt_system *system, unsigned coordinate)
{
    const double period = system->flow.chart->period[coordinate];
    const jlt_quantity *q = system->surface != NULL ? &system->surface->section->coordinates[coordinate] : NULL;

    if (q == NULL) return (jlt_extent){ -INFINITY, INFINITY };
    return period != 0 ? (jlt_extent){ -period / 2, period / 2 } : (jlt_extent){ q->low, q->high };
}

bool jlt_motion_framed(const jlt_system *system, unsigned coordinate)
{
    const jlt_extent bounds = bounds_of(system, coordinate);
    return isfinite(bounds.low) && isfinite(bounds.high);
}

jlt_extent jlt_motion_axis(jlt_plot *plot, const jlt_system *system, char axis, unsigned coordinate, jlt_extent range)
{
    const double period = system->flow.chart->period[coordinate];
    char label[JLT_LOOK_LABEL_MAX];

    jlt_look_label(label, system->flow.chart->names[coordinate], unit_of(system, coordinate));
    if (period != 0 && range.high - range.low > period / 2) range = (jlt_extent){ -period / 2, period / 2 };
    else if (isinf(range.low))
        range = jlt_motion_framed(system, coordinate) ? bounds_of(system, coordinate) : (jlt_extent){ -1, 1 };
    return jlt_plot_axis(plot, axis, label, range, period);
}

void jlt_motion_label(char *label, const jlt_system *system, const char *name)
{
    jlt_plot_label(label, system->surface != NULL ? system->surface->asked : system->instance->descriptor, name);
}

jlt_exit jlt_motion_shown(unsigned shown[2], const jlt_motion_options *options, const jlt_system *system)
{
    const jlt_chart *chart = system->flow.chart;

    shown[0] = 0;
    shown[1] = chart->dim > 1;
    return jlt_plot_shown(shown, &options->common, chart->names, chart->dim);
}

jlt_exit jlt_motion_default_start(jlt_motion_options *options, const jlt_system *system, jlt_surface_start purpose,
                                  const char *wanted)
{
    static const char *const names[JLT_STARTS] = { "regular", "chaotic", "saddle" };
    const jlt_section_chart *section = system->surface != NULL ? system->surface->section : NULL;
    const char **start = &options->starts[0];
    size_t used = 0;

    for (unsigned i = 0; *start == NULL && section != NULL && i < section->start_count; i++) {
        if (strcmp(section->starts[i].name, names[purpose]) != 0) continue;
        for (unsigned k = 0; k < section->coordinate_count && used < sizeof options->start; k++) {
            char digits[JLT_DIGITS_SIZE];
            jlt_digits_shortest(digits, section->starts[i].point[k]);
            used += (size_t)snprintf(options->start + used, sizeof options->start - used, "%s%s=%s", k == 0 ? "" : ",",
                                     section->coordinates[k].name, digits);
        }
        *start = options->start;
    }
    if (*start != NULL) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_USAGE, "%s, with all coordinates of the section", wanted);
}
