/** Grids and counts as typed on the command line. */
#ifndef JLT_CLI_GRID_H
#define JLT_CLI_GRID_H

#include <stdbool.h>

#include "cli/command.h"

typedef struct {
    char name[32];
    double low, high;
    size_t count; /* >= 1 */
    const char *low_text, *high_text; /* as typed, in the option's text; NULL: an end that no text gives */
    size_t low_length, high_length;
    size_t first, part; /* of a grid's first axis: points first .. first + part - 1 alone are meant; part 0: all */
} jlt_grid_axis;

/** NAME=LOW:HIGH:COUNT, or NAME=VALUE for a single point. Values are as of jlt_grid_number. */
jlt_exit jlt_grid_axis_parse(jlt_grid_axis *axis, const char *text, size_t length, const char *option);

/** Axes separated by commas into axes[0 .. *count - 1], at most `room`; or COUNTxCOUNT, which sets the counts of the axes as
 *  they stand, where *count > 0. Where *count == room, no other names are known. Behind either, @FIRST:COUNT: so many of its points
 *  alone, from number FIRST (0 is the first) on. */
jlt_exit jlt_grid_parse(jlt_grid_axis *axes, size_t *count, size_t room, const char *text, const char *option);

/* Value number `index`, rounded once where both ends are typed numbers, so that 0.1:0.7:4 has 0.3: ends included, or for a periodic axis that spans its period the high end left out. */
double jlt_grid_value(const jlt_grid_axis *axis, size_t index, double period);

/** How many points of these axes (count,) are meant. `text` is as typed, for the message where they are too many to be counted, or
 *  fewer than a part asks for. */
jlt_exit jlt_grid_size(size_t *all, const jlt_grid_axis *axes, size_t count, const char *text, const char *option);

/** For what takes a whole grid alone: says so where a part is asked for. */
jlt_exit jlt_grid_whole(const jlt_grid_axis *axes, const char *option);

/** Point number `index` of those meant, of the grid of these axes (count,), the first one slowest. values: shape (count,). */
void jlt_grid_point(double *values, const jlt_grid_axis *axes, size_t count, size_t index);

/** A whole number from low to high. */
jlt_exit jlt_grid_count(size_t *value, const char *text, size_t low, size_t high, const char *option);

/** A finite number, exact as everywhere; or a multiple of pi, 2*pi/3. */
jlt_exit jlt_grid_number(double *value, const char *text, size_t length, const char *option);

#endif
