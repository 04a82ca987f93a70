#include "cli/section_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"
#include "dynamics/surface.h"
#include "report/csv.h"

/* Columns of --check: trace, det, divergence, defect. */
enum { CHECKED = 4 };

size_t jlt_section_row_size(const jlt_chart *chart)
{
    return sizeof(jlt_section_row) + (2 * chart->dim + chart->states + CHECKED) * sizeof(double);
}

static jlt_section_row *row_at(const jlt_chart *chart, void *rows, size_t index)
{
    return (jlt_section_row *)(void *)((char *)rows + index * jlt_section_row_size(chart));
}

/* The point before of a row, shape (dim,), and behind it the columns of --check. */
static double *checked_at(const jlt_chart *chart, jlt_section_row *row) { return row->values + chart->dim + chart->states; }

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
    if (before != NULL) memcpy(checked_at(chart, row), before, chart->dim * sizeof *before);
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

/* Only a return has a DP, and only of an orbit that goes on. */
static bool is_asked(const jlt_section_row *row) { return row->number > 0 && row->fate == JLT_FATE_ALIVE; }

static void keep_worst(double *worst, double value)
{
    if (value > *worst || isnan(value)) *worst = value; /* and stays so */
}

/* Put DP and its defect, of image number `index`, into the columns of the row at which it arrives. Returns false if an interrupt
 * cut it off. */
static bool take_image(jlt_section_table *self, jlt_section_row *row, const jlt_map_images *images, size_t index)
{
    const jlt_chart *chart = self->system->flow.chart;
    const unsigned d = chart->dim;
    double *before = checked_at(chart, row), *columns = before + d;
    const volatile sig_atomic_t *const interrupt = self->system->flow.interrupt;
    const double defect = images->defect[index];

    if (images->status[index] != JLT_OK) {
        if (interrupt != NULL && *interrupt) return false;
        if (isnan(before[0]) || !jlt_chart_follows(chart, row->values + d)) self->strayed++;
        else self->unchecked++;
        return true;
    }
    self->checked++;
    columns[0] = 0;
    for (unsigned k = 0; k < d; k++) columns[0] += images->slope[index * d * d + k * d + k];
    columns[1] = images->determinant[index];
    columns[2] = images->expansion[index];
    columns[3] = defect;
    keep_worst(&self->worst_share, defect == 0 ? 0 : fabs(defect) / images->bound[index]);
    keep_worst(&self->worst_defect, fabs(defect));
    return true;
}

jlt_status jlt_section_table_check(void *table, void *rows, size_t *count)
{
    jlt_section_table *self = table;
    const jlt_chart *chart = self->system->flow.chart;
    const unsigned d = chart->dim;
    const size_t all = *count;
    jlt_map_images images;
    jlt_status st;

    JLT_PASS(jlt_map_batch_images(&images, d, all));
    JLT_FREED double *points = calloc(all, (d + 1) * sizeof *points); /* the points; behind them the bounds */
    size_t asked = 0;
    for (size_t i = 0; points != NULL && i < all; i++) {
        jlt_section_row *row = row_at(chart, rows, i);
        if (is_asked(row)) memcpy(points + asked++ * d, checked_at(chart, row), d * sizeof *points);
    }
    images.bound = points != NULL ? points + all * d : NULL;
    st = points != NULL ? jlt_map_batch_apply(self->maps, &images, points, asked, 1, self->time_direction) : JLT_ERR_NOMEM;
    bool is_whole = self->dropped == 0;
    for (size_t i = 0, index = 0; st == JLT_OK && i < all && is_whole; i++) {
        jlt_section_row *row = row_at(chart, rows, i);
        double *columns = checked_at(chart, row) + d;
        for (unsigned k = 0; k < CHECKED; k++) columns[k] = NAN;
        if (is_asked(row)) is_whole = take_image(self, row, &images, index++);
        if (!is_whole) *count = i;
    }
    if (self->dropped > 0) *count = 0;
    self->dropped += all - *count;
    jlt_map_batch_images_clear(&images);
    return st;
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
    fputs_unlocked(fate, stream);
    if (self->least) jlt_csv_more(stream, &at->least, 1);
    if (self->check) jlt_csv_more(stream, x + system->flow.chart->states + d, CHECKED);
    putc_unlocked('\n', stream);
}

bool jlt_section_table_verdict(const jlt_section_table *table)
{
    const size_t without = table->unchecked + table->strayed;

    if (without > 0)
        fprintf(stderr, "jellett: DP could not be computed at %zu of %zu returns%s\n", without, without + table->checked,
                table->unchecked == 0 ? ": from or to another branch of --solve, or another level, there is none" : "");
    if (table->checked == 0) return without == 0;
    fprintf(stderr, "jellett: det DP against flux and divergence: worst relative defect %.2g; at most %.2g of its bound\n",
            table->worst_defect, table->worst_share);
    return table->worst_share <= 1 && table->unchecked == 0;
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
