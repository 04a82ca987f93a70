/** Where a section that tables describe has points, found by looking: in 4096 places of the coordinates that are no angles. */
#ifndef JLT_DYNAMICS_SECTION_POINTS_H
#define JLT_DYNAMICS_SECTION_POINTS_H

#include "dynamics/chart_section.h"

/** Whether a point was found. Cost: few looks where a good part of the places has points, else all of them. */
bool jlt_section_points_any(const jlt_chart_section *chart);

/** Whether there is none: of a section with a coordinate without bounds nothing is said. */
bool jlt_section_points_none(const jlt_chart_section *chart);

/** Where there are points in a coordinate, whatever the others: refined by bisection; the widest interval where there are several.
 *  False: the coordinate is an angle, or not bounded; or there are none. */
bool jlt_section_points_interval(const jlt_chart_section *chart, unsigned coordinate, double *low, double *high);

#endif
