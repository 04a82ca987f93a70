#include "base/array.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

void *ttc_array_more(void *array, size_t count, size_t size)
{
    const bool full = (count & (count - 1)) == 0; /* zero or a power of two */

    if (count > SIZE_MAX / 2 / size) return NULL;
    return full ? realloc(array, (count == 0 ? 1 : 2 * count) * size) : array;
}
