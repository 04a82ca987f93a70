/** Surfaces of section that tables describe by the record `section`: which one an asked table leads to, what it is made from, and the
 *  system of a flow with that section.
 *
 *  Where the record stands in another table than the asked one, a chain of proved claims leads there (kernel/link.h). Parameters of
 *  that table which the asked one has not are values of integrals of the latter: levels, like those that the record names. */
#ifndef JLT_DYNAMICS_SURFACE_H
#define JLT_DYNAMICS_SURFACE_H

#include "dynamics/chart_section.h"
#include "dynamics/system.h"
#include "kernel/way.h"

/* Starts with the default values, by the names of the records: of a regular orbit, of a chaotic one, and near a saddle. */
typedef enum { JLT_START_REGULAR, JLT_START_CHAOTIC, JLT_START_SADDLE, JLT_STARTS } jlt_surface_start;

/** Plain data. Values are the parameters of the table that are no levels, in its order, and then the levels. */
typedef struct jlt_surface {
    const jlt_descriptor *asked;      /* the general field from which it was found */
    const jlt_descriptor *table;      /* the section's: its general field, in the time that lifts most roots */
    const jlt_section_chart *section;
    unsigned count, params;           /* of values: the parameters stand first, levels after them */
    const char *names[JLT_CHART_VALUES_MAX];   /* (count,) */
    double defaults[JLT_CHART_VALUES_MAX];     /* (count,); NaN where the tables have none */
    unsigned entries[JLT_CHART_VALUES_MAX];    /* (count,): where the kernels of the section have each */
} jlt_surface;

/** The section called `name`, NULL for the first, that the table says or is linked to by proof; others: tables beside those that are
 *  built in, NULL for none. *broken: where there is none but a claim
 *  would lead to it that is not proved, that claim, and *out the section all the same; else NULL.
 *  Errors: UNSUPPORTED, none, or one with more values than there is room for. */
JLT_CHECKED jlt_status jlt_surface_find(jlt_surface *out, const jlt_claim **broken, const jlt_descriptor *asked, const jlt_way_tables *others,
                                        const char *name);

/** The index of a value; surface->count where there is none of this name. */
unsigned jlt_surface_value(const jlt_surface *surface, const char *name);

/** The most special kernel that serves values, shape (count,), both copied, in units of the problem. options: chart, field and
 *  rhs_jacobian are not read; NULL: all defaults (upward crossings).
 *  Errors: DOMAIN, NONFINITE, a value; EMPTY, no state of the section has these levels; ARG, its points are not crossed in the direction of
 *  options; NOMEM; as jlt_chart_section_init. */
JLT_CHECKED jlt_status jlt_surface_system(jlt_system **out, const jlt_surface *surface, const double *values, const jlt_flow *options);

/** `make` of jlt_system_family as one of the values runs, with a jlt_surface_family as context. Errors: as jlt_surface_system. */
typedef struct {
    jlt_surface surface;
    double values[JLT_CHART_VALUES_MAX];
    unsigned runs; /* the index of the value that does */
    jlt_flow options;
} jlt_surface_family;

/** A family with all values as they are by default, of which the one called `runs` does; crossed upwards, all else by default.
 *  Errors: ARG, no such value; UNSUPPORTED, as jlt_surface_find, or not proved. */
JLT_CHECKED jlt_status jlt_surface_family_init(jlt_surface_family *out, const jlt_descriptor *asked, const char *runs);
JLT_CHECKED jlt_status jlt_surface_at(void *surface_family, jlt_system **out, double value);

/** Of a system made so: its chart in the table's units; that of the flow is in the flow's. */
const jlt_chart_section *jlt_surface_chart(const jlt_system *system);

/** Where the section has points in a coordinate, whatever the others: scanned, and refined by bisection; the widest interval where there
 *  are several. False: the coordinate is an angle, or not bounded; or there are none. */
bool jlt_surface_interval(const jlt_system *system, unsigned coordinate, double *low, double *high);

/** What is shown beside the coordinates, and at the end of an orbit: shape (section->beside_count,), (section->ending_count,), at a
 *  state of a row; NaN where it has no limit. */
void jlt_surface_beside(double *out, const jlt_system *system, const double *x);
void jlt_surface_ending(double *out, const jlt_system *system, const double *x);

/** The coordinates, shape (dim,), of a state of a row off the section: angles are NaN. */
void jlt_surface_off_section(double *q, const jlt_system *system, const double *x);

/** Whether an orbit that starts at q has yet to turn; and the fate by which such an orbit has turned. False, and ALIVE, where the
 *  section says nothing of turning. */
bool jlt_surface_is_low(const jlt_system *system, const double *q);
jlt_fate jlt_surface_turned_at(const jlt_system *system);

/** The level nearest to values[params] at which the section has states: into *level. False: none was found. */
bool jlt_surface_nearest_level(const jlt_surface *surface, const double *values, double *level);

#endif
