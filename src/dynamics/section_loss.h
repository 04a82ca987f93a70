/** Where the orbits that commands find break a condition of their model. */
#ifndef JLT_DYNAMICS_SECTION_LOSS_H
#define JLT_DYNAMICS_SECTION_LOSS_H

#include "dynamics/section.h"

/** Follow the orbits from points, shape (count, dim), for `returns` returns each or to their ends, until a condition of the model
 *  has broken; *at becomes the last row, with `least` not positive if one has. A model without conditions costs nothing: `least` is
 *  then INFINITY, and the rest is not set. Errors: as jlt_section_create, _start and _next. */
JLT_CHECKED jlt_status jlt_section_loss(jlt_return *at, const jlt_flow *flow, const double *points, size_t count, size_t returns);

#endif
