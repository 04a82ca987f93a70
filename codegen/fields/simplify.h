/** Identities of roots that shorten sums, or keep their digits. */
#ifndef TTC_SIMPLIFY_H
#define TTC_SIMPLIFY_H

#include "fields/field.h"

/** Two terms of a sum whose ratio is one of the monomials of r^2 = A + B become one: t + t B/A = t r^2/A,
 *  t - t r^2/A = -t B/A, t - t r^2/B = -t A/B. Radicands of two terms only; the top level of a sum only.
 *  TTC_NONE where the graph refuses. */
ttc_id ttc_simplify_roots(ttc_field *field, ttc_id sum);

/** A sum in which terms of opposite signs nearly cancel, in a form in which none can, as far as there is one: terms are put
 *  over their common denominator, squares of roots are replaced by radicands, and what is left of the numerator after equal
 *  terms have gone must have one sign; or, with a root left over, A - B is (A^2 - B^2)/(A + B). Signs are those known of
 *  parameters, states and roots. A sum for which no such form is found stays as it is: nothing is ever made worse.
 *
 *  1/r - x^2/r^3 = (y^2 + z^2)/r^3 for r^2 = x^2 + y^2 + z^2;  1 - s = x^2/(1 + s) for s^2 = 1 - x^2.
 *  Source: N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 1.7-1.8.
 *  TTC_NONE where the graph refuses. */
ttc_id ttc_write_without_cancellation(ttc_field *field, ttc_id sum);

#endif
