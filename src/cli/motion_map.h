/** Maps over a grid of starts: a cell for every start, by two coordinates of the section. */
#ifndef JLT_CLI_MOTION_MAP_H
#define JLT_CLI_MOTION_MAP_H

#include "cli/motion.h"

typedef struct {
    const jlt_system *system;
    const jlt_grid_axis *axes; /* of the grid; NULL: there is none */
    bool whole;                /* it is over the whole section */
    unsigned shown[2];         /* the coordinates of the picture */
    double cell[2];            /* 0 each: single points */
    size_t count[2];           /* of cells; shape of the grid: (count[1], count[0]) */
    double *grid;              /* values, NaN where there is none; owned */
    jlt_extent frame[2];       /* of the picture */
    FILE *points;              /* starts beside the grid; NULL: there is no picture */
    char *text;
    size_t size;
    jlt_extent values, extent[2]; /* of the values, and of the starts */
} jlt_motion_map;

/** Choose what is shown. grid: as typed, with its axes; NULL: none. Says what is wrong: starts that are told apart by a third coordinate. */
jlt_exit jlt_motion_map_open(jlt_motion_map *self, const jlt_motion_options *options, const jlt_system *system, const char *grid,
                             const jlt_grid_axis *axes);
void jlt_motion_map_close(jlt_motion_map *self); /* legal when zeroed */

/** A start and its value. */
void jlt_motion_map_add(jlt_motion_map *self, const double *q, double value);

/** Data, and the axes. */
void jlt_motion_map_frame(jlt_motion_map *self, jlt_plot *plot);

/** A palette, and the box that explains it. */
void jlt_motion_map_palette(const jlt_motion_map *self, jlt_plot *plot, const char *label);

/** "plot ..." of the grid as an image, whose size does not grow with its cells, and of other starts as points, by the palette. */
void jlt_motion_map_plot(const jlt_motion_map *self, jlt_plot *plot);

#endif
