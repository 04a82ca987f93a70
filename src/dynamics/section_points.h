/** Where a section that tables describe has points: the grid of jlt_chart_section_points is tried, 4096 combinations of the
 *  coordinates that are no angles. */
#ifndef JLT_DYNAMICS_SECTION_POINTS_H
#define JLT_DYNAMICS_SECTION_POINTS_H

#include "dynamics/chart_section.h"

/** Whether a point of the grid is on the section. Cost: few lifts where much of the grid is, else one for each of its points. */
bool jlt_section_points_any(const jlt_chart_section *chart);

/** Whether no point of the grid is on the section. False where a coordinate is unbounded, for the grid does not cover the section
 *  then. */
bool jlt_section_points_none(const jlt_chart_section *chart);

/** The values of one coordinate for which the section has a point, whatever the others are: an interval with ends refined by
 *  bisection, the widest one where there are several.
 *  False: the coordinate is an angle, or not bounded; or there are none. */
bool jlt_section_points_interval(const jlt_chart_section *chart, unsigned coordinate, double *low, double *high);

#endif
