/** A system: a kernel with its parameters, its field, and the chart of a section, all that dynamics/ needs, owned together. */
#ifndef JLT_DYNAMICS_SYSTEM_H
#define JLT_DYNAMICS_SYSTEM_H

#include "dynamics/chart_level.h"
#include "dynamics/continuation.h"
#include "kernel/instance.h"

typedef struct {
    jlt_instance *instance; /* in the flow's units */
    jlt_instance *told;     /* in the table's units: the same object where the flow counts in these */
    jlt_observed *observed;
    jlt_units units;
    const struct jlt_surface *surface; /* of a section that tables describe (dynamics/surface.h); NULL: a plane */
    const double *values;              /* of the surface, shape (surface->count,) */
    union {
        jlt_chart plane;
        jlt_chart_level level;
    } chart;
    jlt_field field;
    jlt_chart *chart_base; /* flow.chart, which dynamics/scale.h changes: `chart`, or one over it in the flow's units */
    jlt_flow flow; /* points into this object */
} jlt_system;

/** Fill instance, field, observed and flow of a system from a kernel and its parameters, shape (param_count,), in the table's
 *  units; states are counted in `units`. For functions that make systems: the chart is left to them. Errors: UNSUPPORTED, no
 *  Jacobian; DOMAIN, NONFINITE; NOMEM. */
JLT_CHECKED jlt_status jlt_system_bind(jlt_system *self, const jlt_descriptor *descriptor, const double *params,
                                       const jlt_units *units, const jlt_flow *options);

/** The kernel that follows orbits of `descriptor`, a general field or a variant, to plane sections: if every pole is proved, the
 *  kernel in the time that lifts the root of the poles, so that orbits end there; otherwise `descriptor` itself. */
const jlt_descriptor *jlt_system_regular(const jlt_descriptor *descriptor);

/** The section x[column] = level of any kernel. In a time that lifts roots these are not among the coordinates. Out: *out, NULL
 *  on failure; destroy with jlt_system_destroy. In: params, shape (param_count,), in the table's order and units; signs, +1 or
 *  -1 for each state but lifted roots, if the model is reversible by x -> signs * x, else NULL; options, of which chart, field
 *  and rhs_jacobian are not read; NULL: all defaults, but upward crossings alone. Errors: ARG; UNSUPPORTED, no Jacobian; DOMAIN,
 *  NONFINITE; NOMEM. */
JLT_CHECKED jlt_status jlt_system_plane(jlt_system **out, const jlt_descriptor *descriptor, const double *params,
                                        unsigned column, double level, const int *signs, const jlt_flow *options);

/** Declare states of a plane section to be angles: periods, shape (states,), 0 for the others. Call it before
 *  jlt_system_levels. Errors: DOMAIN, a period that the table does not prove, of a state that has an interval, or one that field,
 *  domain and conditions do not have at one of five test points; *state is then the index of that state. */
JLT_CHECKED jlt_status jlt_system_angles(jlt_system *self, const double *periods, unsigned *state);

/** Whether the field of a plane section is reversed by x -> signs * x, shape (states,), to rounding at five test points: an orbit's
 *  image is then an orbit that runs backwards. */
bool jlt_system_is_reversed(const jlt_system *self, const int *signs);

/** Restrict a plane section to levels (count,) of its table's integrals; on failure it stays as it was. Errors: ARG, as
 *  jlt_chart_level_init; EMPTY, at five test points the levels do not determine the states solved for; UNSUPPORTED, as
 *  jlt_system_invariants. */
JLT_CHECKED jlt_status jlt_system_levels(jlt_system *self, const jlt_level *levels, unsigned count);

/** Let the flow of a plane section, whose angles and levels are set, count in units of the problem (jlt_instance_units) where
 *  states are of these sizes, shape (states of the general field,). Nothing changes if terms do not have the dimensions of the
 *  table's units, or an angle has a unit. Maps and sections made from the flow before become invalid. Errors: as
 *  jlt_instance_create. */
JLT_CHECKED jlt_status jlt_system_count(jlt_system *self, const double *sizes);

/** Let the flow count in these units, unless its field does not scale; its chart is left to the caller. Errors: as
 *  jlt_instance_create. */
JLT_CHECKED jlt_status jlt_system_count_in(jlt_system *self, const jlt_units *units);

/** Set *out to what the system's field conserves: integrals, in the flow's units; on a plane section also the relations of lifted
 *  roots. *out points into the system. Errors: UNSUPPORTED, more than JLT_INVARIANTS_MAX with relations. */
JLT_CHECKED jlt_status jlt_system_invariants(jlt_invariants *out, jlt_system *self);
void jlt_system_destroy(jlt_system *self); /* NULL is legal */
JLT_OWNED_TYPE(jlt_system)

/** A system of a family, and its map; NULL: there is none. */
typedef struct {
    double value;
    jlt_system *system;
    jlt_map *map;
} jlt_system_member;

/** A family of systems in one value, with those that were asked for last. Set the members to NULL before use. */
typedef struct {
    /* near: NULL, or the system of a value so near that what was found out about its section holds for *out, which the family
     * destroys */
    jlt_status (*make)(void *context, jlt_system **out, double value, const jlt_system *near);
    void *context;
    jlt_system_member at, near; /* of jlt_system_map_at, and of jlt_system_map_near */
} jlt_system_family;

/** map_at and map_near of jlt_family, with a jlt_system_family as context. Errors: those of `make` and of jlt_map_create. */
JLT_CHECKED jlt_status jlt_system_map_at(void *family, jlt_map **map, double value);
JLT_CHECKED jlt_status jlt_system_map_near(void *family, jlt_map **map, double value);
void jlt_system_family_clear(jlt_system_family *self);

#endif
