/** Attitude and track of the sphere, as the larger tables of the top tell them: by the quadratures (2.1), or by all vectors' components.
 *
 *  With nu = (cos chi, sin chi) in the plane and tau = (sin chi, -cos chi), and tau = (cos spin, -sin spin, 0) in the body. */
#ifndef JLT_TOP_ATTITUDE_H
#define JLT_TOP_ATTITUDE_H

#include <stdbool.h>

#include "top/top.h"

typedef struct {
    double axes[3][3];     /* rows: alpha, beta, gamma (the fixed axes x, y, z) in body components */
    double centre[2];      /* of mass, x and y */
    double contact[2];     /* of the sphere with the plane */
    double orthonormality; /* largest entry of |axes axes^T - 1| */
} jlt_attitude;

/** Whether states of this table tell the attitude: it has, by their names, chi, spin, x, y beside gamma3, or the components of alpha, beta,
 *  gamma and x, y. NULL is legal. */
bool jlt_attitude_is_told(const jlt_descriptor *table);

/** The attitude at y, shape (field->state_count,), of a field of such a table; the top has its parameters, in the units of y. */
void jlt_attitude_of(jlt_attitude *out, const jlt_top *top, const jlt_descriptor *field, const double *y);

#endif
