#include "cli/motion_map.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

jlt_exit jlt_motion_map_open(jlt_motion_map *self, const jlt_motion_options *options, const jlt_system *system, const char *grid,
                             const jlt_grid_axis *axes)
{
    const jlt_chart *chart = system->flow.chart;
    unsigned count = 0;
    jlt_exit code;

    *self = (jlt_motion_map){ .system = system, .axes = grid != NULL ? axes : NULL, .whole = grid != NULL && strchr(grid, '=') == NULL,
                              .shown = { 0, 1 }, .values = JLT_EXTENT_NONE, .extent = { JLT_EXTENT_NONE, JLT_EXTENT_NONE } };
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
            return jlt_command_fail(JLT_EXIT_USAGE, "--plot: a map is drawn over two coordinates, %s and %s: give %s one value, or choose by --axes",
                                    chart->names[self->shown[0]], chart->names[self->shown[1]], chart->names[k]);
    for (unsigned k = 0; grid != NULL && k < 2; k++) {
        const jlt_grid_axis *axis = &axes[self->shown[k]];
        const double period = chart->period[self->shown[k]];
        if (axis->count > 1) self->cell[k] = fabs(jlt_grid_value(axis, 1, period) - jlt_grid_value(axis, 0, period));
    }
    if (self->cell[0] == 0 || self->cell[1] == 0) self->cell[0] = self->cell[1] = 0;
    self->points = open_memstream(&self->text, &self->size);
    return code != JLT_EXIT_DONE || self->points != NULL ? code : jlt_command_no_memory();
}

void jlt_motion_map_close(jlt_motion_map *self)
{
    if (self->points != NULL) fclose(self->points);
    free(self->text);
    *self = (jlt_motion_map){ .points = NULL };
}

void jlt_motion_map_add(jlt_motion_map *self, const double *q, double value)
{
    const double *periods = self->system->flow.chart->period;

    jlt_extent_add(&self->values, value);
    for (unsigned k = 0; k < 2; k++) jlt_extent_add(&self->extent[k], q[self->shown[k]]);
    for (int turn = -1; self->points != NULL && turn <= 1; turn++) {
        const double period = periods[self->shown[0]], x = q[self->shown[0]] + turn * period;
        if (turn != 0 && (period == 0 || fabs(x) - self->cell[0] / 2 > period / 2)) continue;
        for (int other = -1; other <= 1; other++) {
            const double second = periods[self->shown[1]], y = q[self->shown[1]] + other * second;
            if (other != 0 && (second == 0 || fabs(y) - self->cell[1] / 2 > second / 2)) continue;
            jlt_look_row(self->points, (const double[]){ x, y, value }, 3);
        }
    }
}

void jlt_motion_map_frame(jlt_motion_map *self, jlt_plot *plot)
{
    fflush(self->points);
    jlt_plot_block(plot, "MAP", self->text);
    for (unsigned k = 0; k < 2; k++) {
        const jlt_grid_axis *axis = self->axes != NULL ? &self->axes[self->shown[k]] : NULL;
        jlt_extent range = jlt_extent_wider(self->extent[k]);
        if (self->whole) range = JLT_MOTION_WHOLE;
        else if (self->cell[k] > 0)
            range = (jlt_extent){ fmin(axis->low, axis->high) - self->cell[k] / 2, fmax(axis->low, axis->high) + self->cell[k] / 2 };
        jlt_motion_axis(plot, self->system, k == 0 ? 'x' : 'y', self->shown[k], range);
    }
    fputs("set tics out nomirror\n", plot->stream);
}

void jlt_motion_map_palette(const jlt_motion_map *self, jlt_plot *plot, const char *label)
{
    jlt_look_palette(plot->stream, plot->look);
    fputs("set cblabel ", plot->stream);
    jlt_look_quote(plot->stream, label);
    fputc('\n', plot->stream);
    if (self->values.high > self->values.low)
        fprintf(plot->stream, "set cbtics %.15g\n", jlt_look_step(self->values, 6));
}

void jlt_motion_map_plot(const jlt_motion_map *self, jlt_plot *plot, const char *columns, const char *colour)
{
    const double *cell = self->cell;

    if (cell[0] > 0) jlt_look_cells(plot->stream, "MAP", columns, cell[0], cell[1], colour);
    else fprintf(plot->stream, "$MAP using 1:%s%s with points pt 5 ps %.3g lc %s", columns, strcmp(colour, "palette") == 0 ? ":3" : "",
                 0.7 * plot->look->size, colour);
}
