/** The least value of the conditions under which a model holds, along an orbit that is followed from crossing to crossing: what a
 *  crossing knows is what was before it, though the step that leads over it goes on. */
#ifndef JLT_DYNAMICS_SECTION_CONDITIONS_H
#define JLT_DYNAMICS_SECTION_CONDITIONS_H

#include "integrate/orbit.h"
#include "kernel/observed.h"

typedef struct {
    double value; /* INFINITY: none; NaN: as far as is known all hold, and one has no value */
    unsigned condition;
} jlt_section_least;

typedef struct {
    const jlt_observed *observed; /* NULL: there are no conditions */
    bool looks_within;            /* for one that holds at both ends of a step, but not in between */
    jlt_section_least so_far;     /* but for the last step, of which these are: */
    jlt_section_least end, dip;   /* at its end; within it, */
    double dip_theta;             /* from this part of it on, INFINITY: nowhere */
} jlt_section_conditions;

/** Forget all; to be called at the start of an orbit. */
void jlt_section_conditions_begin(jlt_section_conditions *self);

/** Take a value into account. */
void jlt_section_conditions_note(jlt_section_conditions *self, jlt_section_least value);

/** Look at the step that the orbit has just made. Cost: one kernel; within the step, jlt_orbit_loss for each condition. */
void jlt_section_conditions_step(jlt_section_conditions *self, jlt_orbit *orbit);

/** The orbit is at x, shape (states,), at the part theta of its last step. Cost: one kernel. */
void jlt_section_conditions_arrive(jlt_section_conditions *self, double theta, const double *x);

/** All of the last step counts. */
void jlt_section_conditions_end(jlt_section_conditions *self);

/** What is left of the last step will be made again. */
void jlt_section_conditions_turn(jlt_section_conditions *self);

#endif
