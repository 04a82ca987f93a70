/** Finds polynomials P with P' = K P, for any polynomial or ratio K whose denominator does not contain P (Darboux polynomials):
 *  their zero sets are invariant.
 *
 *  Those of degree at most N all divide the extactic polynomial, which is the determinant of d^j v_i/dt^j, j = 1, 2, ..., with v_i
 *  the monomials of degree 1 to N: put P in place of one of its monomials, and that column is divisible by P. The polynomial is
 *  factored over the rational functions of parameters, so a P that is irrational in them may show as the product of its
 *  conjugates, of a degree above N, which may be an integral. The determinant is zero if and only if the v_i and 1 are linearly
 *  dependent over the rational integrals: then there is a rational integral, in the plane one of degree at most N, in higher
 *  dimension of any degree (J. V. Pereira, Ann. Inst. Fourier 51 (2001) 1385-1405; C. Christopher, J. Llibre, J. V. Pereira,
 *  Pacific J. Math. 229 (2007) 63-117). */
#ifndef TTC_EXTACTIC_H
#define TTC_EXTACTIC_H

#include "discover/discover.h"
#include "discover/factor_list.h"

/** Find all such P of degree 1, or up to 2 if there are two quantities, and irreducible ones of higher degree that divide the
 *  extactic polynomial too. They are added to `out`, which must be initialized, and reported as claims unless they were found as
 *  factors before; integrals are remarked. Only for up to five quantities, none of which is a root. A remark says that there are no
 *  others if all factors of the polynomial were examined, else why they were not. */
void ttc_extactic_find(ttc_discovery *d, ttc_factors *out);

#endif
