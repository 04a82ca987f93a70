/** Allocates arrays aligned for vector loads, grows arrays, and frees those of a block. */
#ifndef JLT_CORE_MEMORY_H
#define JLT_CORE_MEMORY_H

#include <stdbool.h>
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

/** Make room for one more item in an array that holds `count` items, each of which was added through this macro. array: a variable
 *  or member that points to the items, NULL at first; it is set anew, as items may move. Returns false if memory is out; the
 *  array is then as it was. Cost: amortized constant, as the capacity doubles. */
#define JLT_MEMORY_GROW(array, count) jlt_memory_grow(&(array), count, sizeof *(array))

/* The same, for the macro alone; place: where the pointer is; size: of an item, in bytes. */
bool jlt_memory_grow(void *place, size_t count, size_t size);

/* Free what the pointer at `place` points to; for JLT_FREED. */
static inline void jlt_memory_free_at(void *place)
{
    void *memory;

    memcpy(&memory, place, sizeof memory);
    free(memory);
}

#endif
