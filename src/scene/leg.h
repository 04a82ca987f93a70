/** A leg of a course: the orbit from one state on, in one tier. */
#ifndef JLT_SCENE_LEG_H
#define JLT_SCENE_LEG_H

#include "integrate/conserved.h"
#include "integrate/orbit.h"
#include "scene/tier.h"

typedef struct {
    jlt_tier_view view;
    jlt_tier_edges edges;
    jlt_field field;
    jlt_conserved conserved;
    jlt_orbit *orbit;
    double t;      /* of the start */
    int direction; /* of time; 0: that of the first time asked for */
    bool started;
    double params[JLT_WAY_VALUES_MAX]; /* of the kernel */
    double y[JLT_WAY_VALUES_MAX];      /* its states at the last point that was reached */
} jlt_leg;

/** Begin at x, shape (states of the asked model,), at time t, in a direction of time, or 0: not yet known. Everything is in the units of params, shape (params,). refusal: as jlt_tier_open.
 *  *out must not move. In: to_orbit, whose invariants are set here where it projects. Errors: those of jlt_tier_open, jlt_orbit_create. */
JLT_CHECKED jlt_status jlt_leg_open(jlt_leg *out, char *refusal, const jlt_tier *tier, const double *params, const double *x, double t, int direction,
                                    const jlt_method *method, const jlt_options *to_orbit);
void jlt_leg_close(jlt_leg *self); /* legal where it was not opened, on zeros */

/** Go on to time t. Out: *outcome, with times of the kernel; x NULL: no point was reached, else y has it. *edge: the edge of the coordinates at
 *  which it ended, or its count for none. Errors: those of jlt_orbit_next; DOMAIN, at an edge. */
JLT_CHECKED jlt_status jlt_leg_to(jlt_leg *self, double t, jlt_outcome *outcome, unsigned *edge);

/** The time of the asked model at one of the orbit's. */
double jlt_leg_time(const jlt_leg *self, double t);

#endif
