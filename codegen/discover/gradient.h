/** Tests whether functions depend on each other, by their gradients at one point. */
#ifndef TTC_GRADIENT_H
#define TTC_GRADIENT_H

#include "discover/span.h"

/** Returns true if no function relates `value` to the known ones, which is certain; false if one does, or the point was an unlucky
 *  one. Exponentials and logarithms count as independent of their arguments. parameters: as in ttc_flow_draw. */
bool ttc_gradient_is_new(const ttc_flow *flow, const ttc_knowns *knowns, const ttc_ratio *value, ulong *parameters,
                         uint64_t *source);

#endif
