/** A leg of a course: the part of the orbit that is integrated in one tier. */
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
    double t;      /* time of its start */
    int direction; /* of time; 0: the first time asked for decides */
    bool started;
    double y[JLT_WAY_VALUES_MAX]; /* the kernel's states at the last point reached */
} jlt_leg;

/** Begin a leg at x, shape (states of the asked model,), at time t. In: params, shape (params of the asked model,), in the units of
 *  x and t; direction of time, +1, -1, or 0 if not yet known; to_orbit, options of the orbit; if it projects, the leg sets the
 *  invariants. Out: refusal, as from jlt_tier_open; *out, which must not move in memory. Errors: those of jlt_tier_open,
 *  jlt_orbit_create. */
JLT_CHECKED jlt_status jlt_leg_open(jlt_leg *out, char *refusal, const jlt_tier *tier, const double *params, const double *x,
                                    double t, int direction, const jlt_method *method, const jlt_options *to_orbit);
void jlt_leg_close(jlt_leg *self); /* legal when zeroed */

/** Advance to time t. Out: *outcome, with times of the orbit (see jlt_leg_time), and x NULL if no point was reached; self->y, the
 *  point reached; *edge, the index of the edge at which the tier's coordinates end, or the number of edges if they do not.
 *  Errors: those of jlt_orbit_next; DOMAIN also at an edge. */
JLT_CHECKED jlt_status jlt_leg_to(jlt_leg *self, double t, jlt_outcome *outcome, unsigned *edge);

/** Say in words where the leg ended: at this edge of its coordinates, or, if `edge` is the number of edges, at the edge of its
 *  table's domain; in plain time, so near a pole that digits are lost. Out: text, shape (JLT_TIER_TEXT_MAX,). */
void jlt_leg_end_text(char *text, const jlt_leg *self, unsigned edge);

/** The name of the state that grows without bound at the last point, at time t of the orbit; NULL: none is known. */
const char *jlt_leg_unbounded(const jlt_leg *self, double t);

/** The asked model's time at time t of the orbit, which runs backwards if the tier integrates the image by a reversor. */
double jlt_leg_time(const jlt_leg *self, double t);

#endif
