/* The section of the spherical top for tests: the library's system, from values in a struct, and the hand-typed chart beside it. */
#ifndef JLT_TESTS_TOP_SECTION_H
#define JLT_TESTS_TOP_SECTION_H

#include "dynamics/surface.h"
#include "witness/chart_top.h"

/* Parameters, and the levels of the section. */
typedef struct {
    double m, R, g, I1, I3, a3;
    double E, G;
} jlt_top_values;

/* (5.1) of Kilin & Ivanova (2023). */
jlt_top_values jlt_system_top_defaults(void);

/* The entry named m, R, g, I1, I3, a3, E or G; NULL when there is none. */
double *jlt_system_top_value(jlt_top_values *values, const char *name);

/* Make the library's system on the section that the tables describe. */
JLT_CHECKED jlt_status jlt_system_top(jlt_system **out, const jlt_top_values *values, const jlt_flow *options);
jlt_top_values jlt_system_top_values(const jlt_system *self);

/* The hand-typed chart of the same values, valid until the next call. */
const jlt_chart_top *jlt_system_top_chart(const jlt_system *self);

/* A family of systems in which one value runs. jlt_system_top_at is the `make` of a jlt_system_family, with a jlt_top_family as
 * context. */
typedef struct {
    jlt_top_values values;
    const char *name; /* of the value that runs */
    jlt_flow options;
} jlt_top_family;

JLT_CHECKED jlt_status jlt_system_top_at(void *top_family, jlt_system **out, double value, const jlt_system *near);

#endif
