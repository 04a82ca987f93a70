#include "core/memory.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

void *jlt_memory_array(size_t count, size_t size)
{
    const size_t mask = JLT_MEMORY_ALIGNMENT - 1;
    void *array;
    size_t bytes;

    if (count == 0) count = 1;
    if (size == 0) size = 1;
    if (count > (SIZE_MAX - mask) / size) return NULL;
    bytes = (count * size + mask) & ~mask;
    array = aligned_alloc(JLT_MEMORY_ALIGNMENT, bytes);
    if (array != NULL) memset(array, 0, bytes);
    return array;
}

bool jlt_memory_grow(void *place, size_t count, size_t size)
{
    const bool full = (count & (count - 1)) == 0;
    void *array;

    if (!full) return true;
    if (count > SIZE_MAX / 2 / size) return false;
    memcpy(&array, place, sizeof array);
    array = realloc(array, (count == 0 ? 1 : 2 * count) * size);
    if (array == NULL) return false;
    memcpy(place, &array, sizeof array);
    return true;
}
