#include "cli/section_picture.h"

#include "base/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* POINTS bounds the points of a picture, so that memory does not grow with the returns; more than DOTS points are drawn as dots,
 * unless --style says how large they are. */
enum { POINTS = 400000, DOTS = 60000 };

jlt_exit jlt_section_picture_open(jlt_section_picture *self, const jlt_motion_options *options, const jlt_system *system)
{
    *self = (jlt_section_picture){ .extent = { JLT_EXTENT_NONE, JLT_EXTENT_NONE } };
    jlt_random_seed(&self->random, 1);
    JLT_PASS(jlt_motion_shown(self->shown, options, system));
    self->points = malloc(POINTS * sizeof *self->points);
    return self->points != NULL ? JLT_EXIT_DONE : jlt_command_no_memory();
}

void jlt_section_picture_close(jlt_section_picture *self)
{
    free(self->points);
    *self = (jlt_section_picture){ .points = NULL };
}

/* Whether a point with these random bits belongs to the share that is drawn. */
static bool is_drawn(const jlt_section_picture *self, uint64_t bits)
{
    return bits <= UINT64_MAX >> self->halvings;
}

/* Draw half of the share of points that was drawn so far. */
static void halve(jlt_section_picture *self)
{
    size_t kept = 0, ended = 0;

    self->halvings++;
    for (size_t i = 0; i < self->count; i++) {
        if (i == self->ended) ended = kept;
        if (is_drawn(self, self->points[i].bits)) self->points[kept++] = self->points[i];
    }
    self->ended = self->ended == self->count ? kept : ended;
    self->count = kept;
}

void jlt_section_picture_add(jlt_section_picture *self, const double *q)
{
    const uint64_t bits = jlt_random_bits(&self->random);
    jlt_section_dot point = { .bits = bits };

    if (self->points == NULL || isnan(q[0])) return;
    for (unsigned k = 0; k < 2; k++) {
        point.at[k] = k == 0 && self->shown[0] == self->shown[1] ? (double)self->number : q[self->shown[k]];
        jlt_extent_add(&self->extent[k], point.at[k]);
    }
    self->number++;
    if (!is_drawn(self, bits)) return;
    while (self->count == POINTS) halve(self);
    if (is_drawn(self, bits)) self->points[self->count++] = point;
}

void jlt_section_picture_end(jlt_section_picture *self, jlt_fate fate)
{
    for (; self->ended < self->count; self->ended++) self->points[self->ended].fate = fate;
    self->number = 0;
    self->orbits++;
    self->by_fate[fate]++;
}

/* The range of a coordinate that --grid names, and a third more; OPEN: there is none. */
static jlt_extent framed(const jlt_system *system, unsigned coordinate, const char *grid, const jlt_grid_axis *axes)
{
    const jlt_grid_axis *named = &axes[coordinate];

    if (grid == NULL || !jlt_motion_framed(system, coordinate) || !(named->high > named->low)) return JLT_EXTENT_OPEN;
    const double more = (named->high - named->low) / 6;
    return (jlt_extent){ named->low - more, named->high + more };
}

/* Whether at least one in a hundred points lies within ranges (2,), of which those that are OPEN hold all. */
static bool holds_some(const jlt_section_picture *self, const jlt_extent *ranges)
{
    size_t outside = 0, count = self->count;

    for (size_t i = 0; i < count; i++) {
        const double *at = self->points[i].at;
        outside += at[0] < ranges[0].low || at[0] > ranges[0].high || at[1] < ranges[1].low || at[1] > ranges[1].high;
    }
    return count - outside >= (count + 99) / 100;
}

/* Write the axes: over the whole section; over the ranges named in --grid and a third more, if points lie there; or over what the
 * points cover. */
static void frame(jlt_plot *plot, const jlt_section_picture *self, const jlt_system *system, const char *grid,
                  const jlt_grid_axis *axes)
{
    const jlt_extent named[2] = { framed(system, self->shown[0], grid, axes), framed(system, self->shown[1], grid, axes) };
    const bool whole = self->count == 0 || (grid != NULL && strchr(grid, '=') == NULL), in_frame = holds_some(self, named);

    for (unsigned k = 0; k < 2; k++) {
        const bool by_name = in_frame && !isnan(named[k].low);
        const jlt_extent range = whole ? JLT_MOTION_WHOLE : by_name ? named[k] : jlt_extent_wider(self->extent[k]);
        if (k == 0 && self->shown[0] == self->shown[1]) jlt_plot_axis(plot, 'x', "return", JLT_EXTENT_OPEN, 0);
        else jlt_motion_axis(plot, system, k == 0 ? 'x' : 'y', self->shown[k], range);
    }
}

jlt_exit jlt_section_picture_draw(jlt_section_picture *self, const jlt_common *common, const jlt_system *system, const char *grid,
                                  const jlt_grid_axis *axes, size_t returns, int time_direction)
{
    static const struct {
        const char *name;
        unsigned colour;
    } looks[] = { { "alive", 0 }, { "pole+", 1 }, { "pole-", 6 }, { "lost contact", 3 }, { "come to rest", 4 },
                  { "left the domain", 5 }, { "out of budget", 7 }, { "not finite", 8 }, { "not converged", 8 },
                  { "without progress", 8 } };
    const double size = fmin(0.5, fmax(0.2, 8/sqrt((double)self->count + 1))); /* few points are larger */
    jlt_plot plot;
    bool first = true;
    FILE *stream;

    if (jlt_plot_open(&plot, common) != JLT_OK) return jlt_command_no_memory();
    stream = plot.stream;
    fputs("$POINTS << END\n", stream);
    for (size_t i = 0; i < self->count; i++) {
        const jlt_section_dot *point = &self->points[i];
        jlt_look_row(stream, (const double[]){ point->at[0], point->at[1], (double)point->fate }, 3);
    }
    fputs("END\n", stream);
    jlt_plot_words(&plot, "Poincaré map: %zu orbit%s of up to %zu return%s%s", self->orbits, ttc_text_plural(self->orbits),
                   returns, ttc_text_plural(returns), time_direction < 0 ? " backwards" : "");
    if (self->halvings > 0) jlt_plot_words(&plot, ", one in %llu drawn", 1ULL << self->halvings);
    jlt_plot_words(&plot, "\n");
    jlt_motion_caption(&plot, system, NULL);
    frame(&plot, self, system, grid, axes);
    fputs("plot ", stream);
    for (int fate = JLT_FATE_COUNT - 1; fate >= (int)JLT_FATE_ALIVE; fate--) {
        if (self->by_fate[fate] == 0) continue;
        fprintf(stream, "%s$POINTS using 1:($3==%d?$2:NaN) ", first ? "" : ", ", fate);
        if (self->count > DOTS && common->look.size == 1)
            fprintf(stream, "with dots lc rgb '%s'", jlt_look_colour(plot.look, looks[fate].colour));
        else jlt_look_pen(stream, plot.look, (jlt_pen){ "points", .colour = looks[fate].colour, .size = size });
        fprintf(stream, " notitle, keyentry with points pt 7 ps 0.8 lc rgb '%s' title '%zu %s'",
                jlt_look_colour(plot.look, looks[fate].colour), self->by_fate[fate], looks[fate].name);
        first = false;
    }
    if (first) fputs("NaN notitle", stream);
    fputs("\n", stream);
    return jlt_plot_draw(&plot);
}
