/** Typical sizes of a section's coordinates, in which lengths on it are counted: what a step, a distance or a residual is small
 *  against. A model may count in metres or in micrometres; answers must not depend on that. */
#ifndef JLT_DYNAMICS_SCALE_H
#define JLT_DYNAMICS_SCALE_H

#include "dynamics/system.h"

/** Set the sizes of the coordinates of a system's section, and of the state that it fixes. A size is the median over starts, shape
 *  (count, dim), of half the interval that the coordinate runs through in one return, where that is more than ten tolerances; or
 *  its extent, shape (dim,), if that is larger. Of an angle it is that of a radian. A power of two stands for it: in the flow's
 *  units 1 for sizes from 1/64 to 64, which are as they stand. Starts that do not return say nothing. extents NULL: none is known,
 *  and sizes below 1 are not taken, for orbits that hardly move, near an equilibrium, may lie among others of the size 1.
 *  Errors: NOMEM; ARG, as jlt_map_create. Cost: two returns of each start. */
JLT_CHECKED jlt_status jlt_scale_find(jlt_system *system, const double *starts, size_t count, const double *extents);

/** Take the sizes of another system with the same section, such as one of the same family. */
void jlt_scale_copy(jlt_system *system, const jlt_system *from);

#endif
