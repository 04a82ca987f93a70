/** Orbits behind opaque handles: pointers, numbers, strings and arrays alone, so that other languages need lay out no
 *  structure.
 *
 *      jlt_handle_section *section = NULL;
 *      JLT_TRY(jlt_handle_section_known(&section, "MODEL", NULL, NULL, 0, 0));         // all values as they are by default
 *      JLT_TRY(jlt_handle_section_start(section, q, +1));
 *      JLT_TRY(jlt_handle_section_returns(section, points, t, NULL, &done, &fate, 100));
 *      jlt_handle_section_destroy(section);
 *
 *  model: the name of one that is built in, or the path, with a slash, of an object that `ttc build` has made; objects stay
 *  loaded. names and values, shape (count,): what differs from the defaults, in any order; names may be NULL where count is 0.
 *  tolerance: of a step, as in integrate/method.h; 0: 1e-12. A fate is a whole number that says what became of an orbit: 0 is
 *  alive, and jlt_section_fate_name(fate) in dynamics/section.h gives its name. A handle may be used by one thread at a time;
 *  different handles are independent. Arguments are copied, none is kept. */
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

/** The section STATE = level of any model, with all its other states as coordinates; those that its table proves to be angles
 *  are taken as such. direction: +1 crossed upwards, -1 downwards, 0 both; names: parameters.
 *  Errors: ARG, also a state that the model has not, or a level that is not finite; as above. */
JLT_CHECKED jlt_status jlt_handle_section_plane(jlt_handle_section **out, const char *model, const char *state, double level,
                                                int direction, const char *const *names, const double *values, size_t count,
                                                double tolerance);
void jlt_handle_section_destroy(jlt_handle_section *self); /* NULL is legal */

/** Coordinates of the section, and quantities that rows of a section that tables describe have beside them: how many, and their
 *  names, NULL past the end. Names live as long as the handle. */
unsigned jlt_handle_section_dim(const jlt_handle_section *self);
const char *jlt_handle_section_coordinate(const jlt_handle_section *self, unsigned index);
unsigned jlt_handle_section_columns(const jlt_handle_section *self);
const char *jlt_handle_section_column(const jlt_handle_section *self, unsigned index);

/** Start an orbit at q (dim,) on the section, forwards in time (+1) or backwards (-1).
 *  Errors: ARG, another time_direction; EMPTY, DOMAIN, NONFINITE, there is no state at q. */
JLT_CHECKED jlt_status jlt_handle_section_start(jlt_handle_section *self, const double *q, int time_direction);

/** The next `count` returns of the orbit, or those to its end.
 *  Out: q, shape (count, dim); t, shape (count,), time since the start; columns, shape (count, columns), or NULL; *done, how
 *  many rows are filled; *fate, of the orbit after them. An orbit that ends has a last row: where, and when; what a coordinate
 *  is there is NaN where the end is off the section. After that no row comes until a new start.
 *  Errors: ARG, nothing was started; NOMEM. That the method fails is a fate. Cost: as jlt_section_next. */
JLT_CHECKED jlt_status jlt_handle_section_returns(jlt_handle_section *self, double *q, double *t, double *columns, size_t *done,
                                                  int *fate, size_t count);

/* ---- states at times ---- */

/** A model with its parameters, integrated in the smallest model that can answer (scene/plan.h).
 *  Out: *out, NULL on failure, for jlt_handle_motion_destroy. Errors: ARG, no such model or parameter, or a tolerance outside
 *  [0, 1); DOMAIN, NONFINITE, a value; UNSUPPORTED, more states or parameters than are served; IO, NOMEM. */
JLT_CHECKED jlt_status jlt_handle_motion_create(jlt_handle_motion **out, const char *model, const char *const *names,
                                                const double *values, size_t count, double tolerance);
void jlt_handle_motion_destroy(jlt_handle_motion *self); /* NULL is legal */

/** States of the model, in its table's order: how many, and their names, NULL past the end. */
unsigned jlt_handle_motion_dim(const jlt_handle_motion *self);
const char *jlt_handle_motion_state(const jlt_handle_motion *self, unsigned index);

/** Start at x (dim,) at time 0. Errors: DOMAIN, NONFINITE, x; UNSUPPORTED, nothing serves; NOMEM. */
JLT_CHECKED jlt_status jlt_handle_motion_start(jlt_handle_motion *self, const double *x);

/** States at times, shape (count,), from 0 on in one direction, in order; a later call goes on.
 *  Out: x, shape (count, dim); t, shape (count,), the times asked for, or when the orbit has ended; *done, how many rows are
 *  filled; *fate, of the orbit after them: at a pole the last row is the limit, where the method fails the last point that it
 *  accepted, and after either no row comes until a new start. `invalid`: a condition of the model has been broken since the
 *  start, and the orbit goes on.
 *  Errors: ARG, nothing was started, or a time turns back; NONFINITE, a time; NOMEM. Rows before it are filled. */
JLT_CHECKED jlt_status jlt_handle_motion_states(jlt_handle_motion *self, double *x, double *t, size_t *done, int *fate,
                                                const double *times, size_t count);

#endif
