/** Inside of homoclinic.c and homoclinic_make.c: the unstable manifold near the saddle, and the equations of the orbit. */
#ifndef JLT_VALIDATED_HOMOCLINIC_CHAIN_H
#define JLT_VALIDATED_HOMOCLINIC_CHAIN_H

#include "validated/cycle_map.h"
#include "validated/homoclinic.h"

typedef struct {
    jlt_cycle *of;
    const jlt_homoclinic_question *question;
    unsigned flipped;          /* state */
    arb_ptr saddle;            /* (unknowns,), encloses it */
    arb_mat_t inverse;         /* of the frame, (2, 2) */
    arb_ptr own_instants;      /* (legs,), copies */
    bool adjusts;              /* instants follow the arrivals */
    /* of the evaluation last made: */
    bool inside;               /* x_0 has |u| < reach */
    bool meets;                /* the legs meet */
    bool goes_on;              /* each takes time */
    arb_t start;               /* u of x_0 */
    arb_mat_t DG, landing;     /* (n, n); derivative of the last arrival in its start, (states, unknowns) */
    arb_ptr point;             /* (dim,), the last arrival */
    arf_struct least[JLT_ARRIVAL_VALIDS_MAX];
} jlt_homoclinic_chain;

/** Set up the chain. Ends with _clear in any case. False: the frame is singular, or the reversor does not flip the section's state,
 *  which is 0 there, and exactly one of the kept states. In: saddle, shape (unknowns,), copied. */
bool jlt_homoclinic_chain_init(jlt_homoclinic_chain *self, jlt_cycle *of, const jlt_homoclinic_question *question,
                               arb_srcptr saddle);
void jlt_homoclinic_chain_clear(jlt_homoclinic_chain *self);

/** The derivative of P over N in the frame, A, shape (2, 2); and the box around N, shape (unknowns,). *regular: the levels
 *  determine the states left out all over it. Errors: as jlt_arrival_compute. */
JLT_CHECKED jlt_status jlt_homoclinic_chain_local(jlt_homoclinic_chain *self, arb_mat_t A, arb_ptr around, bool *regular);

/** Whether the cone is mapped into its interior, and its directions grow. */
bool jlt_homoclinic_chain_is_cone(const jlt_homoclinic_chain *self, const arb_mat_t A);

/** The equations, of krawczyk.h: of shape (legs*unknowns,). Borrows the chain. */
jlt_krawczyk jlt_homoclinic_chain_equations(jlt_homoclinic_chain *self);

#endif
