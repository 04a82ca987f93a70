/** The lines on which `jellett orbits` looks for symmetric orbits: their points are their own mirror images. */
#ifndef JLT_CLI_ORBIT_LINES_H
#define JLT_CLI_ORBIT_LINES_H

#include "cli/grid.h"
#include "dynamics/symmetric.h"
#include "dynamics/system.h"

/** The lines of fixed points of the reversor, on a section that tables describe: the angle that it flips is 0 or half a period, and
 *  the first coordinate with a known interval runs. In/out: lines, zeroed but for `free`. Returns their number, 0 or 2. */
size_t jlt_orbit_lines_whole(jlt_symmetric_line lines[2], const jlt_system *system, size_t samples);

/** The same on a section of two coordinates, of which the reversor flips one; the other one runs over its range of the grid,
 *  axes of shape (chart->dim,). Returns their number, 0 to 2. */
size_t jlt_orbit_lines_of_grid(jlt_symmetric_line lines[2], const jlt_chart *chart, const jlt_grid_axis *axes, size_t samples);

/** Refuse a line whose points are not their own mirror images, naming --line. */
jlt_exit jlt_orbit_lines_check(const jlt_symmetric_line *line, const jlt_chart *chart);

#endif
