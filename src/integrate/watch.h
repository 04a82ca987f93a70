/** Finding the crossings of the last step. Used by orbit.c, and by edge.c for ends of the domain. */
#ifndef JLT_INTEGRATE_WATCH_H
#define JLT_INTEGRATE_WATCH_H

#include "integrate/event.h"

enum { JLT_CROSSINGS_MAX = JLT_DENSE_DEGREE_MAX };

/** An event under watch. */
typedef struct {
    jlt_event event;
    int side;     /* sign of g at the end of the last step, or, where g is 0 there, before; 0: the start is on the section */
    double value; /* g at the end of the last step */
    double *zero; /* (2, stride): the state at a zero of g among steps that end within the noise, and work; the caller's memory */
    double zero_tau;
    jlt_crossing at_zero;
    bool has_zero;
} jlt_watch;

/** Begin at the stepper's point. A value counts as on the section within 1e-13 of jlt_locate_unit; of a function that the event
 *  gives, within 1e-13. */
void jlt_watch_begin(jlt_watch *self, const jlt_event *event, const jlt_stepper *stepper);

/** Find all crossings of the last step: list (JLT_CROSSINGS_MAX,), ascending in theta, on the polynomial and not yet refined.
 *  Directions not asked for are left out. Errors: NONFINITE, the polynomial of a state; those of partial steps. */
JLT_CHECKED jlt_status jlt_watch_step(jlt_watch *self, jlt_stepper *stepper, jlt_crossing *list, unsigned *count);

/** jlt_locate_refine for a crossing of the watch's last step. A crossing at theta 0 is placed at the stored zero, if there is one,
 *  possibly many steps back: theta is then negative. */
JLT_CHECKED jlt_status jlt_watch_refine(const jlt_watch *self, jlt_crossing *crossing, double *x, double *slope_work,
                                        jlt_stepper *stepper);

#endif
