/* Lets one chosen allocation fail, in a test program with a single source file. */
#ifndef JLT_TESTS_FAILING_MEMORY_H
#define JLT_TESTS_FAILING_MEMORY_H

#include <stdbool.h>

#include "fault/wrapped_memory.h"

static long failing = -1; /* how many allocations still succeed before one fails; negative: none fails */

static bool fails(void) { return failing >= 0 && failing-- == 0; }

void *__wrap_malloc(size_t size) { return fails() ? NULL : __real_malloc(size); }
void *__wrap_calloc(size_t count, size_t size) { return fails() ? NULL : __real_calloc(count, size); }
void *__wrap_realloc(void *old, size_t size) { return fails() ? NULL : __real_realloc(old, size); }
void *__wrap_aligned_alloc(size_t alignment, size_t size) { return fails() ? NULL : __real_aligned_alloc(alignment, size); }

#endif
