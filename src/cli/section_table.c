#include "cli/section_table.h"

#include <math.h>

#include "report/csv.h"

void jlt_section_table_names(FILE *stream, const jlt_section_table *table)
{
    const jlt_chart *chart = table->system->flow.chart;

    fputs("orbit,return,t", stream);
    for (unsigned k = 0; k < chart->dim; k++) fprintf(stream, ",%s", chart->names[k]);
    fprintf(stream, "%s,fate", table->system->is_top ? ",v_nu,omega_n,omega3" : "");
    if (table->least) fprintf(stream, ",%s_min", jlt_observed_condition(table->system->observed));
    fprintf(stream, "%s\n", table->check ? ",trace,det,divergence,defect" : "");
}

/* DP from the point before. */
static void write_check(FILE *stream, jlt_section_table *table, const jlt_section_row *row)
{
    const unsigned d = table->system->flow.chart->dim;
    jlt_image image;
    double trace = 0;

    if (row->at.number == 0 || row->at.fate != JLT_FATE_ALIVE
        || jlt_map_apply(table->map, &image, row->before, 1, table->time_direction) != JLT_OK) {
        fputs(",,,,", stream);
        return;
    }
    for (unsigned k = 0; k < d; k++) trace += image.slope[k * d + k];
    if (fabs(image.defect) > table->worst_share * image.bound) {
        table->worst_share = fabs(image.defect) / image.bound;
        table->worst_defect = fabs(image.defect);
    }
    const double values[] = { trace, image.determinant, image.expansion, image.defect };
    fputc(',', stream);
    jlt_csv_values(stream, values, 4);
}

static void write_field(FILE *stream, double value)
{
    fputc(',', stream);
    jlt_csv_value(stream, value);
}

void jlt_section_table_row(FILE *stream, void *table, const void *row)
{
    jlt_section_table *self = table;
    const jlt_section_row *which = row;
    const jlt_system *system = self->system;
    const jlt_return *at = &which->at;
    char fate[JLT_FATE_TEXT_MAX];
    double omega_n, omega3;

    fprintf(stream, "%zu,%zu", which->orbit, at->number);
    write_field(stream, at->t);
    for (unsigned k = 0; k < system->flow.chart->dim; k++) {
        const bool is_gamma3 = system->is_top && k == 1; /* known off the section as well */
        write_field(stream, is_gamma3 ? fmax(-1, fmin(1, at->x[JLT_CHART_TOP_GAMMA3])) : at->q[k]);
    }
    if (system->is_top) {
        jlt_chart_top_rotation(&system->chart.top, &omega_n, &omega3, at->x);
        write_field(stream, at->x[JLT_CHART_TOP_V_NU]);
        write_field(stream, omega_n);
        write_field(stream, omega3);
    }
    fputc(',', stream);
    jlt_section_fate_text(fate, system->observed, at->fate);
    fputs(fate, stream);
    if (self->least) write_field(stream, at->least);
    if (self->check) write_check(stream, self, which);
    fputc('\n', stream);
}
