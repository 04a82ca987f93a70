/** Inside of cycle.c: the equations of a periodic orbit, and the map on the levels. */
#ifndef JLT_VALIDATED_CYCLE_MAP_H
#define JLT_VALIDATED_CYCLE_MAP_H

#include "validated/cycle.h"

struct jlt_cycle {
    const jlt_cycle_question *question;
    jlt_formulas *formulas;
    jlt_step *step;
    jlt_jets *levels;     /* of the program of integrals, order 0 */
    unsigned unknowns;    /* states - 1 */
    arb_ptr state;        /* (dim,) */
    jlt_arrival arrival;
};

/* The state that unknown i is. */
unsigned jlt_cycle_map_state(const jlt_cycle *self, unsigned i);

/** Arrival from y, shape (unknowns,): fills self->state and self->arrival. */
JLT_CHECKED jlt_status jlt_cycle_map_arrive(jlt_cycle *self, arb_srcptr y, const arf_t instant);

/** G, shape (unknowns, 1), where that arrival was from, whose states stand in y; and DG, shape (unknowns, unknowns). */
void jlt_cycle_map_equations(jlt_cycle *self, arb_mat_t G, arb_mat_t DG, arb_srcptr y, const unsigned *kept);

/** The derivative in the kept coordinates, D, shape (kept, kept), and whether the states left out come back to what they were: see
 *  the opening of cycle.h. False where that is not shown. */
bool jlt_cycle_map_restrict(jlt_cycle *self, arb_mat_t D, arb_srcptr y, const unsigned *kept);

/** Gradients of the integrals at y, by unknowns: (level_count, unknowns); values, (level_count,), or NULL. */
void jlt_cycle_map_gradients(jlt_cycle *self, arb_mat_t gradients, arb_ptr values, arb_srcptr y);

#endif
