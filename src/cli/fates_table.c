#include "cli/fates_table.h"

#include "base/text.h"

#include <string.h>

#include "report/csv.h"

/* Whether the model asked for has conditions; the section's table may have some that it has not. */
static bool has_conditions(const jlt_system *system) { return jlt_observed_conditions(system->flow.observed) > 0; }

static const char *conditions(const jlt_system *system) { return jlt_observed_condition(system->observed, JLT_OBSERVED_ANY); }

static bool tells_contact(const jlt_motion_options *options) { return strcmp(options->contact, "report") == 0; }

/* The section, if it says which quantities to show where an orbit ends; NULL: all states are shown. */
static const jlt_section_chart *ending_of(const jlt_system *system)
{
    return system->surface != NULL && system->surface->section->ending_count > 0 ? system->surface->section : NULL;
}

void jlt_fates_table_names(FILE *file, const jlt_motion_options *options, const jlt_system *system)
{
    const jlt_chart *chart = system->flow.chart;
    const jlt_section_chart *section = ending_of(system);
    const unsigned count = section != NULL ? section->ending_count : chart->states - chart->roots;

    jlt_csv_names names;
    FILE *line = jlt_csv_names_begin(&names, file);

    for (unsigned k = 0; k < chart->dim; k++) fprintf(line, "%s,", chart->names[k]);
    fputs("fate,t_end", line);
    for (unsigned i = 0; i < count; i++)
        fprintf(line, ",%s_end", (section != NULL ? section->ending : system->instance->descriptor->states)[i].name);
    if (tells_contact(options)) fprintf(line, ",%s_min", conditions(system));
    jlt_csv_names_end(&names);
}

/* Bring the angles of a state within half a period of 0, or of the section. */
static void wrap(const jlt_system *system, double *x)
{
    const jlt_descriptor *d = system->instance->descriptor;

    for (unsigned i = 0; system->surface != NULL && i < d->state_count; i++)
        if (jlt_descriptor_proves(d, "periodic", d->states[i].name)) x[i] = jlt_chart_reduce(x[i], d->states[i].period);
    if (system->surface != NULL) jlt_chart_turn_back(system->flow.chart, x);
    else jlt_chart_wrap_state(system->flow.chart, x);
}

void jlt_fates_table_row(FILE *file, const jlt_motion_options *options, const jlt_system *system, const double *q,
                         const jlt_fates_end *end)
{
    const jlt_chart *chart = system->flow.chart;
    double values[JLT_CHART_STATES_MAX + 2] = { end->t };
    unsigned count = 1;
    char fate[JLT_FATE_TEXT_MAX];

    if (ending_of(system) != NULL) {
        jlt_surface_ending(values + count, system, end->x);
        count += ending_of(system)->ending_count;
    } else {
        memcpy(values + count, end->x, chart->states * sizeof *values);
        wrap(system, values + count);
        count += chart->states - chart->roots;
    }
    if (tells_contact(options)) values[count++] = end->least;
    jlt_csv_values(file, q, chart->dim);
    jlt_section_fate_text(fate, system->observed, end->fate, end->lost);
    fprintf(file, ",%s,", fate);
    jlt_csv_row(file, values, count);
}

/* The fates that have a column in the table of a sweep, in this order. */
static const jlt_fate told[] = { JLT_FATE_POLE_PLUS,   JLT_FATE_POLE_MINUS, JLT_FATE_INVALID, JLT_FATE_EQUILIBRIUM,
                                 JLT_FATE_LEFT_DOMAIN, JLT_FATE_ALIVE,      JLT_FATE_BUDGET };
enum { TOLD = sizeof told / sizeof *told };

/* Whether orbits of this section can have this fate. */
static bool can_be(const jlt_system *system, jlt_fate fate)
{
    const jlt_descriptor *asked = system->surface != NULL ? system->surface->asked : system->instance->descriptor;
    const bool poles = system->flow.chart->side != NULL && asked->family[0]->pole_count > 0;

    switch (fate) {
    case JLT_FATE_POLE_PLUS:
    case JLT_FATE_POLE_MINUS: return poles;
    case JLT_FATE_INVALID: return has_conditions(system);
    case JLT_FATE_LEFT_DOMAIN:
        return system->surface == NULL || !poles || system->surface->table->domain_count > 0;
    default: return true;
    }
}

