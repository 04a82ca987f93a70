/** The picture of a section: the points of all orbits, coloured by the orbits' fates. */
#ifndef JLT_CLI_SECTION_PICTURE_H
#define JLT_CLI_SECTION_PICTURE_H

#include "cli/motion.h"
#include "core/random.h"

typedef struct {
    double at[2];  /* on the axes */
    uint64_t bits; /* random: decides which share of the points it belongs to */
    jlt_fate fate; /* of its orbit, once that has ended */
} jlt_section_dot;

/** All zeros are a picture that nobody asked for: adding to it and drawing it do nothing. */
typedef struct {
    jlt_section_dot *points; /* shape (count,); NULL: there is no picture */
    size_t count, ended;     /* those before `ended` are of orbits that have ended */
    size_t number;           /* points of the current orbit, drawn or not */
    unsigned halvings;       /* one in 2^halvings points is drawn, at random, so that memory has a bound */
    jlt_random random;
    size_t orbits, by_fate[JLT_FATE_COUNT]; /* that have ended, in all and by fate */
    unsigned shown[2];       /* indices of the coordinates on the axes; if both are equal, y is plotted over the return number */
    jlt_extent extent[2];    /* of the points, drawn or not */
} jlt_section_picture;

/** Begin a picture where --plot asks for one, of the coordinates that --axes names. */
jlt_exit jlt_section_picture_open(jlt_section_picture *self, const jlt_motion_options *options, const jlt_system *system);
void jlt_section_picture_close(jlt_section_picture *self); /* legal when zeroed */

/** Add a point q (dim,) of the current orbit; one with NaN is left out. */
void jlt_section_picture_add(jlt_section_picture *self, const double *q);

/** End the current orbit, which gets the colour of its fate. */
void jlt_section_picture_end(jlt_section_picture *self, jlt_fate fate);

/** Draw the picture; call it once. grid: as typed, with its axes (dim,); NULL: none. returns: how many were asked for;
 *  time_direction: -1 if orbits are followed backwards. */
jlt_exit jlt_section_picture_draw(jlt_section_picture *self, const jlt_common *common, const jlt_system *system, const char *grid,
                                  const jlt_grid_axis *axes, size_t returns, int time_direction);

#endif
