/** Whether functions depend on each other: by their gradients at one point. */
#ifndef TTC_GRADIENT_H
#define TTC_GRADIENT_H

#include "discover/span.h"

/** True: no function relates `value` to those known; this is certain. False: one does, or the point was an unlucky one.
 *  Exponentials and logarithms are taken for independent of their arguments. parameters: as everywhere, those of the point. */
bool ttc_gradient_is_new(const ttc_flow *flow, const ttc_knowns *knowns, const ttc_ratio *value, ulong *parameters,
                         uint64_t *source);

#endif
