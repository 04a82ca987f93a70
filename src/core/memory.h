/** Arrays aligned for vector loads. */
#ifndef JLT_CORE_MEMORY_H
#define JLT_CORE_MEMORY_H

#include <stddef.h>

enum { JLT_MEMORY_ALIGNMENT = 64 };

/** A zeroed array of `count` items of `size` bytes, aligned to JLT_MEMORY_ALIGNMENT; one item at least, so that NULL
 *  always means that memory is out or count * size exceeds SIZE_MAX. The caller frees it with free(). */
void *jlt_memory_array(size_t count, size_t size);

/** Room for one more item of an array that holds `count`, by realloc() where that is no item or a power of two: the array, moved or
 *  not. NULL: memory is out, and the array is as it was. */
void *jlt_memory_more(void *array, size_t count, size_t size);

#endif
