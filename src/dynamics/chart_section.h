/** The chart of a section that tables describe: coordinates, lift, way back and levels are those of the records `section` and
 *  `lift`, whose kernels do the work (kernel_abi.h, jlt_section_chart).
 *
 *  The flux of volume follows from the lift. On the section volume is dx_column times the other states' volume, which is
 *  |det d(other states)/d(coordinates, levels)| dq dlevels; a root s that is a state of its own contributes 1/s, as the lifted
 *  field keeps s^2 - radicand everywhere, and the volume of the larger space carries 1/(2s) on s^2 = radicand. */
#ifndef JLT_DYNAMICS_CHART_SECTION_H
#define JLT_DYNAMICS_CHART_SECTION_H

#include "dynamics/chart.h"

enum { JLT_CHART_VALUES_MAX = 64, JLT_CHART_COORDINATES_MAX = 16, JLT_CHART_SLOPES_MAX = 1024 };

typedef struct {
    jlt_chart base;
    const jlt_descriptor *table; /* the section's field */
    const jlt_section_chart *section;
    unsigned plain;              /* number of states that are no lifted roots; the roots stand after them */
    double values[JLT_CHART_VALUES_MAX]; /* parameters of the table, then levels */
    int unit[JLT_CHART_STATES_MAX],      /* the flux's determinant is computed with state i in units of 2^unit[i], */
        per[JLT_CHART_COORDINATES_MAX + JLT_CHART_VALUES_MAX]; /* and coordinate or level j in units of 2^per[j]; 0 at first */
} jlt_chart_section;

/** Make the chart. In: table, a general field with all its states; section, one of its sections; values, shape (param_count +
 *  level_count,), copied. The chart is reversible if a reversor that the table proves keeps the section and only changes signs of
 *  coordinates, which is tested at points of the section.
 *  Errors: UNSUPPORTED, more values, coordinates or states than there is room for, or not as many coordinates and levels as
 *  states. */
JLT_CHECKED jlt_status jlt_chart_section_init(jlt_chart_section *out, const jlt_descriptor *table, const jlt_section_chart *section,
                                              const double *values);

/** True where the section has a state at q, shape (dim,): q lies within the coordinates' intervals, and the region holds there. */
bool jlt_chart_section_holds(const jlt_chart_section *self, const double *q);

/** A grid of points that covers the coordinates' intervals; of an unbounded interval two units are covered. Each angle takes
 *  `angles` values, the other coordinates as many as make about 4096 combinations together. _points: how many points the grid has;
 *  _places: how many values one coordinate takes; _point: q, shape (dim,), of point `index`, the first coordinate varying
 *  fastest. */
size_t jlt_chart_section_points(const jlt_chart_section *self, unsigned angles);
unsigned jlt_chart_section_places(const jlt_chart_section *self, unsigned coordinate, unsigned angles);
void jlt_chart_section_point(const jlt_chart_section *self, double *q, size_t index, unsigned angles);

/** Points to try in search of some point of the section: those of the grid in scattered order, so that a hit comes early; then
 *  others around the table's starts and the middle of the intervals, at distances of all sizes. _probes: how many; _probe: one. */
size_t jlt_chart_section_probes(const jlt_chart_section *self, unsigned angles);
void jlt_chart_section_probe(const jlt_chart_section *self, double *q, size_t index, unsigned angles);

#endif
