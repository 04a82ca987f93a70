/** Whether a flow takes all states of a box to rest on a plane of equilibria, and how far they still go on the way.
 *
 *  The states are p, which vanish on the plane p = 0, and q. With f = 0 on it, f(p, q) = M p, M a mean of df/dp between (0, q) and
 *  (p, q), which an enclosure over a box B that holds both encloses. In the norm |p| = max |p_i|/w_i, w > 0, rows of M with
 *      M_ii + sum over j != i of |M_ij| w_j/w_i <= -a < 0
 *  give |p(tau)| <= |p(0)| exp(-a tau) while the motion stays in B, and then q_k moves by sum over j of |M_kj| w_j |p(0)|/a at
 *  most: where B has room for that, the motion stays in B for ever, p goes to 0 and q to a limit (G. Dahlquist's logarithmic norm,
 *  1958). */
#ifndef JLT_VALIDATED_SETTLE_H
#define JLT_VALIDATED_SETTLE_H

#include "validated/step.h"

typedef struct {
    bool *vanishes;     /* (dim,): which states are p */
    arb_ptr limit;      /* (dim,): 0 of these, enclosures of the limits of others */
    arf_struct *least;  /* lower bounds of the model's conditions all the way, (valid_count,) */
} jlt_settle_result;

/** Room for what jlt_settle finds. Ends with jlt_settle_result_clear. */
void jlt_settle_result_init(jlt_settle_result *self, const jlt_formulas *of);
void jlt_settle_result_clear(jlt_settle_result *self, const jlt_formulas *of);

/** Whether all motions from the box x, shape (dim,), come to rest so, in a time that lifts roots: p are these roots, which stay
 *  >= 0, and the states named besides by the smallest set of up to two that will do. step: of formulas without free parameters.
 *  Cost: dim^2/2 evaluations where there is no such plane. */
bool jlt_settle(jlt_settle_result *result, jlt_step *step, arb_srcptr x);

#endif
