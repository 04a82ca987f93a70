/** Finds numbers in a table that are too large or too small for a double. */
#ifndef TTC_WIDE_NUMBER_H
#define TTC_WIDE_NUMBER_H

#include "kernels/catalogue.h"

/** Set *place to the first expression of the table with such a number, or to the record of the first field whose kernels have one.
 *  Returns false if there is none, or when memory is out. */
bool ttc_find_wide_number(const ttc_catalogue *catalogue, ttc_place *place);

#endif
