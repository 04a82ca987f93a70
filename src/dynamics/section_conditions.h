/** The least value of the conditions under which a model holds, along an orbit that is followed from crossing to crossing: at a
 *  crossing, only the part of the last step before it counts. */
#ifndef JLT_DYNAMICS_SECTION_CONDITIONS_H
#define JLT_DYNAMICS_SECTION_CONDITIONS_H

#include "integrate/orbit.h"
#include "kernel/observed.h"

typedef struct {
    double value; /* INFINITY: none; NaN: one condition has no value, and all known values are positive */
    unsigned condition;
} jlt_section_least;

typedef struct {
    const jlt_observed *observed; /* NULL: there are no conditions */
    bool looks_within;            /* steps are searched for a condition that holds at both ends, but not in between, */
    bool seeks_least;             /* or for one that is less in between than so far */
    jlt_section_least so_far;     /* before the last step */
    jlt_section_least end, dip;   /* of the last step: at its end; within it, where such a condition is least, */
    double dip_theta;             /* at this fraction of it; INFINITY: nowhere */
} jlt_section_conditions;

/** Forget all; to be called at the start of an orbit. */
void jlt_section_conditions_begin(jlt_section_conditions *self);

/** Take a value into account. */
void jlt_section_conditions_note(jlt_section_conditions *self, jlt_section_least value);

/** Count all of the step before, and evaluate the conditions on the one that the orbit has just made. Cost: one kernel; to look
 *  within the step, jlt_orbit_loss or jlt_orbit_least for each condition. */
void jlt_section_conditions_step(jlt_section_conditions *self, jlt_orbit *orbit);

/** Count the last step up to its fraction theta, where the orbit is at x, shape (states,). Cost: one kernel. */
void jlt_section_conditions_arrive(jlt_section_conditions *self, double theta, const double *x);

/** Count all of the last step. */
void jlt_section_conditions_end(jlt_section_conditions *self);

/** Drop the rest of the last step: the orbit restarts from its current point. */
void jlt_section_conditions_turn(jlt_section_conditions *self);

#endif
