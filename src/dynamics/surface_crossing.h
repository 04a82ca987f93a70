/** How orbits cross a section that tables describe, and end at its poles, as seen at lifted points of a grid. */
#ifndef JLT_DYNAMICS_SURFACE_CROSSING_H
#define JLT_DYNAMICS_SURFACE_CROSSING_H

#include "dynamics/surface.h"

/** Tell whether the flow crosses the section at the states that the lift gives. A lift that takes one of two roots covers only one
 *  half of the section. system: of jlt_surface_system, its flow and chart made; section: its chart in the table's units.
 *  Errors: ARG, over some point the flow crosses the other half in its direction; NOMEM. */
JLT_CHECKED jlt_status jlt_surface_crossing_met(const jlt_system *system, const jlt_chart_section *section);

/** Whether orbits end at the section's poles: the field has no lifted root, or gives it the rate 0 at the pole, where it is 0.
 *  If not, in this time they would go on through the pole to where the root is negative and time runs backwards. */
bool jlt_surface_crossing_ends_at_poles(const jlt_system *system, const jlt_chart_section *section);

#endif
