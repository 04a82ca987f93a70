/** Arrays that grow by one item at a time, whose capacity follows from their count and is not stored; lists of numbers. */
#ifndef TTC_ARRAY_H
#define TTC_ARRAY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Make room for one more item in an array that holds `count` items, each of which was added through this macro. array: a variable
 *  or member that points to the items, NULL at first; it is set anew, as items may move. False when memory is out, and
 *  then the array is unchanged. Cost: amortized constant, as the capacity doubles. */
#define TTC_ARRAY_GROW(array, count) ttc_array_grow(&(array), count, sizeof *(array))

/* The same, for the macro alone; place: where the pointer is; size: of an item, in bytes. */
bool ttc_array_grow(void *place, size_t count, size_t size);

/* Whether a list, shape (count,), has this number. */
bool ttc_array_has(const uint32_t *list, size_t count, uint32_t number);

#endif
