/** Finds numbers in a table that are too large or too small for a double. */
#ifndef TTC_WIDE_NUMBER_H
#define TTC_WIDE_NUMBER_H

#include "kernels/catalogue.h"

/** The first expression of the table with such a number; else the record of the first field in whose kernels one arose.
 *  False when there is none. */
bool ttc_find_wide_number(const ttc_catalogue *catalogue, ttc_place *place);

#endif
