/** Reconstructs rational functions of the parameters from their values in a prime field.
 *
 *  Cauchy interpolation in one parameter at a time gives the degrees in that parameter (J. von zur Gathen, J. Gerhard, Modern
 *  Computer Algebra, 5.8). Numerator and denominator with these degrees are then unique up to a factor, and follow by linear
 *  algebra; rational reconstruction gives their coefficients. Nothing here is a proof: results are proved elsewhere. */
#ifndef TTC_DEPENDENCE_H
#define TTC_DEPENDENCE_H

#include "discover/flow.h"

/* Compute the values of the functions at the given parameters; out: shape (count,). parameters, shape (variable_count,): entries
 * other than the parameters themselves may be overwritten. Returns false if the functions have no values there. */
typedef bool (*ttc_dependence_sampler)(void *context, ulong *out, ulong *parameters);

/** Find `count` functions; out: shape (count,), initialized. Returns false if the degree of some function is too high, if it has
 *  too many terms, is not rational, or could not be sampled. */
bool ttc_dependence_find(ttc_ratio *out, size_t count, const ttc_flow *flow, ttc_dependence_sampler sample, void *context,
                         uint64_t *source);

#endif
