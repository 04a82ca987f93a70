/** Arrays that grow by one item at a time and need no capacity beside their count. */
#ifndef TTC_ARRAY_H
#define TTC_ARRAY_H

#include <stddef.h>

/** Room for one more item of `size` bytes in an array that holds `count` and has had all of them by this function: the array,
 *  moved or not. NULL: memory is out, and the array is as it was. Cost: constant on average, since room doubles. */
void *ttc_array_more(void *array, size_t count, size_t size);

#endif
