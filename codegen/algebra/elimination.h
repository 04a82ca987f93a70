/** Proofs that polynomial conditions have no point, by identities that eliminate variables, without a solver. */
#ifndef TTC_ELIMINATION_H
#define TTC_ELIMINATION_H

#include "algebra/conditions.h"

/** Returns true if the last condition of another relation than NONZERO is shown to contradict the others; false says nothing. To
 *  contradict f > 0, for example, -f is shown to be not negative. A polynomial f is shown to be positive, or not negative, by the
 *  signs of its factors; one factor of unknown sign may be left, to which these rules are applied in turn:
 *  - a v^2 + b v + c is positive if a and 4 a c - b^2 are, as the minors of a quadratic form that is positive definite (Sylvester);
 *  - if a condition states g >= 0, choose m > 0 and k >= 0 such that the highest powers of a variable in m f and k g cancel: f is
 *    positive if m f - k g is. If the sign of k is not known, the cases k >= 0 and k <= 0 are shown separately, each by its own g.
 *  Cost: at most some 1000 polynomials of up to 64 terms are examined for each number of conditions g in use, 0 to 2. */
bool ttc_elimination_excludes(const ttc_conditions *conditions);

#endif
