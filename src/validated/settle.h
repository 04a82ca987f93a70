/** Proves that a flow takes all states of a box to equilibria, and bounds how far the states still move on the way.
 *
 *  The states are split into p, which tend to 0, and q, which tend to limits. Let f vanish wherever p = 0. By the mean value
 *  theorem f(p, q) = M p, where M lies in any enclosure of df/dp over a convex box B that contains (0, q) and (p, q). Let w > 0 be
 *  weights, and |p| = max |p_i|/w_i. If all rows of M that belong to p satisfy
 *      M_ii + sum over j != i of |M_ij| w_j/w_i <= -a < 0,
 *  then |p(tau)| <= |p(0)| exp(-a tau) as long as the motion stays in B (G. Dahlquist's logarithmic norm, 1958). In all that time
 *  q_k moves by at most the sum over j of |M_kj| w_j |p(0)|/a. If B has that much room, the motion never leaves it. */
#ifndef JLT_VALIDATED_SETTLE_H
#define JLT_VALIDATED_SETTLE_H

#include "validated/step.h"

typedef struct {
    bool *vanishes;    /* (dim,): the states p */
    arb_ptr limit;     /* (dim,): enclosures of the limits, exactly 0 for p */
    arf_struct *least; /* (valid_count,): lower bounds of the model's conditions on the way */
} jlt_settle_result;

/** Allocate the result of jlt_settle; free it with jlt_settle_result_clear. */
void jlt_settle_result_init(jlt_settle_result *self, const jlt_formulas *of);
void jlt_settle_result_clear(jlt_settle_result *self, const jlt_formulas *of);

/** Returns true if all motions from the box x, shape (dim,), are shown to settle. step: made of jlt_formulas_create_lifted. The
 *  states p are the lifted roots, which stay positive, and the fewest of the table's states, at most two, for which the proof
 *  succeeds. Cost: up to dim^2/2 evaluations of the field with its derivatives if it does not succeed. */
bool jlt_settle(jlt_settle_result *result, jlt_step *step, arb_srcptr x);

#endif
