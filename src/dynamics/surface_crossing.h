/** How orbits cross a section that tables describe, and end at its poles, as seen at lifted points of a grid. */
#ifndef JLT_DYNAMICS_SURFACE_CROSSING_H
#define JLT_DYNAMICS_SURFACE_CROSSING_H

#include "dynamics/surface.h"

/** Whether the lift gives the states that the flow crosses. A lift that takes one of two roots covers that half of the section
 *  only, and over some points it may be the other half that is crossed in the flow's direction: false.
 *  system: of jlt_surface_system, its flow and chart made; section: its chart in the table's units. */
bool jlt_surface_crossing_met(const jlt_system *system, const jlt_chart_section *section);

/** Whether orbits end at the section's poles: the field has no lifted root, or gives it the rate 0 at the pole, where it is 0.
 *  False: in this time they would go on through the pole to where the root is negative and time runs backwards. */
bool jlt_surface_crossing_ends_at_poles(const jlt_system *system, const jlt_chart_section *section);

#endif
