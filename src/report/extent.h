/** From where to where values go. */
#ifndef JLT_REPORT_EXTENT_H
#define JLT_REPORT_EXTENT_H

#include <math.h>

typedef struct {
    double low, high;
} jlt_extent;

#define JLT_EXTENT_NONE ((jlt_extent){ INFINITY, -INFINITY })
#define JLT_EXTENT_OPEN ((jlt_extent){ NAN, NAN }) /* as far as the data go */

/* A value more; NaN and infinity are none. */
void jlt_extent_add(jlt_extent *self, double value);

/** A twentieth more on both sides, and something around a single value; OPEN where there is none. */
jlt_extent jlt_extent_wider(jlt_extent self);

#endif
