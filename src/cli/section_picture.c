#include "cli/section_picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/motion.h"

/* A picture holds so many points at most: memory does not grow with the returns. Beyond so many they are drawn as dots. */
enum { POINTS = 400000, DOTS = 60000 };

jlt_status jlt_section_picture_open(jlt_section_picture *self)
{
    *self = (jlt_section_picture){ .stream = NULL };
    self->stream = open_memstream(&self->text, &self->size);
    return self->stream != NULL ? JLT_OK : JLT_ERR_NOMEM;
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
    if (self->running_count == self->running_room) {
        const size_t room = self->running_room == 0 ? 1024 : 2 * self->running_room;
        double *grown = realloc(self->running, 2 * room * sizeof *grown);
        if (grown == NULL) return JLT_ERR_NOMEM;
        self->running = grown;
        self->running_room = room;
    }
    memcpy(self->running + 2 * self->running_count++, q, 2 * sizeof *q);
    return JLT_OK;
}

void jlt_section_picture_end(jlt_section_picture *self, jlt_fate fate)
{
    for (size_t i = 0; i < self->running_count; i++)
        fprintf(self->stream, "%.7g %.7g %d\n", self->running[2 * i], self->running[2 * i + 1], (int)fate);
    self->count += self->running_count;
    self->running_count = 0;
    self->orbits++;
    self->by_fate[fate]++;
}

/* The whole section, or a third more than the grid that was named. */
static void frame(FILE *stream, const jlt_system *system, const char *grid, const jlt_grid_axis *axes)
{
    if (grid == NULL) return;
    if (strchr(grid, '=') == NULL) {
        jlt_motion_frame(stream, system);
        return;
    }
    for (unsigned k = 0; k < 2; k++) {
        const double low = axes[k].low, high = axes[k].high, more = (high - low) / 6;
        if (more > 0) fprintf(stream, "set %crange [%.9g:%.9g]\n", k == 0 ? 'x' : 'y', low - more, high + more);
    }
}

jlt_exit jlt_section_picture_draw(jlt_section_picture *self, const jlt_common *common, const jlt_system *system, const char *grid,
                                  const jlt_grid_axis *axes, size_t returns)
{
    static const struct {
        const char *name, *colour;
    } looks[] = { { "alive", "#202060" }, { "end at pole +1", "#e07050" }, { "end at pole -1", "#30a0c0" },
                  { "lost contact", "#c0a000" }, { "come to rest", "#40a040" }, { "left the domain", "#a060c0" },
                  { "out of budget", "#909090" }, { "not finite", "#c0c0c0" }, { "not converged", "#c0c0c0" },
                  { "without progress", "#c0c0c0" } };
    jlt_command_output script;
    bool first = true;
    FILE *stream;

    if (fflush(self->stream) != 0 || jlt_command_open(&script) != JLT_OK) return jlt_command_no_memory();
    stream = script.stream;
    fputs("set encoding utf8\n$POINTS << END\n", stream);
    fputs(self->text, stream);
    fputs("END\nset title \"Poincaré map on the section, ", stream);
    jlt_motion_caption(stream, system, NULL);
    fprintf(stream, "\\n%zu orbits of up to %zu returns\" noenhanced\n", self->orbits, returns);
    jlt_motion_labels(stream, system);
    frame(stream, system, grid, axes);
    fputs("set key tmargin center horizontal textcolor variable\nplot ", stream);
    for (int fate = JLT_FATE_COUNT - 1; fate >= (int)JLT_FATE_ALIVE; fate--) {
        if (self->by_fate[fate] == 0) continue;
        fprintf(stream, "%s$POINTS using 1:($3==%d?$2:NaN) with %s lc rgb '%s' title \"%zu %s\" noenhanced", first ? "" : ", ",
                fate, self->count > DOTS ? "dots" : "points pt 7 ps 0.25", looks[fate].colour, self->by_fate[fate],
                looks[fate].name);
        first = false;
    }
    fputs("\n", stream);
    return jlt_common_draw(common, &script);
}
