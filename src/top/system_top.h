/** The spherical top on the section omega_tau = 0 of levels of energy and of Jellett's integral: the kernel of spherical_top_level in
 *  regular time, with the chart of chart_top.h, in units of the problem. */
#ifndef JLT_TOP_SYSTEM_TOP_H
#define JLT_TOP_SYSTEM_TOP_H

#include "dynamics/system.h"
#include "top/chart_top.h"

/** Parameters, and the levels of the section. */
typedef struct {
    double m, R, g, I1, I3, a3;
    double E, G;
} jlt_top_values;

/** (5.1) of Kilin & Ivanova (2023): m = R = g = 1, I1 = I3 = 1/3, a3 = 0.51, E = 2.15, G = -0.56. */
jlt_top_values jlt_system_top_defaults(void);

/** The entry named m, R, g, I1, I3, a3, E or G; NULL when there is none. */
double *jlt_system_top_value(jlt_top_values *values, const char *name);

/** The most special kernel that serves. options: chart, field and rhs_jacobian are not read; NULL: all defaults (upward crossings).
 *  Errors: UNSUPPORTED, the kernel is not built in; DOMAIN, NONFINITE, a parameter; EMPTY, no state with omega_tau = 0 has
 *  these levels; NOMEM. */
JLT_CHECKED jlt_status jlt_system_top(jlt_system **out, const jlt_top_values *values, const jlt_flow *options);

/** Its values, and its chart in the table's units; that of the flow is in the flow's. */
jlt_top_values jlt_system_top_values(const jlt_system *self);
const jlt_chart_top *jlt_system_top_chart(const jlt_system *self);

/** The interval of gamma3 in which the levels have states with omega_tau = 0, scanned on 4096 points and refined by
 *  bisection; the widest one where there are several. false: none. */
bool jlt_system_top_interval(const jlt_chart_top *chart, double *low, double *high);

#endif
