#include "base/array.h"

#include <stdlib.h>
#include <string.h>

bool ttc_array_grow(void *place, size_t count, size_t size)
{
    const bool full = (count & (count - 1)) == 0; /* zero or a power of two */
    void *array;

    if (!full) return true;
    if (count > SIZE_MAX / 2 / size) return false;
    memcpy(&array, place, sizeof array);
    array = realloc(array, (count == 0 ? 1 : 2 * count) * size);
    if (array == NULL) return false;
    memcpy(place, &array, sizeof array);
    return true;
}

bool ttc_array_has(const uint32_t *list, size_t count, uint32_t number)
{
    for (size_t i = 0; i < count; i++)
        if (list[i] == number) return true;
    return false;
}
