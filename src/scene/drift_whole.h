/** Drift of integrals along an orbit that starts on a section of a smaller table. The orbit is followed in all states of the asked
 *  model, since some of its integrals are parameters of the smaller table, which cannot drift. */
#ifndef JLT_SCENE_DRIFT_WHOLE_H
#define JLT_SCENE_DRIFT_WHOLE_H

#include "dynamics/drift.h"
#include "integrate/conserved.h"
#include "scene/tier.h"

typedef struct {
    jlt_instance *instance; /* in the flow's units; owned */
    jlt_instance *told;     /* in the table's; owned */
    jlt_field field;
    jlt_conserved conserved;
    jlt_invariants kept;    /* after every step the state is put back onto the start's levels of these; at first none */
    unsigned column;        /* the section is where this state has the value `level` */
    double level;
    double start[JLT_WAY_VALUES_MAX]; /* in the flow's units */
    jlt_units units;                  /* of the flow */
} jlt_drift_whole;

/** Find the state of the asked model at q, shape (dim,), a point of a section that tables describe, to start from, and the most
 *  special field of that model for its parameters. *out must not move in memory. Errors: UNSUPPORTED, the section is one of the
 *  asked table itself, no single way leads to its table, or the section's state is none of the asked table, or an angle; those of
 *  the chart; NOMEM. */
JLT_CHECKED jlt_status jlt_drift_whole_open(jlt_drift_whole *out, const jlt_system *system, const double *q);
void jlt_drift_whole_close(jlt_drift_whole *self);

/** After every step put the state back onto the start's levels of all integrals. Errors: as jlt_conserved_of. */
JLT_CHECKED jlt_status jlt_drift_whole_project(jlt_drift_whole *self);

/** Measure the drift of integrals of the field along the orbit from that start, as jlt_drift_section does. Errors: NOMEM; those of
 *  the orbit. */
JLT_CHECKED jlt_status jlt_drift_whole_follow(jlt_drift *drift, jlt_drift_end *end, const jlt_method *method,
                                              const jlt_drift_whole *whole);

#endif
