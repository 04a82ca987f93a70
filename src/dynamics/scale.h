/** Typical sizes of a section's coordinates, in which lengths on it are counted: a step, a distance or a residual is small relative
 *  to these. A model may count in metres or in micrometres; answers must not depend on that. */
#ifndef JLT_DYNAMICS_SCALE_H
#define JLT_DYNAMICS_SCALE_H

#include "dynamics/system.h"

/** Set the sizes of the coordinates of a system's section, and of the state that it fixes. A size is the median over starts, shape
 *  (count, dim), of half the interval that the coordinate runs through in one return, where that is more than ten tolerances; or
 *  its extent, shape (dim,), if that is larger. The size of an angle is a radian. Sizes are rounded down to powers of two; in the
 *  flow's units, those from 1/64 to 64 become 1. Starts that do not return are ignored. extents NULL: none is known, and there is
 *  one start: sizes below 1 become 1, since orbits that hardly move, near an equilibrium, may lie among others of size 1; but where
 *  all of them, and the start's coordinates, are below 1/64, they become the largest of these.
 *  Errors: NOMEM; ARG, as jlt_map_create. Cost: two returns of each start. */
JLT_CHECKED jlt_status jlt_scale_find(jlt_system *system, const double *starts, size_t count, const double *extents);

/** Half the interval that each coordinate, and last the section's state, runs through from q, shape (dim,), to its return.
 *  Out: shape (dim + 1,). Errors: as jlt_map_point, jlt_orbit_create. Cost: two returns. */
JLT_CHECKED jlt_status jlt_scale_moves(double *out, jlt_map *map, const double *q);

/** For systems whose tangent vectors are to be computed, and whose sizes are from one start: if the derivative of the return from
 *  q, shape (dim,), is more than 64 times as large in the sizes found as in the flow's units, take the flow's units as sizes. A
 *  state that the motion hardly moves may move others, which its size does not show.
 *  Errors: NOMEM; ARG, as jlt_map_create. Cost: a return with its derivative. */
JLT_CHECKED jlt_status jlt_scale_for_tangents(jlt_system *system, const double *q);

/** Take the sizes of another system with the same section, such as one of the same family. */
void jlt_scale_copy(jlt_system *system, const jlt_system *from);

#endif
