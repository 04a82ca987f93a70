/** Finds where a section that tables describe has points, by trying the grid of jlt_chart_section_points: 4096 combinations of
 *  the coordinates that are not angles. */
#ifndef JLT_DYNAMICS_SECTION_POINTS_H
#define JLT_DYNAMICS_SECTION_POINTS_H

#include "dynamics/chart_section.h"

/** Whether any point of jlt_chart_section_probes is in the section. Cost: few tests where many are, else one for each. */
bool jlt_section_points_any(const jlt_chart_section *chart);

/** Whether none of these points is in the section. Returns false where a coordinate is unbounded: no grid covers it. */
bool jlt_section_points_none(const jlt_chart_section *chart);

/** Find the values of one coordinate for which the section has a point, whatever the others are: an interval with ends refined by
 *  bisection, the widest one where there are several.
 *  Returns false if the coordinate is an angle, or not bounded, or if there are none. */
bool jlt_section_points_interval(const jlt_chart_section *chart, unsigned coordinate, double *low, double *high);

#endif
