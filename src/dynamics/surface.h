/** Surfaces of section that tables describe by the record `section`: which one the asked table (that of the user's model) leads to,
 *  which values it is made from, and the system of a flow with that section.
 *
 *  Where the record stands in another table than the asked one, a chain of proved reductions leads there (kernel/link.h).
 *  Parameters of that table have the values of the asked table's parameters of equal names, or are computed from these, as the
 *  reductions say; or they are values of the asked table's integrals: levels, like those that the record names. */
#ifndef JLT_DYNAMICS_SURFACE_H
#define JLT_DYNAMICS_SURFACE_H

#include "dynamics/chart_section.h"
#include "dynamics/system.h"
#include "kernel/link.h"
#include "kernel/way.h"

/* Starts that a section's table names, for its default values: on a regular orbit, on a chaotic one, and near a saddle. */
typedef enum { JLT_START_REGULAR, JLT_START_CHAOTIC, JLT_START_SADDLE, JLT_STARTS } jlt_surface_start;

/* In place of an index: the value is a parameter of the asked table that the section's kernels do not take; some of theirs may be
 * computed from it. */
enum { JLT_SURFACE_COMPUTED = ~0u >> 1 };

/** Plain data. Its values are, in this order: parameters of the section's table that the asked table has by the same names, in the
 *  former's order, and that are equal; the other parameters of the asked table; levels. */
typedef struct jlt_surface {
    const jlt_descriptor *asked;      /* the asked table's field from which it was found */
    const jlt_descriptor *table;      /* the section's: its general field, in the time that lifts most roots */
    const jlt_section_chart *section;
    jlt_link link;                    /* from the asked table to the section's */
    unsigned count, params;           /* of values; how many are parameters, which come first; levels follow */
    const char *names[JLT_CHART_VALUES_MAX];   /* (count,) */
    double defaults[JLT_CHART_VALUES_MAX];     /* (count,); NaN where the tables have none */
    unsigned entries[JLT_CHART_VALUES_MAX];    /* (count,): the index of each in the argument `values` of the section's kernels, or
                                                  JLT_SURFACE_COMPUTED */
} jlt_surface;

/** Find the section called `name`, or the first if that is NULL, in the asked table or one that proved claims link to it; others:
 *  tables beside those that are built in, NULL for none. *broken: NULL if it is found; else, if a claim would lead to a section
 *  but is not proved, or its parameters and levels cannot be followed, that claim, and *out is the section all the same.
 *  Errors: UNSUPPORTED, no section, or one with more values than there is room for, or of which a level's name is taken. */
JLT_CHECKED jlt_status jlt_surface_find(jlt_surface *out, const jlt_claim **broken, const jlt_descriptor *asked,
                                        const jlt_way_tables *others, const char *name);

/** Another quantity of the asked table that has the name of a level, where neither the section's record nor reductions show the two
 *  to be the same; NULL if there is none, or the name is not that of a level. */
const char *jlt_surface_taken(const jlt_surface *surface, const char *level);

/** The index of a value; surface->count where none has this name. */
unsigned jlt_surface_value(const jlt_surface *surface, const char *name);

/** Arrange values, shape (count,), as the section's kernels take them. Out: out, shape (JLT_CHART_VALUES_MAX,), the table's
 *  parameters, then the levels of the record. */
void jlt_surface_arrange(double *out, const jlt_surface *surface, const double *values);

/** Make the system with the most special kernel that holds for the values; where no coordinate has a unit, its flow counts in units
 *  of the problem. Out: *out, NULL on failure; destroy with jlt_system_destroy. In: surface; values, shape (count,), both copied;
 *  options, of which chart, field and rhs_jacobian are not read; NULL: all defaults, but upward crossings alone.
 *  Errors: DOMAIN, NONFINITE, a value; EMPTY, no state of the section has these levels; ARG, its points are not crossed in the
 *  direction of options; UNSUPPORTED, no Jacobian; NOMEM; as jlt_chart_section_init. */
JLT_CHECKED jlt_status jlt_surface_system(jlt_system **out, const jlt_surface *surface, const double *values,
                                          const jlt_flow *options);

/** jlt_surface_system for values so near those of another system of the surface, `near`, that the section's place and crossings are
 *  taken to be the same: neither is examined, and the flow counts in the same units. A tenth of the cost. Errors: as there, but for
 *  EMPTY and ARG. */
JLT_CHECKED jlt_status jlt_surface_system_near(jlt_system **out, const jlt_system *near, const double *values,
                                               const jlt_flow *options);

/** Let the flow count in these units. Maps and sections made from it before become invalid. Errors: as jlt_instance_create. */
JLT_CHECKED jlt_status jlt_surface_count_in(jlt_system *system, const jlt_units *units);

/** A family of systems in one of the values: jlt_surface_at is the `make` of a jlt_system_family, with this as its context. */
typedef struct {
    jlt_surface surface;
    double values[JLT_CHART_VALUES_MAX];
    unsigned runs; /* index of the value that varies */
    jlt_flow options;
} jlt_surface_family;

/** Make the family in which the value named `runs` varies, and all others have their defaults; upward crossings count.
 *  Errors: ARG, no such value; UNSUPPORTED, as jlt_surface_find, or not proved. */
JLT_CHECKED jlt_status jlt_surface_family_init(jlt_surface_family *out, const jlt_descriptor *asked, const char *runs);
/** The system at one value. near: NULL, or as for jlt_surface_system_near. Errors: as jlt_surface_system. */
JLT_CHECKED jlt_status jlt_surface_at(void *surface_family, jlt_system **out, double value, const jlt_system *near);

/** The chart, in the table's units, of a system that jlt_surface_system made; its flow.chart is in the flow's units. */
const jlt_chart_section *jlt_surface_chart(const jlt_system *system);

/** As jlt_section_points_interval, for the section of a system. */
bool jlt_surface_interval(const jlt_system *system, unsigned coordinate, double *low, double *high);

/** Compute what is shown beside the coordinates, shape (section->beside_count,), and at the end of an orbit, shape
 *  (section->ending_count,), at a row's state x; NaN where a value is not finite. */
void jlt_surface_beside(double *out, const jlt_system *system, const double *x);
void jlt_surface_ending(double *out, const jlt_system *system, const double *x);

/** The coordinates, shape (dim,), of a state of a row off the section: angles are NaN. */
void jlt_surface_off_section(double *q, const jlt_system *system, const double *x);

/** Set *level to the value of the first level nearest to values[params] at which the section has states. Returns false if none. */
bool jlt_surface_nearest_level(const jlt_surface *surface, const double *values, double *level);

#endif
