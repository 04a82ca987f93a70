#include "cli/motion_map.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"

jlt_exit jlt_motion_map_open(jlt_motion_map *self, const jlt_motion_options *options, const jlt_system *system, const char *grid,
                             const jlt_grid_axis *axes)
{
    const jlt_chart *chart = system->flow.chart;
    unsigned count = 0;
    jlt_exit code;

    *self = (jlt_motion_map){ .system = system, .axes = grid != NULL ? axes : NULL,
                              .whole = grid != NULL && strchr(grid, '=') == NULL, .shown = { 0, 1 },
                              .values = JLT_EXTENT_NONE, .extent = { JLT_EXTENT_NONE, JLT_EXTENT_NONE } };
    if (options->common.plot == NULL) return JLT_EXIT_DONE;
    if (chart->dim < 2)
        return jlt_command_fail(JLT_EXIT_INPUT, "--plot: a map is drawn over two coordinates, and the section has one");
    for (unsigned k = 0; grid != NULL && k < chart->dim && count < 2; k++)
        if (axes[k].count > 1) self->shown[count++] = k;
    if (count == 1) self->shown[1] = self->shown[0] == 0;
    if (self->shown[0] > self->shown[1]) self->shown[0] = 0, self->shown[1] = 1;
    code = jlt_plot_shown(self->shown, &options->common, chart->names, chart->dim);
    for (unsigned k = 0; code == JLT_EXIT_DONE && grid != NULL && k < chart->dim; k++)
        if (axes[k].count > 1 && k != self->shown[0] && k != self->shown[1])
            return jlt_command_fail(
                JLT_EXIT_USAGE, "--plot: a map is drawn over two coordinates, %s and %s: give %s one value, or choose by --axes",
                chart->names[self->shown[0]], chart->names[self->shown[1]], chart->names[k]);
    for (unsigned k = 0; grid != NULL && k < 2; k++) {
        const jlt_grid_axis *axis = &axes[self->shown[k]];
        const double period = chart->period[self->shown[k]];
        if (axis->count > 1) self->cell[k] = fabs(jlt_grid_value(axis, 1, period) - jlt_grid_value(axis, 0, period));
    }
    if (self->cell[0] == 0 || self->cell[1] == 0) self->cell[0] = self->cell[1] = 0;
    for (unsigned k = 0; self->cell[0] > 0 && k < 2; k++) self->count[k] = axes[self->shown[k]].count;
    const size_t cells = self->count[0] * self->count[1];
    self->grid = jlt_memory_array(cells, sizeof *self->grid);
    for (size_t i = 0; self->grid != NULL && i < cells; i++) self->grid[i] = NAN;
    self->points = open_memstream(&self->text, &self->size);
    return code != JLT_EXIT_DONE || (self->points != NULL && self->grid != NULL) ? code : jlt_command_no_memory();
}

void jlt_motion_map_close(jlt_motion_map *self)
{
    if (self->points != NULL) fclose(self->points);
    free(self->text);
    free(self->grid);
    *self = (jlt_motion_map){ .points = NULL };
}

/* The index of a value on axis k of the picture's grid. Returns false if the value is not on the grid. */
static bool place(size_t *index, const jlt_motion_map *self, unsigned k, double value)
{
    const jlt_grid_axis *axis = &self->axes[self->shown[k]];
    const double step = copysign(self->cell[k], axis->high - axis->low), steps = (value - axis->low) / step;

    *index = (size_t)fmax(0, round(steps));
    return fabs(steps - round(steps)) < 1e-6 && *index < self->count[k];
}

void jlt_motion_map_add(jlt_motion_map *self, const double *q, double value)
{
    const double at[] = { q[self->shown[0]], q[self->shown[1]], value };
    size_t column, row;

    jlt_extent_add(&self->values, value);
    for (unsigned k = 0; k < 2; k++) jlt_extent_add(&self->extent[k], at[k]);
    if (self->points == NULL) return;
    if (self->cell[0] > 0 && place(&column, self, 0, at[0]) && place(&row, self, 1, at[1]))
        self->grid[row * self->count[0] + column] = value;
    else jlt_look_row(self->points, at, 3);
}

/* The range over which cells are drawn, and the number of image pixels for it: some hundreds, since viewers of SVG blur the edges
 * of pixels; and an even number for each cell, since the ends of an angle's range cut a cell into halves. */
static jlt_extent dots(unsigned *count, const jlt_motion_map *self, unsigned k, jlt_extent range)
{
    const jlt_grid_axis *axis = &self->axes[self->shown[k]];
    const bool turns = self->system->flow.chart->period[self->shown[k]] != 0;
    const double low = fmin(axis->low, axis->high) - self->cell[k] / 2, high = fmax(axis->low, axis->high) + self->cell[k] / 2;

    if (!turns) range = (jlt_extent){ fmax(range.low, low), fmin(range.high, high) };
    const double cells = fmax(1, round((range.high - range.low) / self->cell[k]));
    *count = (unsigned)(2 * cells * fmax(1, ceil(200 / cells)));
    return range;
}

