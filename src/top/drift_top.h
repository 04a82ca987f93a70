/** How E and G drift along an orbit of the spherical top that starts on its section, in the five states of (3.2) with s: there
 *  both are integrals, where the section's own kernel has G as a parameter. */
#ifndef JLT_TOP_DRIFT_TOP_H
#define JLT_TOP_DRIFT_TOP_H

#include "dynamics/drift.h"
#include "top/conserved.h"

enum { JLT_DRIFT_TOP_STATES = 6 };

typedef struct {
    jlt_instance *instance; /* owned */
    jlt_field field;
    jlt_conserved conserved;
    jlt_invariants invariants;          /* E, G, and the relation of s */
    unsigned column;                    /* the section is where this state vanishes */
    double start[JLT_DRIFT_TOP_STATES]; /* in the flow's units */
    int time;                           /* binary exponent of the flow's unit of time */
} jlt_drift_top;

/** system: on the section of spherical_top_level; q: shape (2,). *out must not move. Errors: UNSUPPORTED, the table is another; those of the
 *  chart; NOMEM. */
JLT_CHECKED jlt_status jlt_drift_top_open(jlt_drift_top *out, const jlt_system *system, const double *q);
void jlt_drift_top_close(jlt_drift_top *self);

/** As jlt_drift_section, from there. project: after every step back onto the levels of the start. Errors: those of the orbit.
 *  */
JLT_CHECKED jlt_status jlt_drift_top_follow(jlt_drift *drift, jlt_drift_end *end, const jlt_method *method,
                                            const jlt_drift_top *five, bool project);

#endif
