/** Arrays aligned for vector loads. */
#ifndef JLT_CORE_MEMORY_H
#define JLT_CORE_MEMORY_H

#include <stddef.h>

enum { JLT_MEMORY_ALIGNMENT = 64 };

/** A zeroed array of `count` items of `size` bytes, aligned to JLT_MEMORY_ALIGNMENT; one item at least, so that NULL
 *  always means that memory is out or count * size exceeds SIZE_MAX. The caller frees it with free(). */
void *jlt_memory_array(size_t count, size_t size);

#endif