/* Define the gnuplot function CELL_x(x) or CELL_y(y), the index of the cell at a coordinate. */
static void write_place(FILE *stream, const jlt_motion_map *self, unsigned k)
{
    const jlt_grid_axis *axis = &self->axes[self->shown[k]];
    const double period = self->system->flow.chart->period[self->shown[k]], low = fmin(axis->low, axis->high) - self->cell[k] / 2;
    const char name = k == 0 ? 'x' : 'y';

    fprintf(stream, "CELL_%c(%c) = floor((%c", name, name, name);
    if (period != 0) fprintf(stream, " - %.17g*floor((%c - %.17g)/%.17g)", period, name, low, period);
    fprintf(stream, " - %.17g)/%.17g + 0.5)\n", axis->low, copysign(self->cell[k], axis->high - axis->low));
}

/* Write the grid as a gnuplot array, and functions that give its value at any point. */
static void write_grid(FILE *stream, const jlt_motion_map *self)
{
    const size_t cells = self->count[0] * self->count[1];

    fputs("$GRID << END\n", stream);
    for (size_t i = 0; i < cells; i++) jlt_look_row(stream, &self->grid[i], 1);
    fprintf(stream, "END\narray GRID[%zu]\nstats $GRID using (GRID[1+int($0)]=$1, 0) nooutput\n", cells);
    for (unsigned k = 0; k < 2; k++) write_place(stream, self, k);
    fprintf(stream, "VALUE(i,j) = i < 0 || i >= %zu || j < 0 || j >= %zu ? NaN : GRID[1 + int(i) + %zu*int(j)]\n", self->count[0],
            self->count[1], self->count[0]);
}

void jlt_motion_map_frame(jlt_motion_map *self, jlt_plot *plot)
{
    fflush(self->points);
    if (self->size > 0) jlt_plot_block(plot, "STARTS", self->text);
    if (self->cell[0] > 0) write_grid(plot->stream, self);
    for (unsigned k = 0; k < 2; k++) {
        const jlt_grid_axis *axis = self->axes != NULL ? &self->axes[self->shown[k]] : NULL;
        jlt_extent range = jlt_extent_wider(self->extent[k]);
        if (self->whole) range = JLT_MOTION_WHOLE;
        else if (self->cell[k] > 0)
            range = (jlt_extent){ fmin(axis->low, axis->high) - self->cell[k] / 2,
                                  fmax(axis->low, axis->high) + self->cell[k] / 2 };
        self->frame[k] = jlt_motion_axis(plot, self->system, k == 0 ? 'x' : 'y', self->shown[k], range);
    }
    fputs("set tics out nomirror\n", plot->stream);
}

void jlt_motion_map_palette(const jlt_motion_map *self, jlt_plot *plot, const char *label)
{
    jlt_plot_palette(plot, label, self->values);
}

void jlt_motion_map_plot(const jlt_motion_map *self, jlt_plot *plot)
{
    jlt_extent range[2];
    unsigned count[2];
    double half[2];

    fputs("plot ", plot->stream);
    for (unsigned k = 0; self->cell[0] > 0 && k < 2; k++) {
        range[k] = dots(&count[k], self, k, self->frame[k]);
        half[k] = (range[k].high - range[k].low) / count[k] / 2;
    }
    const bool image = self->cell[0] > 0 && half[0] > 0 && half[1] > 0;
    for (unsigned k = 0; image && k < 2; k++)
        fprintf(plot->stream, "%s [%c=%.17g:%.17g:%.17g]", k == 0 ? "sample" : "", k == 0 ? 'u' : 'v', range[k].low + half[k],
                range[k].high - half[k], 2 * half[k]);
    fputs(image ? " '++' using 1:2:(VALUE(CELL_x($1),CELL_y($2))) with image notitle" : "NaN notitle", plot->stream);
    if (self->size > 0)
        fprintf(plot->stream, ", $STARTS using 1:2:3 with points pt 5 ps %.3g lc palette notitle", 0.7 * plot->look->size);
}

void jlt_motion_map_blank(const jlt_motion_map *self, jlt_plot *plot, const char *meaning, ...)
{
    size_t blank = 0;
    va_list arguments;

    for (size_t i = 0; i < self->count[0] * self->count[1]; i++) blank += isnan(self->grid[i]) ? 1 : 0;
    if (blank == 0) return;
    fprintf(plot->stream, ", keyentry with boxes fill solid border rgb '#808080' fillcolor rgb 'white' title '%zu ", blank);
    va_start(arguments, meaning);
    vfprintf(plot->stream, meaning, arguments);
    va_end(arguments);
    fputc('\'', plot->stream);
}
