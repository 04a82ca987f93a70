/** Newton's method for all points of a periodic orbit at once (multiple shooting), a trial at a time: the caller supplies the
 *  images of the trial points, so that many searches can go on side by side. Steps are halved until the residual falls. */
#ifndef JLT_DYNAMICS_NEWTON_H
#define JLT_DYNAMICS_NEWTON_H

#include "dynamics/shooting.h"

typedef struct {
    const jlt_chart *chart;
    const unsigned char *held;
    size_t period;
    double *points, *trial, *delta; /* (period, d) each, in one block; owned. trial: the points whose images are wanted; delta: the
                                       step, scaled */
    jlt_shooting now, then;         /* now: at points; then: at trial, for the caller to fill */
    unsigned iteration, halving;
    double factor;                  /* of delta in the trial */
    double first, noise;            /* the residual at the first points; one that errors of the map may cause, relative to |DP| */
    bool has_begun;
    double doubt;                   /* 0; or, where |DP| is so large that a small residual does not show an orbit, the factor by
                                       which errors of DP may make delta too small */
    jlt_status status;              /* of the whole search, once it has ended */
} jlt_newton;

/** Begin at points, shape (period, d); held: as jlt_periodic_find, which must live as long. Errors: NOMEM; *out is then empty. */
JLT_CHECKED jlt_status jlt_newton_create(jlt_newton *out, const jlt_flow *flow, const double *points, size_t period,
                                         const unsigned char *held);
void jlt_newton_clear(jlt_newton *self); /* legal on a zeroed one */

/** Take the next step. Before the call fill self->then with the images of self->trial. In: looked, JLT_OK if self->then was filled,
 *  else the reason. Returns true when the images of self->trial are wanted again; false when the search has ended: self->status
 *  says how, and self->points are the best points found. */
bool jlt_newton_next(jlt_newton *self, jlt_status looked);

#endif
