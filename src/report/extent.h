/** The smallest interval that contains given values. */
#ifndef JLT_REPORT_EXTENT_H
#define JLT_REPORT_EXTENT_H

#include <math.h>

typedef struct {
    double low, high;
} jlt_extent;

#define JLT_EXTENT_NONE ((jlt_extent){ INFINITY, -INFINITY }) /* empty: to begin with */
#define JLT_EXTENT_OPEN ((jlt_extent){ NAN, NAN })            /* unknown: gnuplot takes the range of the data */

/* Widen the interval so that it contains the value; NaN and infinities are ignored. */
void jlt_extent_add(jlt_extent *self, double value);

/** The interval for an axis: longer by a twentieth at both ends; around a single value, or values that hardly differ, an interval
 *  so wide that ticks have different labels; OPEN for an empty one. */
jlt_extent jlt_extent_wider(jlt_extent self);

#endif
