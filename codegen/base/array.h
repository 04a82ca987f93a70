/** Arrays that grow by one item at a time; their capacity follows from their count and is not stored. */
#ifndef TTC_ARRAY_H
#define TTC_ARRAY_H

#include <stddef.h>

/** Make room for one more item of `size` bytes in an array that holds `count` items, each of which was added through this
 *  function; array is NULL when count is 0. Returns the array, which may have moved; NULL when memory is out, and then the
 *  array is unchanged. Cost: amortized constant, as the capacity doubles. */
void *ttc_array_more(void *array, size_t count, size_t size);

#endif
