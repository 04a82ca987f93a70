/* The section of the spherical top for tests: its system by values in a struct, and the chart typed by hand beside it. */
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

/* The library's system, by the section that the tables describe. */
JLT_CHECKED jlt_status jlt_system_top(jlt_system **out, const jlt_top_values *values, const jlt_flow *options);
jlt_top_values jlt_system_top_values(const jlt_system *self);

/* The witness' chart of the same values, until the next call. */
const jlt_chart_top *jlt_system_top_chart(const jlt_system *self);

/* `make` of jlt_system_family as one of its values runs, with a jlt_top_family as context. */
typedef struct {
    jlt_top_values values;
    const char *name; /* of the value that runs */
    jlt_flow options;
} jlt_top_family;

JLT_CHECKED jlt_status jlt_system_top_at(void *top_family, jlt_system **out, double value);

#endif
