/** Units in which motions are computed on sections that tables describe. */
#ifndef JLT_DYNAMICS_SURFACE_UNITS_H
#define JLT_DYNAMICS_SURFACE_UNITS_H

#include "dynamics/chart_section.h"
#include "kernel/instance.h"

/** Whether a coordinate has a unit. */
bool jlt_surface_units_named(const jlt_section_chart *section);

/** If no coordinate has a unit: units in which the first positive mass and length are in [1, 2), lengths of states at least 1/64,
 *  and half the square of the largest rate in [1, 4), at points of the section. */
jlt_units jlt_surface_units_of(const jlt_chart_section *chart);

/** If a coordinate has a unit: units of the problem at points of the section, shape (count, dim), or, for count 0, all over its
 *  coordinates' intervals. Returns false if none of the points is on the section; if the table's units are no dimensions of its
 *  terms; or if no coordinate has a unit: jlt_surface_system has then chosen units already. */
bool jlt_surface_units_at(jlt_units *out, const jlt_chart_section *chart, const double *points, size_t count);

#endif
