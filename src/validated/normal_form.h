/** Normal form of a map of the plane at an elliptic fixed point.
 *
 *  With |trace| < 2, lambda = exp(i alpha), 0 < alpha < pi, and z the coordinate along lambda's eigenvector such that the first
 *  coordinate of the plane is Re z, the map is
 *      z -> lambda z + sum of h_jk z^j conj(z)^k,  2 <= j + k.
 *  If lambda^k != 1 for k = 1 .. 4, a polynomial change of z makes this lambda z (1 + d |z|^2) + O(|z|^4), with
 *      lambda d = h_20 h_11 (2 lambda - 3 + 1/lambda)/((lambda^2 - lambda)(1/lambda - 1)) + |h_11|^2/(1 - 1/lambda)
 *                 + 2 |h_02|^2/(lambda^2 - 1/lambda) + h_21.
 *  A map that is reversible or area-preserving has Re d = 0: circles of radius r turn by alpha + r^2 Im d. This is not assumed
 *  here; only det = 1 is.
 *
 *  Source: Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed., 2004, 4.7. */
#ifndef JLT_VALIDATED_NORMAL_FORM_H
#define JLT_VALIDATED_NORMAL_FORM_H

#include "ext/scoped.h"

typedef struct {
    arb_t twist;  /* Im d: increase of the rotation angle per return, divided by the square of the first coordinate's amplitude */
    arb_t growth; /* Re d */
} jlt_normal_form;

void jlt_normal_form_init(jlt_normal_form *self); /* release with jlt_normal_form_clear */
void jlt_normal_form_clear(jlt_normal_form *self);

/** Compute twist and growth. In: map, shape (2, 10), coefficients of u^i v^j of both coordinates, in the order of jets.h, of which
 *  those of degree 0 are ignored; trace, of its linear part, |trace| < 2. A result without an enclosure is not finite. */
void jlt_normal_form_compute(jlt_normal_form *self, arb_srcptr map, const arb_t trace, slong bits);

#endif
