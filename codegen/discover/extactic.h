/** Polynomials P that the motion multiplies by any polynomial or ratio, P' = K P (Darboux polynomials): their zeros are invariant.
 *
 *  Of degree at most N they all divide one polynomial, the extactic one: with v_i the monomials of degree 1 to N, the determinant
 *  of d^j v_i/dt^j, j = 1, 2, ... For the column of P, in place of one of its monomials, is divisible by P. It is factored over the
 *  rational functions of parameters: what is irrational shows as the product of its conjugates. Where it is zero, there is a rational
 *  integral of degree at most N (J. V. Pereira, Ann. Inst. Fourier 51 (2001) 1385-1405; C. Christopher, J. Llibre, J. V. Pereira,
 *  Pacific J. Math. 229 (2007) 63-117). */
#ifndef TTC_EXTACTIC_H
#define TTC_EXTACTIC_H

#include "discover/discover.h"
#include "discover/factor_list.h"

/** Those of degree 1, and up to 2 of two quantities, beside irreducible ones of higher degree that divide the extactic polynomial
 *  too: said as claims where K is no function of parameters alone, and put into `out`, which must be initialized. Looked for where
 *  all quantities are independent of each other, up to five of them. */
void ttc_extactic_find(ttc_discovery *d, ttc_factors *out);

#endif
