/** Allocates arrays aligned for vector loads, grows arrays, and frees those of a block. */
#ifndef JLT_CORE_MEMORY_H
#define JLT_CORE_MEMORY_H

#include <stdlib.h>
#include <string.h>

#include "core/status.h"

/* Marks a pointer whose memory free() gives back where its block ends, as JLT_CLEARED does:
 *     JLT_FREED double *x = jlt_memory_array(n, sizeof *x); */
#define JLT_FREED JLT_CLEARED(jlt_memory_free_at)

enum { JLT_MEMORY_ALIGNMENT = 64 };

/** Returns a zeroed array of `count` items of `size` bytes, aligned to JLT_MEMORY_ALIGNMENT. At least one byte is allocated, so
 *  NULL always means that memory is out or count * size exceeds SIZE_MAX. The caller frees it with free(). */
void *jlt_memory_array(size_t count, size_t size);

/** Make room for one more item in an array that holds `count` items: calls realloc() to double the array if `count` is 0 or a
 *  power of two. Returns the array, which may have moved, or NULL if memory is out; the old array is then still valid. */
void *jlt_memory_more(void *array, size_t count, size_t size);

/* Free what the pointer at `place` points to; for JLT_FREED. */
static inline void jlt_memory_free_at(void *place)
{
    void *memory;

    memcpy(&memory, place, sizeof memory);
    free(memory);
}

#endif
