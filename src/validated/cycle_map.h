/** Shared by cycle.c and homoclinic.c: one leg of an orbit from section to section, its equations, and its map on the levels. */
#ifndef JLT_VALIDATED_CYCLE_MAP_H
#define JLT_VALIDATED_CYCLE_MAP_H

#include "validated/cycle.h"

struct jlt_cycle {
    const jlt_cycle_question *question;
    jlt_formulas *formulas;
    jlt_step *step;
    jlt_jets *levels;     /* the program of integrals, order 0 */
    unsigned unknowns;    /* number of unknowns of a point: states - 1 */
    arb_ptr state;        /* (dim,): states and free parameters */
    jlt_arrival arrival;
};

/* The index of the state that unknown i of a point is. */
unsigned jlt_cycle_map_state(const jlt_cycle *self, unsigned i);

/** Compute the arrival from y, shape (unknowns,), crossing in this direction: sets self->state and self->arrival. turns: multiples
 *  of periods, shape (states,), the section's state included, that are subtracted from the state of arrival; NULL: none. */
JLT_CHECKED jlt_status jlt_cycle_map_arrive(jlt_cycle *self, arb_srcptr y, const arf_t instant, int direction, arb_srcptr turns);

/** Add the equations of this arrival to G and DG, which are zero there before: from `row` on, P_q(y) - q of next, then F(y) - c.
 *  The columns of y begin at `from`, those of next, which may be y, at `to`. In: y, the start of the arrival, and next, shape
 *  (unknowns,). */
void jlt_cycle_map_equations(jlt_cycle *self, arb_mat_t G, arb_mat_t DG, slong row, slong from, slong to, arb_srcptr y,
                             arb_srcptr next, const unsigned *kept);

/** Set the equations F(y) - c alone, and the gradients of F, from `row` on. */
void jlt_cycle_map_level_equations(jlt_cycle *self, arb_mat_t G, arb_mat_t DG, slong row, slong from, arb_srcptr y);

/** The derivative D of the arrival from y in the kept coordinates, shape (kept, kept). Returns false if the integrals are not
 *  proved to determine the other states all over y. */
bool jlt_cycle_map_restrict(jlt_cycle *self, arb_mat_t D, arb_srcptr y, const unsigned *kept);

/** Whether the states left out of the arrival equal those of next, provided that the kept states do: see the opening of cycle.h. */
bool jlt_cycle_map_meets(jlt_cycle *self, arb_srcptr next, const unsigned *kept);

/** Derivatives of the states left out by the kept ones, -F_w^-1 F_q, shape (level_count, kept), over the box y. Returns false if
 *  F_w may be singular. */
bool jlt_cycle_map_solve_levels(jlt_cycle *self, arb_mat_t slope, arb_srcptr y, const unsigned *kept);

/** Whether a state is one of the kept coordinates. */
bool jlt_cycle_map_is_kept(const jlt_cycle *self, unsigned state, const unsigned *kept);

/** Gradients of the integrals by the unknowns at y, shape (level_count, unknowns); their values, shape (level_count,), or NULL. */
void jlt_cycle_map_gradients(jlt_cycle *self, arb_mat_t gradients, arb_ptr values, arb_srcptr y);

#endif
