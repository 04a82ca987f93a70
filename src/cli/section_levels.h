/** Whether orbits of a section keep the integrals that their table proves: where one passes close to a singularity, errors grow
 *  beyond what the tolerance says of an ordinary return. */
#ifndef JLT_CLI_SECTION_LEVELS_H
#define JLT_CLI_SECTION_LEVELS_H

#include "dynamics/section.h"
#include "dynamics/system.h"

/** Private: a row, and all integrals there, shape (integrals,). */
typedef struct {
    size_t number;
    double x[JLT_CHART_STATES_MAX], *values;
} jlt_section_levels_row;

/** Private; zeroed, it watches nothing. */
typedef struct {
    const jlt_system *system;
    unsigned count, watched[JLT_INVARIANTS_MAX]; /* integrals, by their indices in the kernel */
    double *now, *gradients;                     /* of all integrals: at this row; shape (integrals, states). The first owns the
                                                    memory of all values */
    jlt_section_levels_row first, last;          /* of the orbit, so far */
    double size;                                 /* of the orbit (integrate/field.h) */
    struct {
        double share, change; /* of the integral: in errors of one tolerance in every state and return, and itself */
        unsigned integral;
        size_t orbit, number, returns; /* since `from` */
        double from[JLT_CHART_STATES_MAX], to[JLT_CHART_DIM_MAX];
    } worst; /* share 0: there is none */
} jlt_section_levels;

/** Watch the integrals that the system's table proves and that no turn of the section's angle changes; q: a point of the section,
 *  shape (dim,). Errors: NOMEM; as jlt_drift_turns. */
JLT_CHECKED jlt_status jlt_section_levels_open(jlt_section_levels *out, const jlt_system *system, const double *q);
void jlt_section_levels_close(jlt_section_levels *self);

/** Take a row of orbit number `orbit` into account: its start, number 0, or a later one; returns between may be left out. Returns
 *  whether an integral has changed, since the row before or since the start, by more than errors of one tolerance a step
 *  explain. */
bool jlt_section_levels_note(jlt_section_levels *self, size_t orbit, const jlt_return *at);

/** If an integral has changed by so much, say so, and by how much the worst return differs at another tolerance. */
void jlt_section_levels_tell(const jlt_section_levels *self, int time_direction);

#endif
