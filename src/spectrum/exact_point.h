/** An equilibrium in exact numbers: the table's expressions at rational values, with square roots. */
#ifndef JLT_SPECTRUM_EXACT_POINT_H
#define JLT_SPECTRUM_EXACT_POINT_H

#include "ext/ball_spectrum.h"
#include "ext/exact_matrix.h"
#include "spectrum/oracle.h"

/** The Jacobian at a point, analysed, where the field vanishes there, exactly.
 *  Out: *matrix, for jlt_exact_matrix_destroy; NULL where this cannot tell: the field does not vanish, or roots and functions
 *  stand in the way (more roots than JLT_SURD_ROOTS_MAX, a cosine of anything but zero, numbers of too many digits).
 *  In: params, x, in the table's order; family, the table's family of equilibria that gives the states it binds where given[i] is
 *  0, or NULL for none.
 *  Errors: NOMEM. Cost: one visit a node of the expressions. */
JLT_CHECKED jlt_status jlt_exact_point_linearize(jlt_exact_matrix **matrix, const jlt_oracle *oracle, const jlt_ball_value *params,
                                                 const jlt_ball_value *x, const char *family, const unsigned char *given);

#endif
