/** The picture of a section: the points of all orbits, coloured by the orbits' fates. */
#ifndef JLT_CLI_SECTION_PICTURE_H
#define JLT_CLI_SECTION_PICTURE_H

#include "cli/motion.h"

/** All zeros are a picture that nobody asked for: adding to it and drawing it do nothing. */
typedef struct {
    FILE *stream; /* collects in `text` the points of orbits that have ended; NULL: there is no picture */
    char *text;
    size_t size;
    double (*running)[2]; /* points of the current orbit: shape (running_count,) */
    size_t running_count;
    size_t count, orbits, by_fate[JLT_FATE_COUNT]; /* points in `text`; orbits that have ended, in all and by fate */
    unsigned shown[2];       /* indices of the coordinates on the axes; if both are equal, y is plotted over the return number */
    jlt_extent extent[2];    /* of the points */
} jlt_section_picture;

/** Begin a picture where --plot asks for one, of the coordinates that --axes names. */
jlt_exit jlt_section_picture_open(jlt_section_picture *self, const jlt_motion_options *options, const jlt_system *system);
void jlt_section_picture_close(jlt_section_picture *self); /* legal when zeroed */

/** Add a point q (dim,) of the current orbit; one with NaN is left out, and so are points beyond a fixed number. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_section_picture_add(jlt_section_picture *self, const double *q);

/** End the current orbit, which gets the colour of its fate. */
void jlt_section_picture_end(jlt_section_picture *self, jlt_fate fate);

/** Draw the picture; call it once. grid: as typed, with its axes (dim,); NULL: none. returns: how many were asked for. */
jlt_exit jlt_section_picture_draw(jlt_section_picture *self, const jlt_common *common, const jlt_system *system, const char *grid,
                                  const jlt_grid_axis *axes, size_t returns);

#endif
