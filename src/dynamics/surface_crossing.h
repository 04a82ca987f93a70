/** How orbits cross a section that tables describe, and end at its poles: looked at on lifted points. */
#ifndef JLT_DYNAMICS_SURFACE_CROSSING_H
#define JLT_DYNAMICS_SURFACE_CROSSING_H

#include "dynamics/surface.h"

/** Whether what the flow crosses is lifted. A lift that takes one root of two is that half of the section alone: over some point the
 *  other half may be what is crossed in the flow's direction. system: of jlt_surface_system, its flow and chart made. */
bool jlt_surface_crossing_met(const jlt_system *system);

/** Whether orbits come to poles and no farther: a root that is a state of its own has no rate there. In a time that lifts it they would
 *  go through, and back in time, otherwise. */
bool jlt_surface_crossing_ends_at_poles(const jlt_system *system);

#endif
