#include "cli/section_table.h"

#include <math.h>
#include <string.h>

#include "dynamics/surface.h"
#include "report/csv.h"

size_t jlt_section_row_size(const jlt_chart *chart)
{
    return sizeof(jlt_section_row) + (2 * chart->dim + chart->states) * sizeof(double);
}

void jlt_section_row_fill(jlt_section_row *row, const jlt_chart *chart, size_t orbit, const jlt_return *at, const double *before)
{
    row->orbit = orbit;
    row->number = at->number;
    row->t = at->t;
    row->least = at->least;
    row->fate = at->fate;
    row->lost = at->lost;
    memcpy(row->values, at->q, chart->dim * sizeof *at->q);
    memcpy(row->values + chart->dim, at->x, chart->states * sizeof *at->x);
    if (before != NULL) memcpy(row->values + chart->dim + chart->states, before, chart->dim * sizeof *before);
}

void jlt_section_table_names(FILE *stream, const jlt_section_table *table)
{
    const jlt_chart *chart = table->system->flow.chart;
    const jlt_section_chart *section = table->system->surface != NULL ? table->system->surface->section : NULL;

    jlt_csv_names names;
    FILE *line = jlt_csv_names_begin(&names, stream);

    fputs("orbit,return,t", line);
    for (unsigned k = 0; k < chart->dim; k++) fprintf(line, ",%s", chart->names[k]);
    for (unsigned i = 0; i < chart->solved_count; i++)
        fprintf(line, ",%s", table->system->instance->descriptor->states[chart->solved[i]].name);
    for (unsigned i = 0; section != NULL && i < section->beside_count; i++) fprintf(line, ",%s", section->beside[i].name);
    fputs(",fate", line);
    if (table->least) fprintf(line, ",%s_min", jlt_observed_condition(table->system->observed, JLT_OBSERVED_ANY));
    if (table->check) fputs(",trace,det,divergence,defect", line);
    jlt_csv_names_end(&names);
}

/* Write the columns of --check: DP at the point before, of which this row is the return. */
static void write_check(FILE *stream, jlt_section_table *table, const jlt_section_row *row)
{
    const unsigned d = table->system->flow.chart->dim, states = table->system->flow.chart->states;
    const volatile sig_atomic_t *const interrupt = table->system->flow.interrupt;
    jlt_image image;
    double trace = 0;

    const bool asked = row->number > 0 && row->fate == JLT_FATE_ALIVE;
    if (!asked || jlt_map_apply(table->map, &image, row->values + d + states, 1, table->time_direction) != JLT_OK) {
        table->unchecked += asked && !(interrupt != NULL && *interrupt);
        fputs(",,,,", stream);
        return;
    }
    table->checked++;
    for (unsigned k = 0; k < d; k++) trace += image.slope[k * d + k];
    if (!(fabs(image.defect) <= table->worst_share * image.bound)) table->worst_share = fabs(image.defect) / image.bound;
    if (!(fabs(image.defect) <= table->worst_defect)) table->worst_defect = fabs(image.defect);
    const double values[] = { trace, image.determinant, image.expansion, image.defect };
    jlt_csv_more(stream, values, 4);
}

void jlt_section_table_row(FILE *stream, void *table, const void *row)
{
    jlt_section_table *self = table;
    const jlt_section_row *at = row;
    const jlt_system *system = self->system;
    const jlt_section_chart *section = system->surface != NULL ? system->surface->section : NULL;
    const unsigned d = system->flow.chart->dim;
    const double *q = at->values, *x = at->values + d;
    double values[3 + JLT_CHART_DIM_MAX + 2 * JLT_CHART_STATES_MAX], off[JLT_CHART_DIM_MAX];
    char fate[JLT_FATE_TEXT_MAX];
    unsigned count = 0;

    values[count++] = (double)at->orbit;
    values[count++] = (double)at->number;
    values[count++] = at->t;
    bool is_off = false;
    for (unsigned k = 0; section != NULL && k < d; k++) is_off |= isnan(q[k]);
    if (is_off) jlt_surface_off_section(off, system, x);
    for (unsigned k = 0; k < d; k++) values[count++] = is_off && isnan(q[k]) ? off[k] : q[k];
    for (unsigned i = 0; i < system->flow.chart->solved_count; i++) values[count++] = x[system->flow.chart->solved[i]];
    if (section != NULL) {
        jlt_surface_beside(values + count, system, x);
        count += section->beside_count;
    }
    (self->as_bits ? jlt_csv_bits : jlt_csv_values)(stream, values, count);
    putc_unlocked(',', stream); /* a stream of this thread alone */
    jlt_section_fate_text(fate, system->observed, at->fate, at->lost);
    fputs(fate, stream);
    if (self->least) jlt_csv_more(stream, &at->least, 1);
    if (self->check) write_check(stream, self, at);
    putc_unlocked('\n', stream);
}

bool jlt_section_table_verdict(const jlt_section_table *table)
{
    if (table->unchecked > 0)
        fprintf(stderr, "jellett: DP could not be computed at %zu of %zu returns%s\n", table->unchecked,
                table->unchecked + table->checked,
                table->system->flow.chart->solved_count > 0 ? ": from or to another branch of --solve there is none" : "");
    if (table->checked == 0) return table->unchecked == 0;
    fprintf(stderr, "jellett: det DP against flux and divergence: worst relative defect %.2g; at most %.2g of its bound\n",
            table->worst_defect, table->worst_share);
    return table->worst_share <= 1;
}

void jlt_section_table_lost(char *text, size_t size, const size_t *orbits, size_t all, const jlt_observed *observed)
{
    size_t used = 0;

    *text = '\0';
    for (unsigned i = 0; i < JLT_OBSERVED_CONDITIONS_MAX && used < size; i++) {
        if (orbits[i] == 0) continue;
        used += (size_t)snprintf(text + used, size - used, "%s%s", used > 0 ? " or " : "", jlt_observed_condition(observed, i));
        if (orbits[i] < all && used < size) used += (size_t)snprintf(text + used, size - used, " (%zu)", orbits[i]);
    }
}
