/** Polynomials P that the motion multiplies by any polynomial or ratio, P' = K P with P not in the denominator of K (Darboux
 *  polynomials): their zeros are invariant.
 *
 *  Of degree at most N they all divide one polynomial, the extactic one: with v_i the monomials of degree 1 to N, the determinant
 *  of d^j v_i/dt^j, j = 1, 2, ... For the column of P, in place of one of its monomials, is divisible by P. It is factored over the
 *  rational functions of parameters: of what is irrational in them the product of its conjugates may show, of a degree beyond N,
 *  which may be an integral. Where the determinant is zero, and there alone, integrals that are rational functions make the v_i and
 *  1 linearly dependent: there is a rational integral, in the plane one of degree at most N, beyond it of any degree
 *  (J. V. Pereira, Ann. Inst. Fourier 51 (2001) 1385-1405; C. Christopher, J. Llibre, J. V. Pereira, Pacific J. Math. 229 (2007)
 *  63-117). */
#ifndef TTC_EXTACTIC_H
#define TTC_EXTACTIC_H

#include "discover/discover.h"
#include "discover/factor_list.h"

/** Those of degree 1, and up to 2 of two quantities, beside irreducible ones of higher degree that divide the extactic polynomial
 *  too: put into `out`, which must be initialized, and said as claims where they are not among the factors found before; integrals
 *  are remarked. Looked for where all quantities are independent of each other, up to five of them. That there are no others is
 *  said where all factors of the polynomial were looked at, and else why they were not. */
void ttc_extactic_find(ttc_discovery *d, ttc_factors *out);

#endif
