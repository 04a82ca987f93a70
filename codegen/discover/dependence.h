/** Reconstructs rational functions of the parameters from values in a prime field.
 *
 *  Cauchy interpolation in one parameter at a time gives the degrees (J. von zur Gathen, J. Gerhard, Modern Computer Algebra,
 *  5.8). Numerator and denominator of these degrees are unique up to a factor, and follow by linear algebra; rational
 *  reconstruction gives their coefficients. Nothing here is a proof: results are proved elsewhere. */
#ifndef TTC_DEPENDENCE_H
#define TTC_DEPENDENCE_H

#include "discover/flow.h"

/* out = values of the functions at the given parameters, shape (count,). parameters, shape (variable_count,): other entries may be
 * overwritten. Returns false if there are no values. */
typedef bool (*ttc_dependence_sampler)(void *context, ulong *out, ulong *parameters);

/** out: shape (count,), initialized. Returns false if some function has too high a degree or too many terms, is not rational, or
 *  has no values. */
bool ttc_dependence_find(ttc_ratio *out, size_t count, const ttc_flow *flow, ttc_dependence_sampler sample, void *context,
                         uint64_t *source);

#endif
