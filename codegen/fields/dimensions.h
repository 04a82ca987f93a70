/** Dimensional analysis of a field, with the units that its table gives: powers of kg, m and s; other names count as numbers. */
#ifndef TTC_DIMENSIONS_H
#define TTC_DIMENSIONS_H

#include "fields/field.h"

/** Returns true if the field has the same form in all systems of units: terms of every sum have equal dimensions, arguments of
 *  functions have none, each rate has the dimension of its state over that of time, ends of intervals that some field has as
 *  conditions (ends.h) that of their state; conditions of the domain and the expressions of these claims, shape (count,), are
 *  consistent in themselves. Numbers
 *  are dimensionless, so that one which stands for a length is noticed. False also when memory is out. Cost: one visit a node. */
bool ttc_dimensions_agree(ttc_field *field, const uint32_t *claims, size_t count);

#endif
