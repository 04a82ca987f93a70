/** Attitude and track of the sphere from the quadratures (2.1).
 *
 *  With nu = (cos chi, sin chi) in the plane and tau = (sin chi, -cos chi), and tau = (cos spin, -sin spin, 0) in the body. */
#ifndef JLT_TOP_ATTITUDE_H
#define JLT_TOP_ATTITUDE_H

#include "top/top.h"

typedef struct {
    double axes[3][3];     /* rows: alpha, beta, gamma (the fixed axes x, y, z) in body components */
    double centre[2];      /* of mass, x and y */
    double contact[2];     /* of the sphere with the plane */
    double orthonormality; /* largest entry of |axes axes^T - 1| */
} jlt_attitude;

/** From precession chi and spin; s = sqrt(1 - gamma3^2) is given apart, so that it keeps its digits near a pole. */
void jlt_attitude_from_angles(jlt_attitude *out, const jlt_top *top, double gamma3, double s, double chi, double spin,
                              const double centre[2]);

/** From integrated axes, as they are. */
void jlt_attitude_from_axes(jlt_attitude *out, const jlt_top *top, const double axes[3][3], const double centre[2]);

#endif
