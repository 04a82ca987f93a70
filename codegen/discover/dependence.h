/** Rational functions of the parameters from their values in a prime field.
 *
 *  The degrees in each parameter are those of the rational function of it alone, by Cauchy's interpolation (J. von zur Gathen,
 *  J. Gerhard, Modern Computer Algebra, 5.8); numerator and denominator with these degrees are then unique, and found by linear
 *  algebra; their coefficients are rational numbers, by reconstruction. Nothing here is a proof: what is found is proved
 *  elsewhere. */
#ifndef TTC_DEPENDENCE_H
#define TTC_DEPENDENCE_H

#include "discover/flow.h"

/* Values of the functions at parameters, shape (count,) of which out receives; parameters, shape (variable_count,), may be written
 * to beyond the parameters themselves. False: there are none at these. */
typedef bool (*ttc_dependence_sampler)(void *context, ulong *out, ulong *parameters);

/** out: shape (count,), initialized. False: some function is of too high a degree, has too many terms, or is not rational. */
bool ttc_dependence_find(ttc_ratio *out, size_t count, const ttc_flow *flow, ttc_dependence_sampler sample, void *context,
                         uint64_t *source);

#endif
