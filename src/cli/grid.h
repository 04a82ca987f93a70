/** Grids and counts as typed on the command line. */
#ifndef JLT_CLI_GRID_H
#define JLT_CLI_GRID_H

#include <stdbool.h>

#include "cli/command.h"

enum { JLT_GRID_PLACE_MAX = 512 };

typedef struct {
    char name[32];
    double low, high;
    size_t count; /* >= 1 */
    const char *low_text, *high_text; /* as typed, in the option's text; NULL: an end that no text gives */
    size_t low_length, high_length;
    size_t first, part; /* on a grid's first axis: only its points first .. first + part - 1 are wanted, counted over the whole
                           grid; part 0: all */
} jlt_grid_axis;

/** Read one axis, NAME=LOW:HIGH:COUNT, or NAME=VALUE for a single point. Values are read by jlt_grid_number. Messages of all these
 *  functions name `option`. */
jlt_exit jlt_grid_axis_parse(jlt_grid_axis *axis, const char *text, size_t length, const char *option);

/** Where the next of NAME=VALUE or NAME=LOW:HIGH:COUNT in a list begins and ends, without a word on what is wrong: *text is moved
 *  behind it; name, of this size; *low, or the value, and *high are NaN where there is no number. False: the list has ended. */
bool jlt_grid_ends(const char **text, char *name, size_t size, double *low, double *high);

/** Read a grid: axes separated by commas, or COUNTxCOUNT, which sets the counts of axes that the caller has put there. In/out:
 *  axes, shape (room,), of which *count are filled; where *count == room before, text may name only these. Behind either form
 *  @FIRST:COUNT asks for COUNT of its points alone, from number FIRST on; 0 is the first. */
jlt_exit jlt_grid_parse(jlt_grid_axis *axes, size_t *count, size_t room, const char *text, const char *option);

/* Value number `index` of an axis. Both ends belong to it, but not the high end of an axis that spans the period (0: it is no
 * angle). Where both ends are typed numbers the value is rounded once, so that 0.1:0.7:4 has 0.3. */
double jlt_grid_value(const jlt_grid_axis *axis, size_t index, double period);

/** How many points of the grid of these axes, shape (count,), are wanted. text: the grid as typed, for messages. JLT_EXIT_USAGE:
 *  they are too many to be counted, or fewer than @FIRST:COUNT asks for. */
jlt_exit jlt_grid_size(size_t *all, const jlt_grid_axis *axes, size_t count, const char *text, const char *option);

/** Refuse a grid of which @FIRST:COUNT asks for a part, for commands that take whole grids alone. */
jlt_exit jlt_grid_whole(const jlt_grid_axis *axes, const char *option);

/** Point number `index` of those wanted, on the grid of these axes, shape (count,), of which the last one runs fastest. Out:
 *  values, shape (count,). */
void jlt_grid_point(double *values, const jlt_grid_axis *axes, size_t count, size_t index);

/** Such a point in words, "k=0.1, E=2", for messages, and its values as the first fields of a row, each with a comma behind it.
 *  Out: text, shape (JLT_GRID_PLACE_MAX,). Returns its length; one beyond its shape: it was cut. */
size_t jlt_grid_place(char *text, const jlt_grid_axis *axes, size_t count, size_t index);
void jlt_grid_fields(char *text, const jlt_grid_axis *axes, size_t count, size_t index);

/** The option that gives those of the axes their values at such a point which are parameters of the model, or which are none:
 *  "--set=k=0.1" for the option "--set"; "": there are none of them. For the caller to free(); NULL: memory is out. */
char *jlt_grid_assignments(const char *option, const jlt_grid_axis *axes, size_t count, size_t index, const jlt_descriptor *model,
                           bool params);

/** Read a whole number from low to high. */
jlt_exit jlt_grid_count(size_t *value, const char *text, size_t low, size_t high, const char *option);

/** Read a finite number, decimal or a fraction, rounded once; or a multiple of pi, as 2*pi/3. */
jlt_exit jlt_grid_number(double *value, const char *text, size_t length, const char *option);

#endif