void jlt_fates_table_share_names(FILE *file, const jlt_system *base, const jlt_grid_axis *axes, size_t count)
{
    char name[JLT_FATE_TEXT_MAX];
    jlt_csv_names names;
    FILE *line = jlt_csv_names_begin(&names, file);

    for (size_t k = 0; k < count; k++) fprintf(line, "%s,", axes[k].name);
    fprintf(line, "starts%s", jlt_shares_turn(base) ? ",low_starts" : "");
    for (size_t i = 0; i < TOLD; i++) {
        jlt_section_fate_text(name, base->observed, told[i], JLT_OBSERVED_ANY);
        if (can_be(base, told[i])) fprintf(line, ",%s", name);
    }
    fputs(",failed", line);
    if (jlt_shares_turn(base)) fprintf(line, ",turned,turned_error%s", has_conditions(base) ? ",turned_in_contact" : "");
    else if (has_conditions(base)) fprintf(line, ",%s_held", conditions(base));
    jlt_csv_names_end(&names);
}

void jlt_fates_table_shares(FILE *file, FILE *points, const jlt_system *base, const double *values, size_t count,
                            const jlt_shares *sum)
{
    const bool turns = jlt_shares_turn(base);
    double share, error, kept, kept_error;

    jlt_csv_values(file, values, count);
    fprintf(file, ",%zu", sum->all.starts);
    if (turns) fprintf(file, ",%zu", sum->low.starts);
    for (size_t i = 0; i < TOLD; i++)
        if (can_be(base, told[i])) fprintf(file, ",%zu", sum->all.by_fate[told[i]]);
    fprintf(file, ",%zu", sum->all.failures.count);
    if (turns) jlt_fates_share(&share, &error, sum->turned.starts, sum->low.starts);
    else jlt_fates_share(&share, &error, sum->all.by_fate[JLT_FATE_ALIVE], sum->all.starts);
    jlt_fates_share(&kept, &kept_error, jlt_fates_held(&sum->turned), sum->low.starts);
    if (turns && sum->low.starts > 0) fprintf(file, ",%.9g,%.3g", share, error);
    else if (turns) fputs(",,", file);
    if (turns && has_conditions(base) && sum->low.starts > 0) fprintf(file, ",%.9g", kept);
    else if (turns && has_conditions(base)) fputc(',', file);
    else if (has_conditions(base)) fprintf(file, ",%zu", jlt_fates_held(&sum->all));
    fputc('\n', file);
    if (points != NULL) jlt_look_row(points, (const double[]){ values[0], share, error, kept }, 4);
}

void jlt_fates_table_summary(FILE *stream, const jlt_motion_options *options, const jlt_system *system, const jlt_shares *sum)
{
    char name[JLT_FATE_TEXT_MAX];
    double turned, error, kept, kept_error;
    bool first = true;

    fprintf(stream, "%zu start%s:", sum->all.starts, ttc_text_plural(sum->all.starts));
    for (int fate = JLT_FATE_ALIVE; fate < (int)JLT_FATE_COUNT; fate++) {
        const bool usual = fate <= (int)JLT_FATE_EQUILIBRIUM && can_be(system, (jlt_fate)fate)
                           && (fate != (int)JLT_FATE_INVALID || options->flow.end_where_invalid);
        if (!usual && sum->all.by_fate[fate] == 0) continue;
        jlt_section_fate_text(name, system->observed, (jlt_fate)fate, JLT_OBSERVED_ANY);
        fprintf(stream, "%s %zu %s", first ? "" : ",", sum->all.by_fate[fate], name);
        first = false;
    }
    jlt_fates_share(&turned, &error, sum->turned.starts, sum->low.starts);
    jlt_fates_share(&kept, &kept_error, jlt_fates_held(&sum->turned), sum->low.starts);
    if (sum->low.starts > 0)
        fprintf(stream, "; of %zu %s %.4g +- %.2g turn over", sum->low.starts, system->surface->section->turn_meaning, turned,
                error);
    if (sum->low.starts > 0 && has_conditions(system))
        fprintf(stream, ", %.4g +- %.2g with %s all the way", kept, kept_error, conditions(system));
    const size_t lost = sum->all.starts - jlt_fates_held(&sum->all) - sum->all.unknown;
    if (has_conditions(system) && !options->flow.end_where_invalid && lost > 0)
        fprintf(stream, "; %zu lose %s on the way and were followed all the same (--contact end stops them there)", lost,
                conditions(system));
    if (sum->all.unknown > 0)
        fprintf(stream, "; of %zu it is not known whether they do, as a condition has no value on the way", sum->all.unknown);
    if (sum->empty > 0) fprintf(stream, "; at %zu point%s of the grid there is no state", sum->empty, ttc_text_plural(sum->empty));
    fputc('\n', stream);
}
