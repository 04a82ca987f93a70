/** From names and numbers to a flow with a section: the kernel, its parameters, the field, and the chart. */
#ifndef JLT_DYNAMICS_SYSTEM_H
#define JLT_DYNAMICS_SYSTEM_H

#include "dynamics/chart_level.h"
#include "dynamics/chart_top.h"
#include "dynamics/continuation.h"
#include "kernel/instance.h"

/** Parameters of the spherical top and the levels of its section. */
enum { JLT_SYSTEM_PARAMS_MAX = 16 }; /* of the spherical top */

typedef struct {
    double m, R, g, I1, I3, a3;
    double E, G;
} jlt_top_values;

/** (5.1) of Kilin & Ivanova (2023): m = R = g = 1, I1 = I3 = 1/3, a3 = 0.51, E = 2.15, G = -0.56. */
jlt_top_values jlt_system_defaults(void);

/** The entry named m, R, g, I1, I3, a3, E or G; NULL when there is none. */
double *jlt_system_value(jlt_top_values *values, const char *name);

typedef struct {
    jlt_instance *instance; /* its block in the flow's units */
    jlt_observed *observed;
    jlt_top_values values; /* of the spherical top */
    bool is_top;
    union {
        jlt_chart plane;
        jlt_chart_level level;
        jlt_chart_top top;
    } chart;                 /* in the table's units, as rows are */
    jlt_chart_top flow_chart; /* of the spherical top: the same in the flow's */
    jlt_field field;
    jlt_flow flow; /* points into this object; the spherical top in units of its own, see jlt_chart_top_units */
} jlt_system;

/** The spherical top on levels of E and G: the most special kernel of spherical_top_level in regular time that serves.
 *  options: chart, field and rhs_jacobian are not read; NULL: all defaults (upward crossings).
 *  Errors: UNSUPPORTED, the kernel is not built in; DOMAIN, NONFINITE, a parameter; EMPTY, no state with omega_tau = 0 has
 *  these levels; NOMEM. */
JLT_CHECKED jlt_status jlt_system_top(jlt_system **out, const jlt_top_values *values, const jlt_flow *options);

/** Any kernel, on the section STATE = level. params, shape (param_count,), in the table's order. signs: its reversor, shape
 *  (state_count,), or NULL. Errors: ARG; UNSUPPORTED, no Jacobian; DOMAIN, NONFINITE; NOMEM. */
JLT_CHECKED jlt_status jlt_system_plane(jlt_system **out, const jlt_descriptor *descriptor, const double *params,
                                        unsigned column, double level, const int *signs, const jlt_flow *options);
/** Angles among the states of a plane section: periods, shape (states,), 0 for none. Before levels.
 *  Errors: DOMAIN, the field changes with a period, measured at a point; *state then tells whose. */
JLT_CHECKED jlt_status jlt_system_angles(jlt_system *self, const double *periods, unsigned *state);

/** Restrict a plane section to levels (count,) of its table's integrals. Errors: ARG, as jlt_chart_level_init. */
JLT_CHECKED jlt_status jlt_system_levels(jlt_system *self, const jlt_level *levels, unsigned count);
void jlt_system_destroy(jlt_system *self); /* NULL is legal */

/** The interval of gamma3 in which the levels have states with omega_tau = 0, scanned on 4096 points and refined by
 *  bisection; the widest one where there are several. false: none. */
bool jlt_system_interval(const jlt_chart_top *chart, double *low, double *high);

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

/** `make` of the spherical top as one of its values runs, with a jlt_top_family as context. Errors: ARG, an unknown name; as
 *  jlt_system_top. */
typedef struct {
    jlt_top_values values;
    const char *name; /* of the value that runs */
    jlt_flow options;
} jlt_top_family;

JLT_CHECKED jlt_status jlt_system_top_at(void *top_family, jlt_system **out, double value);

#endif
