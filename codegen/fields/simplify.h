/** Identities of roots that shorten sums. */
#ifndef TTC_SIMPLIFY_H
#define TTC_SIMPLIFY_H

#include "fields/field.h"

/** Two terms of a sum whose ratio is one of the monomials of r^2 = A + B become one: t + t B/A = t r^2/A,
 *  t - t r^2/A = -t B/A, t - t r^2/B = -t A/B. Radicands of two terms only; the top level of a sum only.
 *  TTC_NONE where the graph refuses. */
ttc_id ttc_simplify_roots(ttc_field *field, ttc_id sum);

#endif
