/** Pictures over two coordinates of the section in which every start of a grid is a cell, coloured by a value. */
#ifndef JLT_CLI_MOTION_MAP_H
#define JLT_CLI_MOTION_MAP_H

#include "cli/motion.h"

typedef struct {
    const jlt_system *system;
    const jlt_grid_axis *axes; /* of the grid, (dim,); NULL: there is none */
    bool whole;                /* the grid covers the whole section */
    unsigned shown[2];         /* numbers of the coordinates on the x and y axis */
    double cell[2];            /* width and height of a cell; 0 each: starts are points */
    size_t count[2];           /* of cells; shape of the grid: (count[1], count[0]) */
    double *grid;              /* values, NaN where there is none; owned */
    jlt_extent frame[2];       /* of the picture */
    FILE *points;              /* takes starts that are not points of the grid; NULL: there is no picture */
    char *text;                /* what was written to `points`, `size` bytes */
    size_t size;
    jlt_extent values, extent[2]; /* ranges of the values and of the starts' coordinates */
} jlt_motion_map;

/** Choose the coordinates to show. grid: as typed, with its axes, shape (dim,); NULL: none. JLT_EXIT_INPUT: the section has only
 *  one coordinate, or starts of the grid differ in a third coordinate, which the picture cannot show. */
jlt_exit jlt_motion_map_open(jlt_motion_map *self, const jlt_motion_options *options, const jlt_system *system, const char *grid,
                             const jlt_grid_axis *axes);
void jlt_motion_map_close(jlt_motion_map *self); /* legal when zeroed */

/** Add a start, q (dim,), and its value. */
void jlt_motion_map_add(jlt_motion_map *self, const double *q, double value);

/** Write the data and the axes into the script. */
void jlt_motion_map_frame(jlt_motion_map *self, jlt_plot *plot);

/** Write a palette for the values, and the colour box with this label; before the frame. */
void jlt_motion_map_palette(const jlt_motion_map *self, jlt_plot *plot, const char *label);

/** Write "plot ...": the grid as an image, whose size in bytes does not grow with its cells, and other starts as points. */
void jlt_motion_map_plot(const jlt_motion_map *self, jlt_plot *plot);

/** Behind it: say in the key how many cells have no value, and what that means, formatted as by printf; nothing if all have one. */
JLT_PRINTF(3, 4) void jlt_motion_map_blank(const jlt_motion_map *self, jlt_plot *plot, const char *meaning, ...);

#endif
