#include "cli/section_picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"

/* POINTS bounds the points of a picture, so that memory does not grow with the returns; more than DOTS points are drawn as dots. */
enum { POINTS = 400000, DOTS = 60000 };

jlt_exit jlt_section_picture_open(jlt_section_picture *self, const jlt_motion_options *options, const jlt_system *system)
{
    *self = (jlt_section_picture){ .extent = { JLT_EXTENT_NONE, JLT_EXTENT_NONE } };
    JLT_PASS(jlt_motion_shown(self->shown, options, system));
    self->stream = open_memstream(&self->text, &self->size);
    return self->stream != NULL ? JLT_EXIT_DONE : jlt_command_no_memory();
}

void jlt_section_picture_close(jlt_section_picture *self)
{
    if (self->stream != NULL) fclose(self->stream);
    free(self->text);
    free(self->running);
    *self = (jlt_section_picture){ .stream = NULL };
}

jlt_status jlt_section_picture_add(jlt_section_picture *self, const double *q)
{
    if (self->stream == NULL || isnan(q[0]) || self->count + self->running_count == POINTS) return JLT_OK;
    if (!JLT_MEMORY_GROW(self->running, self->running_count)) return JLT_ERR_NOMEM;
    for (unsigned k = 0; k < 2; k++) {
        const double value = k == 0 && self->shown[0] == self->shown[1] ? (double)self->running_count : q[self->shown[k]];
        self->running[self->running_count][k] = value;
        jlt_extent_add(&self->extent[k], value);
    }
    self->running_count++;
    return JLT_OK;
}

void jlt_section_picture_end(jlt_section_picture *self, jlt_fate fate)
{
    for (size_t i = 0; i < self->running_count; i++)
        jlt_look_row(self->stream, (const double[]){ self->running[i][0], self->running[i][1], (double)fate }, 3);
    self->count += self->running_count;
    self->running_count = 0;
    self->orbits++;
    self->by_fate[fate]++;
}

/* Write the axes: over the whole section; over the ranges named in --grid and a third more; or over what the points cover. */
static void frame(jlt_plot *plot, const jlt_section_picture *self, const jlt_system *system, const char *grid,
                  const jlt_grid_axis *axes)
{
    for (unsigned k = 0; k < 2; k++) {
        const unsigned c = self->shown[k];
        jlt_extent range = jlt_extent_wider(self->extent[k]);
        if (self->count == 0 || (grid != NULL && strchr(grid, '=') == NULL)) range = JLT_MOTION_WHOLE;
        else if (grid != NULL && jlt_motion_framed(system, c) && axes[c].high > axes[c].low) {
            const double more = (axes[c].high - axes[c].low) / 6;
            range = (jlt_extent){ axes[c].low - more, axes[c].high + more };
        }
        if (k == 0 && c == self->shown[1]) jlt_plot_axis(plot, 'x', "return", JLT_EXTENT_OPEN, 0);
        else jlt_motion_axis(plot, system, k == 0 ? 'x' : 'y', c, range);
    }
}

jlt_exit jlt_section_picture_draw(jlt_section_picture *self, const jlt_common *common, const jlt_system *system, const char *grid,
                                  const jlt_grid_axis *axes, size_t returns)
{
    static const struct {
        const char *name;
        unsigned colour;
    } looks[] = { { "alive", 0 }, { "pole+", 1 }, { "pole-", 6 }, { "lost contact", 3 }, { "come to rest", 4 },
                  { "left the domain", 5 }, { "out of budget", 7 }, { "not finite", 8 }, { "not converged", 8 },
                  { "without progress", 8 } };
    jlt_plot plot;
    bool first = true;
    FILE *stream;

    if (fflush(self->stream) != 0 || jlt_plot_open(&plot, common) != JLT_OK) return jlt_command_no_memory();
    stream = plot.stream;
    jlt_plot_block(&plot, "POINTS", self->text);
    jlt_plot_words(&plot, "Poincaré map: %zu orbit%s of up to %zu return%s\n", self->orbits, self->orbits == 1 ? "" : "s", returns,
                   returns == 1 ? "" : "s");
    jlt_motion_caption(&plot, system, NULL);
    frame(&plot, self, system, grid, axes);
    fputs("plot ", stream);
    for (int fate = JLT_FATE_COUNT - 1; fate >= (int)JLT_FATE_ALIVE; fate--) {
        if (self->by_fate[fate] == 0) continue;
        fprintf(stream, "%s$POINTS using 1:($3==%d?$2:NaN) ", first ? "" : ", ", fate);
        if (self->count > DOTS) fprintf(stream, "with dots lc rgb '%s'", jlt_look_colour(plot.look, looks[fate].colour));
        else jlt_look_pen(stream, plot.look, (jlt_pen){ "points", .colour = looks[fate].colour, .size = 0.2 });
        fprintf(stream, " notitle, keyentry with points pt 7 ps 0.8 lc rgb '%s' title '%zu %s'",
                jlt_look_colour(plot.look, looks[fate].colour), self->by_fate[fate], looks[fate].name);
        first = false;
    }
    if (first) fputs("NaN notitle", stream);
    fputs("\n", stream);
    return jlt_plot_draw(&plot);
}
