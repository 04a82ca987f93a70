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
    double y[JLT_WAY_VALUES_MAX]; /* the kernel's states at the last point that was reached */
} jlt_leg;

/** Begin a leg at x, shape (states of the asked model,), at time t. In: params, shape (params of the asked model,), whose units are
 *  those of x and t; direction of time, +1, -1, or 0 for not yet known; to_orbit, options of the orbit, whose invariants are set
 *  here where it projects. Out: refusal, as of jlt_tier_open; *out, which must not move. Errors: those of jlt_tier_open,
 *  jlt_orbit_create. */
JLT_CHECKED jlt_status jlt_leg_open(jlt_leg *out, char *refusal, const jlt_tier *tier, const double *params, const double *x,
                                    double t, int direction, const jlt_method *method, const jlt_options *to_orbit);
void jlt_leg_close(jlt_leg *self); /* legal where it was not opened, on zeros */

/** Go on to time t. Out: *outcome, whose times are those of the kernel, and whose x is NULL where no point was reached; self->y,
 *  the point reached; *edge, the number of the edge at which the tier's coordinates end, or the count of edges where it is none.
 *  Errors: those of jlt_orbit_next; DOMAIN, at an edge. */
JLT_CHECKED jlt_status jlt_leg_to(jlt_leg *self, double t, jlt_outcome *outcome, unsigned *edge);

/** Where it ended, in words: at that edge of its coordinates, or, for their count, of the domain of its table. Out: text, shape
 *  (JLT_TIER_TEXT_MAX,). */
void jlt_leg_end_text(char *text, const jlt_leg *self, unsigned edge);

/** The name of the state that grows without bound at the last point, at time t of the orbit; NULL: none is known. */
const char *jlt_leg_unbounded(const jlt_leg *self, double t);

/** The time of the asked model at one of the orbit's. */
double jlt_leg_time(const jlt_leg *self, double t);

#endif
