/** Allocates arrays aligned for vector loads, and grows arrays. */
#ifndef JLT_CORE_MEMORY_H
#define JLT_CORE_MEMORY_H

#include <stddef.h>

enum { JLT_MEMORY_ALIGNMENT = 64 };

/** Returns a zeroed array of `count` items of `size` bytes, aligned to JLT_MEMORY_ALIGNMENT. At least one byte is allocated, so
 *  NULL always means that memory is out or count * size exceeds SIZE_MAX. The caller frees it with free(). */
void *jlt_memory_array(size_t count, size_t size);

/** Make room for one more item in an array that holds `count` items: calls realloc() to double the array if `count` is 0 or a
 *  power of two. Returns the array, which may have moved, or NULL if memory is out; the old array is then still valid. */
void *jlt_memory_more(void *array, size_t count, size_t size);

#endif
