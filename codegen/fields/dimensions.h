/** Dimensions of what a field is made of, from the units that its table gives: powers of kg, m and s; other names are numbers. */
#ifndef TTC_DIMENSIONS_H
#define TTC_DIMENSIONS_H

#include "fields/field.h"

/** True when the field is the same equations in whatever multiples of kg, m and s its quantities are counted: every sum adds up
 *  like to like, functions are of numbers, each rate has the dimension of its state over that of time; so have ends of intervals
 *  that are expressions, conditions of the domain, and the expressions of these claims, shape (count,), a dimension. A number has
 *  none, so that one which stands for a length is found out. False also when memory is out. Cost: one visit a node. */
bool ttc_dimensions_agree(ttc_field *field, const uint32_t *claims, size_t count);

#endif
