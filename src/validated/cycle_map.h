/** Inside of cycle.c and homoclinic.c: one leg of an orbit, from the section to the section, its equations, and its map on the
 *  levels. */
#ifndef JLT_VALIDATED_CYCLE_MAP_H
#define JLT_VALIDATED_CYCLE_MAP_H

#include "validated/cycle.h"

struct jlt_cycle {
    const jlt_cycle_question *question;
    jlt_formulas *formulas;
    jlt_step *step;
    jlt_jets *levels;     /* of the program of integrals, order 0 */
    unsigned unknowns;    /* of a point: states - 1 */
    arb_ptr state;        /* (dim,) */
    jlt_arrival arrival;
};

/* The state that unknown i of a point is. */
unsigned jlt_cycle_map_state(const jlt_cycle *self, unsigned i);

/** Arrival from y, shape (unknowns,), crossing in this direction: fills self->state and self->arrival. turns: by how much states
 *  have grown there that is taken off, shape (states,), the section's too; NULL: nothing is. */
JLT_CHECKED jlt_status jlt_cycle_map_arrive(jlt_cycle *self, arb_srcptr y, const arf_t instant, int direction, arb_srcptr turns);

/** The part that this arrival has in G and DG, where they are zero before: from row on, P_q(y) - q of next, then F(y) - c; y begins
 *  at column from, next at column to, and may be y. In: y, where the arrival was from, and next, shape (unknowns,). */
void jlt_cycle_map_equations(jlt_cycle *self, arb_mat_t G, arb_mat_t DG, slong row, slong from, slong to, arb_srcptr y,
                             arb_srcptr next, const unsigned *kept);

/** F(y) - c alone, and its gradients, from row on. */
void jlt_cycle_map_level_equations(jlt_cycle *self, arb_mat_t G, arb_mat_t DG, slong row, slong from, arb_srcptr y);

/** The derivative of the arrival from y in the kept coordinates, D, shape (kept, kept). False where the integrals do not determine
 *  the states left out all over y. */
bool jlt_cycle_map_restrict(jlt_cycle *self, arb_mat_t D, arb_srcptr y, const unsigned *kept);

/** Whether the states left out of an arrival whose kept states are those of next are those of next as well: see the opening of
 *  cycle.h. */
bool jlt_cycle_map_meets(jlt_cycle *self, arb_srcptr next, const unsigned *kept);

/** Derivatives of the states left out by those kept, -F_w^-1 F_q, (level_count, kept), over the box y; false where F_w may be
 *  singular. */
bool jlt_cycle_map_solve_levels(jlt_cycle *self, arb_mat_t slope, arb_srcptr y, const unsigned *kept);

/** Whether a state is one of the coordinates kept. */
bool jlt_cycle_map_is_kept(const jlt_cycle *self, unsigned state, const unsigned *kept);

/** Gradients of the integrals at y, by unknowns: (level_count, unknowns); values, (level_count,), or NULL. */
void jlt_cycle_map_gradients(jlt_cycle *self, arb_mat_t gradients, arb_ptr values, arb_srcptr y);

#endif
