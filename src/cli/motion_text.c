/* What headers and pictures say of a system. */
#include "cli/motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/motion_plane.h"
#include "integrate/batch_method.h"
#include "kernel/descriptor.h"
#include "report/csv.h"
#include "report/decimal.h"

static bool is_swept(const jlt_motion_options *options, const char *name)
{
    for (size_t i = 0; i < options->swept_count; i++)
        if (strcmp(options->swept[i].name, name) == 0) return true;
    return false;
}

unsigned jlt_motion_levels(const jlt_system *system, const char **names, double *values)
{
    const jlt_surface *surface = system->surface;
    const unsigned count = surface != NULL ? surface->count - surface->params : system->flow.chart->solved_count;

    for (unsigned k = 0; k < count; k++) {
        const jlt_level *level = surface == NULL ? &system->chart.level.levels[k] : NULL;
        names[k] = surface != NULL ? surface->names[surface->params + k] : system->instance->descriptor->integrals[level->integral].name;
        values[k] = surface != NULL ? system->values[surface->params + k] : level->value;
    }
    return count;
}

const char *jlt_motion_method(const jlt_motion_options *options)
{
    if (options->common.lanes) return jlt_batch_method_for(options->flow.tolerance)->name;
    return options->flow.method != NULL ? options->flow.method->name : "each";
}

void jlt_motion_header(FILE *stream, const jlt_motion_options *options, const jlt_system *system)
{
    static const char *const directions[] = { "downwards", "in both directions", "upwards" };
    const jlt_chart *chart = system->flow.chart;

    const jlt_descriptor *d = system->instance->descriptor;
    double *params = malloc((d->param_count + 1) * sizeof *params), levels[JLT_INVARIANTS_MAX];
    const char *names[JLT_INVARIANTS_MAX], *method = jlt_motion_method(options);
    const unsigned level_count = jlt_motion_levels(system, names, levels);

    if (params == NULL) return;
    for (unsigned k = 0; k < d->param_count; k++)
        params[k] = is_swept(options, d->params[k].name) ? NAN : system->instance->params[k];
    for (unsigned k = 0; k < level_count; k++)
        if (is_swept(options, names[k])) levels[k] = NAN;
    jlt_csv_header(stream, &(jlt_csv_settings){ options->common.command, d, params, names, levels, level_count,
                                                method, options->flow.tolerance });
    free(params);
    if (level_count > 0) {
        fputs("# levels", stream);
        for (unsigned k = 0; k < level_count; k++) jlt_decimal_write_named(stream, &(jlt_quantity){ .name = names[k] }, &levels[k], 1);
        if (chart->solved_count > 0) jlt_motion_plane_solved(stream, system);
        fputc('\n', stream);
    }
    fprintf(stream, "# section %s=%.17g crossed %s; method %s, tolerance %.3g", system->instance->descriptor->states[chart->column].name,
            chart->level, directions[options->flow.direction + 1], method, options->flow.tolerance);
    if (jlt_observed_conditions(system->observed) > 0)
        fprintf(stream, "; loss of %s: %s", jlt_observed_condition(system->observed, JLT_OBSERVED_ANY), options->contact);
    fputs("; nothing is random, so there is no seed\n", stream);
}

static void caption_value(FILE *stream, bool *is_first, const char *name, double value, const char *swept)
{
    if (swept != NULL && strcmp(name, swept) == 0) return;
    fprintf(stream, "%s%s=%.6g", *is_first ? "" : ", ", name, value);
    *is_first = false;
}

void jlt_motion_caption(FILE *stream, const jlt_system *system, const char *swept)
{
    const jlt_descriptor *d = system->instance->descriptor;
    const char *names[JLT_INVARIANTS_MAX];
    double levels[JLT_INVARIANTS_MAX];
    const unsigned level_count = jlt_motion_levels(system, names, levels);
    bool is_first = true;

    for (unsigned i = 0; i < d->param_count; i++) {
        unsigned k = 0;
        while (k < level_count && strcmp(names[k], d->params[i].name) != 0) k++;
        if (k == level_count) caption_value(stream, &is_first, d->params[i].name, system->instance->params[i], swept);
    }
    for (unsigned k = 0; k < level_count; k++) caption_value(stream, &is_first, names[k], levels[k], swept);
}

/* A name as gnuplot sets it: Greek letters by their names, numbers at the end below the line. */
static void write_symbol(FILE *stream, const char *name)
{
    static const char *const greek[][2] = { { "alpha", "α" }, { "beta", "β" }, { "gamma", "γ" }, { "delta", "δ" }, { "eta", "η" },
                                            { "theta", "θ" }, { "lambda", "λ" }, { "mu", "μ" }, { "phi", "φ" }, { "psi", "ψ" },
                                            { "omega", "ω" } };
    const size_t letters = strcspn(name, "_0123456789");

    for (size_t i = 0; i < sizeof greek / sizeof *greek; i++)
        if (strlen(greek[i][0]) == letters && strncmp(name, greek[i][0], letters) == 0) {
            const char *below = name + letters + (name[letters] == '_');
            fprintf(stream, *below == '\0' ? "%s" : below[1] == '\0' ? "%s_%s" : "%s_{%s}", greek[i][1], below);
            return;
        }
    fputs(name, stream);
}

void jlt_motion_label(FILE *stream, const jlt_system *system, char axis, unsigned coordinate, const char *added)
{
    if (system->surface != NULL) {
        fprintf(stream, "set %clabel \"", axis);
        write_symbol(stream, system->flow.chart->names[coordinate]);
        if (system->surface->section->is_angle[coordinate]) fputs(" [rad]", stream);
        fprintf(stream, "%s\"\n", added);
    } else fprintf(stream, "set %clabel \"%s%s\" noenhanced\n", axis, system->flow.chart->names[coordinate], added);
}

void jlt_motion_labels(FILE *stream, const jlt_system *system)
{
    jlt_motion_label(stream, system, 'x', 0, "");
    jlt_motion_label(stream, system, 'y', 1, "");
}

void jlt_motion_frame(FILE *stream, const jlt_system *system)
{
    for (unsigned k = 0; system->surface != NULL && k < 2 && k < system->flow.chart->dim; k++) {
        const jlt_quantity *coordinate = &system->surface->section->coordinates[k];
        const char axis = k == 0 ? 'x' : 'y';
        if (system->surface->section->is_angle[k]) fprintf(stream, "set %crange [-pi:pi]\n", axis);
        else if (isfinite(coordinate->low) && isfinite(coordinate->high))
            fprintf(stream, "set %crange [%.10g:%.10g]\n", axis, coordinate->low, coordinate->high);
    }
}
