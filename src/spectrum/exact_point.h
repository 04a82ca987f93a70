/** An equilibrium in exact numbers: evaluates the table's expressions in rational numbers extended by square roots. */
#ifndef JLT_SPECTRUM_EXACT_POINT_H
#define JLT_SPECTRUM_EXACT_POINT_H

#include "ext/ball_spectrum.h"
#include "ext/exact_matrix.h"
#include "spectrum/oracle.h"

/** If the field vanishes exactly at a point, compute and analyse the exact Jacobian there.
 *  Out: *matrix, to be destroyed with jlt_exact_matrix_destroy; NULL if the field does not vanish, or this arithmetic cannot
 *  decide it, because of more roots than JLT_SURD_ROOTS_MAX, a cosine of anything but zero, or numbers that are too long.
 *  In: params, x, in the table's order; family, the name of the family of equilibria whose formulas give those states that it
 *  binds and for which given[i] is 0, or NULL for none.
 *  Errors: NOMEM. Cost: one visit per node of the expressions. */
JLT_CHECKED jlt_status jlt_exact_point_linearize(jlt_exact_matrix **matrix, const jlt_oracle *oracle, const jlt_ball_value *params,
                                                 const jlt_ball_value *x, const char *family, const unsigned char *given);

#endif
