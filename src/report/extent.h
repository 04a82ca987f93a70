/** The interval that values fill. */
#ifndef JLT_REPORT_EXTENT_H
#define JLT_REPORT_EXTENT_H

#include <math.h>

typedef struct {
    double low, high;
} jlt_extent;

#define JLT_EXTENT_NONE ((jlt_extent){ INFINITY, -INFINITY })
#define JLT_EXTENT_OPEN ((jlt_extent){ NAN, NAN }) /* as far as the data go */

/* Widen the interval so that it holds the value; NaN and infinities are passed over. */
void jlt_extent_add(jlt_extent *self, double value);

/** The interval with a twentieth more on both sides, for an axis; some interval around a single value; OPEN where there is no
 *  value. */
jlt_extent jlt_extent_wider(jlt_extent self);

#endif
