/** Reads grids, counts and numbers as typed on the command line. */
#ifndef JLT_CLI_GRID_H
#define JLT_CLI_GRID_H

#include <stdbool.h>

#include "cli/command.h"

enum { JLT_GRID_PLACE_MAX = 512 };

typedef struct {
    char name[64]; /* a table's names have up to 63 characters */
    double low, high;
    size_t count; /* >= 1 */
    const char *low_text, *high_text; /* as typed, pointing into the option's text; NULL: the end was not typed */
    size_t low_length, high_length;
    size_t first, part; /* on a grid's first axis: of the whole grid only points number first .. first + part - 1 are wanted; part
                           0: all points */
} jlt_grid_axis;

/** Read one axis, NAME=LOW:HIGH:COUNT, or NAME=VALUE for a single point. Values are read by jlt_grid_number. Messages of all these
 *  functions name `option`. */
jlt_exit jlt_grid_axis_parse(jlt_grid_axis *axis, const char *text, size_t length, const char *option);

/** Read the next item of a list of NAME=VALUE or NAME=LOW:HIGH:COUNT, without messages. *text is moved behind it. Out: name, shape
 *  (size,); *low, also for a VALUE, and *high, NaN where the text has no number. Returns false at the end of the list. */
bool jlt_grid_ends(const char **text, char *name, size_t size, double *low, double *high);

/** Read a grid: axes separated by commas, or COUNTxCOUNT, which sets the counts of axes that the caller has filled in. In/out:
 *  axes, shape (room,), of which *count are filled; if *count == room before the call, text may name only these. A suffix
 *  @FIRST:COUNT asks for COUNT points of the grid, from number FIRST on, counted from 0. */
jlt_exit jlt_grid_parse(jlt_grid_axis *axes, size_t *count, size_t room, const char *text, const char *option);

/** The same, whatever its axes are. In/out: axes, shape (room,), whose names and ends are kept where text has none. */
jlt_exit jlt_grid_read(jlt_grid_axis *axes, size_t *count, size_t room, const char *text, const char *option);

/* Value number `index` of an axis, which includes both ends, except the high end of an axis that spans the whole period (0: not an
 * angle). If both ends were typed, the exact value is rounded once, so that 0.1:0.7:4 contains 0.3. */
double jlt_grid_value(const jlt_grid_axis *axis, size_t index, double period);

/** How many points of the grid of these axes, shape (count,), are wanted. text: the grid as typed, for messages. JLT_EXIT_INPUT:
 *  these are more than 10^12, the number overflows, or @FIRST:COUNT asks for points beyond the last. */
jlt_exit jlt_grid_size(size_t *all, const jlt_grid_axis *axes, size_t count, const char *text, const char *option);

/** Refuse a part of a grid, @FIRST:COUNT, for commands that take whole grids only. */
jlt_exit jlt_grid_whole(const jlt_grid_axis *axes, const char *option);

/** Point number `index` among the wanted points of the grid of these axes, shape (count,); the last axis runs fastest. Out: values,
 *  shape (count,). */
void jlt_grid_point(double *values, const jlt_grid_axis *axes, size_t count, size_t index);

/** Such a point in words, "k=0.1, E=2", for messages, and its values as the first fields of a row, each with a comma behind it.
 *  Out: text, shape (JLT_GRID_PLACE_MAX,). Returns its length; one beyond its shape: it was cut. */
size_t jlt_grid_place(char *text, const jlt_grid_axis *axes, size_t count, size_t index);
void jlt_grid_fields(char *text, const jlt_grid_axis *axes, size_t count, size_t index);

/** The option that sets the values of axes at such a point, "--set=k=0.1" for the option "--set": of the axes that are parameters
 *  of the model if `params`, else of the others; "" if there are none. For the caller to free(); NULL: memory is out. */
char *jlt_grid_assignments(const char *option, const jlt_grid_axis *axes, size_t count, size_t index, const jlt_descriptor *model,
                           bool params);

/** Read a whole number from low to high. */
jlt_exit jlt_grid_count(size_t *value, const char *text, size_t low, size_t high, const char *option);

/** Read a finite number: a decimal or a fraction, correctly rounded, or a rational multiple of pi such as 2*pi/3. */
jlt_exit jlt_grid_number(double *value, const char *text, size_t length, const char *option);

/** Say what is wrong with such a number, if reading it gave any status but JLT_OK. */
jlt_exit jlt_grid_judge(jlt_status parsed, const char *text, size_t length, const char *option);

#endif
