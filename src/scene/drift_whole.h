/** Drift of integrals along an orbit that starts on a section of a smaller table. The orbit is followed in all states of the asked
 *  model, since some of these integrals are parameters of the smaller table, which cannot drift. */
#ifndef JLT_SCENE_DRIFT_WHOLE_H
#define JLT_SCENE_DRIFT_WHOLE_H

#include "dynamics/drift.h"
#include "integrate/conserved.h"
#include "scene/tier.h"

typedef struct {
    jlt_instance *instance; /* owned */
    jlt_field field;
    jlt_conserved conserved;
    jlt_invariants invariants;
    unsigned watched[JLT_INVARIANTS_MAX]; /* (levels of the section,): the index of each among the invariants */
    unsigned column;                      /* the section is where this state has the value `level` */
    double level;
    double start[JLT_WAY_VALUES_MAX]; /* in the flow's units */
    int time;                         /* binary exponent of the flow's unit of time */
} jlt_drift_whole;

/** Find the state of the asked model at q, shape (dim,), a point of a section that tables describe, to start from. *out must not
 *  move in memory. Errors: UNSUPPORTED, the section is one of the asked table itself, or no single way leads to its table; those of
 *  the chart; NOMEM. */
JLT_CHECKED jlt_status jlt_drift_whole_open(jlt_drift_whole *out, const jlt_system *system, const double *q);
void jlt_drift_whole_close(jlt_drift_whole *self);

/** Measure the drift along the orbit from that start, as jlt_drift_section does. project: after every step put the state back onto
 *  the levels of the start. Errors: those of the orbit. */
JLT_CHECKED jlt_status jlt_drift_whole_follow(jlt_drift *drift, jlt_drift_end *end, const jlt_method *method,
                                              const jlt_drift_whole *whole, bool project);

#endif
