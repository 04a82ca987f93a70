/** Finds polynomials P with P' = K P, K any polynomial or ratio without P in its denominator (Darboux polynomials): their zero
 *  sets are invariant.
 *
 *  Those of degree at most N divide one polynomial, the extactic polynomial: the determinant of d^j v_i/dt^j, j = 1, 2, ..., where
 *  the v_i are the monomials of degree 1 to N. In it, the column of a monomial of P may be replaced by the derivatives of P, which
 *  are all divisible by P. It is factored over the rational functions of parameters: a P that is irrational in them may show as the
 *  product of its conjugates, of a degree above N, which may be an integral. The determinant is zero if and only if the v_i and 1
 *  are linearly dependent over the rational integrals: there is then a rational integral, in the plane of degree at most N, in
 *  higher dimension of any degree (J. V. Pereira, Ann. Inst. Fourier 51 (2001) 1385-1405; C. Christopher, J. Llibre, J. V. Pereira,
 *  Pacific J. Math. 229 (2007) 63-117). */
#ifndef TTC_EXTACTIC_H
#define TTC_EXTACTIC_H

#include "discover/discover.h"
#include "discover/factor_list.h"

/** Find such P of degree 1, or up to 2 if there are two quantities, and whatever irreducible P of higher degree divides the
 *  extactic polynomial as well. Each is added to `out`, which must be initialized, and reported as a claim unless it was found
 *  before; integrals are only remarked. For up to five quantities without roots. A remark says that there are no others if all
 *  factors of the extactic polynomial were examined, else why they were not. */
void ttc_extactic_find(ttc_discovery *d, ttc_factors *out);

#endif
