/** Rewriting of sums: with fewer terms by identities of roots, and without cancellation. */
#ifndef TTC_SIMPLIFY_H
#define TTC_SIMPLIFY_H

#include "fields/field.h"

/** Merge pairs of terms of a sum by a root r with a radicand of two terms, r^2 = A + B: t + t B/A = t r^2/A, t - t r^2/A = -t B/A,
 *  t - t r^2/B = -t A/B. Terms of sums within the sum are not merged. Returns TTC_NONE if the graph fails. */
ttc_id ttc_simplify_roots(ttc_field *field, ttc_id sum);

/** Rewrite a sum in which terms of opposite signs may nearly cancel so that fewer or none can: terms are put over their common
 *  denominator and squares of roots replaced by radicands, so that the remaining terms of the numerator have one sign; or, if a
 *  root remains, A - B is written as (A^2 - B^2)/(A + B). Signs are those known of parameters, states and roots. Returns the
 *  sum itself if no such form is found.
 *
 *  1/r - x^2/r^3 = (y^2 + z^2)/r^3 for r^2 = x^2 + y^2 + z^2;  1 - s = x^2/(1 + s) for s^2 = 1 - x^2.
 *  Source: N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 1.7-1.8.
 *  Returns TTC_NONE if the graph fails or memory is out. */
ttc_id ttc_write_without_cancellation(ttc_field *field, ttc_id sum);

#endif
