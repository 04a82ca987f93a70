/** Finds where a section that tables describe has points, by trying the grid of jlt_chart_section_points: 4096 combinations of
 *  the coordinates that are no angles. */
#ifndef JLT_DYNAMICS_SECTION_POINTS_H
#define JLT_DYNAMICS_SECTION_POINTS_H

#include "dynamics/chart_section.h"

/** Whether the section has any of the points of jlt_chart_section_probes. Cost: few tests where it has many, else one for each. */
bool jlt_section_points_any(const jlt_chart_section *chart);

/** Whether the section has none of these points. Returns false where a coordinate is unbounded: the grid does not cover it then. */
bool jlt_section_points_none(const jlt_chart_section *chart);

/** Find the values of one coordinate for which the section has a point, whatever the others are: an interval with ends refined by
 *  bisection, the widest one where there are several.
 *  Returns false if the coordinate is an angle, or not bounded, or if there are none. */
bool jlt_section_points_interval(const jlt_chart_section *chart, unsigned coordinate, double *low, double *high);

#endif
