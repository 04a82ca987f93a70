/** An orbit that starts on the section of the spherical top, in the five states of (3.2) with s: there both E and G are integrals,
 *  where the section's own kernel has G as a parameter. */
#ifndef JLT_TOP_TOP_FIVE_H
#define JLT_TOP_TOP_FIVE_H

#include "dynamics/system.h"
#include "top/conserved.h"

enum { JLT_TOP_FIVE_STATES = 6 };

typedef struct {
    jlt_instance *instance; /* owned */
    jlt_field field;
    jlt_conserved conserved;
    jlt_invariants invariants;         /* E, G, and the relation of s */
    unsigned column;                   /* the section is where this state vanishes */
    double start[JLT_TOP_FIVE_STATES]; /* in the flow's units */
    int time;                          /* binary exponent of the flow's unit of time */
} jlt_top_five;

/** system: on the section of spherical_top_level; q: shape (2,). *out must not move. Errors: UNSUPPORTED, the table is another; those of the chart; NOMEM. */
JLT_CHECKED jlt_status jlt_top_five_open(jlt_top_five *out, const jlt_system *system, const double *q);
void jlt_top_five_close(jlt_top_five *self);

/** The pole at which an orbit has ended, +1 or -1. x: shape (JLT_TOP_FIVE_STATES,). */
int jlt_top_five_side(const double *x);

#endif
