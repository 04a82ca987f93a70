/** The search for periodic orbits on a grid of starts: where an orbit nearly closes, a Newton search begins, and all of these run
 *  side by side on batches of maps; each orbit found is then polished and measured by the map itself. */
#ifndef JLT_DYNAMICS_ORBITS_GRID_H
#define JLT_DYNAMICS_ORBITS_GRID_H

#include "dynamics/orbits.h"

/** Search from every start of the grid in `options`, and add the orbits found to the list. The result does not depend on the number
 *  of threads. Errors: as jlt_orbits_search. */
JLT_CHECKED jlt_status jlt_orbits_grid(jlt_orbits *self, jlt_map *map, const jlt_orbits_options *options);

#endif
