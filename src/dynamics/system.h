/** From names and numbers to a flow with a section: the kernel, its parameters, the field, and the chart. */
#ifndef JLT_DYNAMICS_SYSTEM_H
#define JLT_DYNAMICS_SYSTEM_H

#include "dynamics/chart_level.h"
#include "dynamics/continuation.h"
#include "kernel/instance.h"

typedef struct {
    jlt_instance *instance; /* its block in the flow's units */
    jlt_observed *observed;
    jlt_units units;
    const struct jlt_surface *surface; /* of a section that tables describe (dynamics/surface.h); NULL: a plane */
    const double *values;              /* what that one is made from, shape (surface->count,) */
    union {
        jlt_chart plane;
        jlt_chart_level level;
    } chart;
    jlt_field field;
    jlt_flow flow; /* points into this object */
} jlt_system;

/** Bind a kernel to its parameters, shape (param_count,), in these units: instance, field, what is observed, flow. For those who make
 *  systems; charts are theirs. Errors: UNSUPPORTED, no Jacobian; DOMAIN, NONFINITE; NOMEM. */
JLT_CHECKED jlt_status jlt_system_bind(jlt_system *self, const jlt_descriptor *descriptor, const double *params, const jlt_units *units,
                                       const jlt_flow *options);

/** Any kernel, on the section STATE = level. params, shape (param_count,), in the table's order. signs: its reversor, shape
 *  (state_count,), or NULL. options: chart, field and rhs_jacobian are not read; NULL: all defaults (upward crossings).
 *  Errors: ARG; UNSUPPORTED, no Jacobian; DOMAIN, NONFINITE; NOMEM. */
JLT_CHECKED jlt_status jlt_system_plane(jlt_system **out, const jlt_descriptor *descriptor, const double *params,
                                        unsigned column, double level, const int *signs, const jlt_flow *options);

/** Angles among the states of a plane section: periods, shape (states,), 0 for none. Before levels.
 *  Errors: DOMAIN, the field changes with a period, measured at a point; *state then tells whose. */
JLT_CHECKED jlt_status jlt_system_angles(jlt_system *self, const double *periods, unsigned *state);

/** Restrict a plane section to levels (count,) of its table's integrals. Errors: ARG, as jlt_chart_level_init. */
JLT_CHECKED jlt_status jlt_system_levels(jlt_system *self, const jlt_level *levels, unsigned count);
void jlt_system_destroy(jlt_system *self); /* NULL is legal */

/** Systems as a value runs, and the map of the one asked about last. Zero `system` and `map` before use. */
typedef struct {
    jlt_status (*make)(void *context, jlt_system **out, double value); /* destroyed by the family */
    void *context;
    double value;
    jlt_system *system;
    jlt_map *map;
} jlt_system_family;

/** map_at of jlt_family, with a jlt_system_family as context. Errors: those of `make`. */
JLT_CHECKED jlt_status jlt_system_map_at(void *family, jlt_map **map, double value);
void jlt_system_family_clear(jlt_system_family *self);

#endif
