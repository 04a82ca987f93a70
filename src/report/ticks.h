/** Ticks of axes: where they are, and labels of which no two are equal. */
#ifndef JLT_REPORT_TICKS_H
#define JLT_REPORT_TICKS_H

#include "report/extent.h"

#include <stdbool.h>
#include <stdio.h>

typedef struct {
    double step;       /* ticks lie at its multiples */
    int power;         /* labels count in powers of ten: 10^power, which the label of the axis tells; 0: as they are */
    unsigned decimals; /* of a label */
    double letters;    /* in the longest label */
} jlt_ticks;

/** Choose about `room` ticks or fewer, and at least two if the range is not empty; where labels become long, fewer. across: labels
 *  stand beside each other, and room is that of labels of at most four letters. */
jlt_ticks jlt_ticks_choose(jlt_extent range, double room, bool across);

/** Write the ticks of the axis "x", "y" or "cb"; labelled: with their numbers. _list: one by one, as logarithmic axes need them. */
void jlt_ticks_list(FILE *stream, const char *axis, jlt_extent range, const jlt_ticks *ticks, bool labelled);
void jlt_ticks_write(FILE *stream, const char *axis, jlt_extent range, const jlt_ticks *ticks, bool labelled);

/** Write ticks at multiples of pi/2, or, if these do not fit, of the least multiple of pi that does. */
void jlt_ticks_angle(FILE *stream, const char *axis, jlt_extent range, double room);

/** Write ticks of a logarithmic axis at powers of ten, about `room` of them or fewer. widen: make the range longer first, up to
 *  powers of ten. */
void jlt_ticks_decades(FILE *stream, const char *axis, jlt_extent *range, double room, bool widen);

#endif
