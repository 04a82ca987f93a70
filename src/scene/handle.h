/** Orbits behind opaque handles. Calls take only pointers, numbers, strings and arrays, so that other languages need not know any
 *  structure.
 *
 *      jlt_handle_section *section = NULL;
 *      JLT_TRY(jlt_handle_section_known(&section, "MODEL", NULL, NULL, 0, 0));         // all values as they are by default
 *      JLT_TRY(jlt_handle_section_start(section, q, +1));
 *      JLT_TRY(jlt_handle_section_returns(section, points, t, NULL, &done, &fate, 100));
 *      jlt_handle_section_destroy(section);
 *
 *  model: the name of a built-in model, or the path, with a slash, of a shared object made by `ttc build`; objects stay loaded.
 *  Tables beside an object's table are not read: those to which proofs of it lead, and their sections, are the built-in ones.
 *  names and values, shape (count,): the values that differ from the defaults, in any order, each name once; or NULL if count is 0.
 *  tolerance: of a step, as in integrate/method.h; 0: 1e-12. A fate is an integer that says how an orbit ended: 0 means that it has
 *  not, and jlt_section_fate_name(fate) in dynamics/section.h gives its name. One thread at a time may use a handle; different
 *  handles are independent. Arguments are copied, so the caller may free them after each call. Where a handle, a name, an array or
 *  another output that is needed is NULL, the status is ARG, the number of names 0 and the name NULL. */
#ifndef JLT_SCENE_HANDLE_H
#define JLT_SCENE_HANDLE_H

#include <stddef.h>

#include "core/status.h"

typedef struct jlt_handle_section jlt_handle_section;
typedef struct jlt_handle_motion jlt_handle_motion;

/* ---- returns to a section ---- */

/** The first section that tables describe of a model (dynamics/surface.h), crossed upwards; names: parameters and levels.
 *  Out: *out, NULL on failure, for jlt_handle_section_destroy.
 *  Errors: ARG, no such model, or a name that the section does not know; UNSUPPORTED, no section of the model is known, or
 *  nothing that is proved leads to it; DOMAIN, NONFINITE, a value; EMPTY, no state has these levels; IO, NOMEM. */
JLT_CHECKED jlt_status jlt_handle_section_known(jlt_handle_section **out, const char *model, const char *const *names,
                                                const double *values, size_t count, double tolerance);

/** The section STATE = level of any model, with all its other states as coordinates; states that its table proves to be periodic
 *  are angles. direction: +1 crossed upwards, -1 downwards, 0 both; names: parameters. Errors: as above; ARG also if the model does
 *  not have this state, the level is not finite, or the direction is another number; DOMAIN if the state has no such value. */
JLT_CHECKED jlt_status jlt_handle_section_plane(jlt_handle_section **out, const char *model, const char *state, double level,
                                                int direction, const char *const *names, const double *values, size_t count,
                                                double tolerance);
void jlt_handle_section_destroy(jlt_handle_section *self); /* NULL is legal */

/** Coordinates of the section, and columns, the further quantities in rows of a section that tables describe: their number, and
 *  their names, NULL past the end. Names live as long as the handle. */
unsigned jlt_handle_section_dim(const jlt_handle_section *self);
const char *jlt_handle_section_coordinate(const jlt_handle_section *self, unsigned index);
unsigned jlt_handle_section_columns(const jlt_handle_section *self);
const char *jlt_handle_section_column(const jlt_handle_section *self, unsigned index);

/** Start an orbit at q (dim,) on the section, forwards in time (+1) or backwards (-1).
 *  Errors: ARG, another time_direction; EMPTY, DOMAIN, NONFINITE, there is no state at q. */
JLT_CHECKED jlt_status jlt_handle_section_start(jlt_handle_section *self, const double *q, int time_direction);

/** Compute the next `count` returns of the orbit, or those up to its end.
 *  Out: q, shape (count, dim); t, shape (count,), time since the start, negative backwards; columns, shape (count, columns), or
 *  NULL; *done, the number of rows filled; *fate, the orbit's fate after them. When the orbit ends, the last row is the place and
 *  time of its end; coordinates that have no value there, off the section, are NaN. After that there are no rows until a new
 *  start.
 *  Errors: ARG, no orbit was started; NOMEM. A failure of the method is not an error but a fate. Cost: as jlt_section_next. */
JLT_CHECKED jlt_status jlt_handle_section_returns(jlt_handle_section *self, double *q, double *t, double *columns, size_t *done,
                                                  int *fate, size_t count);

/* ---- states at times ---- */

/** A model with its parameters, to be integrated in the smallest model that can answer (scene/plan.h).
 *  Out: *out, NULL on failure, for jlt_handle_motion_destroy. Errors: ARG, no such model or parameter, or a tolerance outside
 *  [0, 1); DOMAIN, NONFINITE, a value; UNSUPPORTED, more states or parameters than are served; IO, NOMEM. */
JLT_CHECKED jlt_status jlt_handle_motion_create(jlt_handle_motion **out, const char *model, const char *const *names,
                                                const double *values, size_t count, double tolerance);
void jlt_handle_motion_destroy(jlt_handle_motion *self); /* NULL is legal */

/** The number of the model's states, and their names in the table's order, NULL past the end. */
unsigned jlt_handle_motion_dim(const jlt_handle_motion *self);
const char *jlt_handle_motion_state(const jlt_handle_motion *self, unsigned index);

/** Start at x (dim,) at time 0. Errors: DOMAIN, NONFINITE, x is not allowed; UNSUPPORTED, no model serves; NOMEM. */
JLT_CHECKED jlt_status jlt_handle_motion_start(jlt_handle_motion *self, const double *x);

/** Compute states at times, shape (count,), ordered in one direction from 0 on; a later call continues. Out: x, shape (count, dim);
 *  t, shape (count,), the times asked for, in the last row of an orbit that ends the time of its end; *done, the number of rows
 *  filled; *fate, the orbit's fate after them. If the orbit ends at a pole, the last row is the limit there; if the method fails,
 *  it is the last point reached; after either there are no rows until a new start. The fate `invalid` means that a condition of the
 *  model has broken since the start; the orbit goes on. Errors: ARG, no orbit was started, or a time turns back; NONFINITE, a time
 *  is not finite; NOMEM. Rows before the error are filled. */
JLT_CHECKED jlt_status jlt_handle_motion_states(jlt_handle_motion *self, double *x, double *t, size_t *done, int *fate,
                                                const double *times, size_t count);

#endif
