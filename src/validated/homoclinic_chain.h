/** Shared by homoclinic.c and homoclinic_make.c: the unstable manifold near the saddle, and the equations of the orbit. */
#ifndef JLT_VALIDATED_HOMOCLINIC_CHAIN_H
#define JLT_VALIDATED_HOMOCLINIC_CHAIN_H

#include "validated/cycle_map.h"
#include "validated/homoclinic.h"

typedef struct {
    jlt_cycle *of;
    const jlt_homoclinic_question *question;
    unsigned flipped;          /* the kept state that the reversor flips */
    arb_ptr saddle;            /* (unknowns,), encloses the saddle */
    arb_mat_t inverse;         /* of the frame, (2, 2) */
    arb_ptr own_instants;      /* (legs,), copies of the question's */
    bool adjusts;              /* own_instants are set to the times of arrival */
    /* results of the last evaluation: */
    bool inside;               /* x_0 has |u| < reach */
    bool meets;                /* the legs meet */
    bool goes_on;              /* each leg takes positive time */
    arb_t start;               /* u of x_0 */
    arb_mat_t DG, landing;     /* (n, n); derivative of the last arrival by its start, (states, unknowns) */
    arb_ptr point;             /* (dim,), the last arrival */
    arf_struct least[JLT_ARRIVAL_VALIDS_MAX];
} jlt_homoclinic_chain;

/** Initialize the chain. In any case the caller must call jlt_homoclinic_chain_clear. Returns false if the frame is singular, or
 *  unless the reversor flips the section's state, whose value there must be 0, and exactly one other state, which must be kept.
 *  In: saddle, shape (unknowns,), copied. */
bool jlt_homoclinic_chain_init(jlt_homoclinic_chain *self, jlt_cycle *of, const jlt_homoclinic_question *question,
                               arb_srcptr saddle);
void jlt_homoclinic_chain_clear(jlt_homoclinic_chain *self);

/** The derivative of P over N in the frame, A, shape (2, 2), and the box around N, shape (unknowns,). *determined: the levels are
 *  proved to determine the other states all over the box. Errors: as jlt_arrival_compute. */
JLT_CHECKED jlt_status jlt_homoclinic_chain_local(jlt_homoclinic_chain *self, arb_mat_t A, arb_ptr around, bool *determined);

/** Whether A maps the cone into its interior and expands |u|. */
bool jlt_homoclinic_chain_is_cone(const jlt_homoclinic_chain *self, const arb_mat_t A);

/** The equations, legs*unknowns many, for krawczyk.h. They borrow the chain. */
jlt_krawczyk jlt_homoclinic_chain_equations(jlt_homoclinic_chain *self);

#endif
