/* The allocations of libc, and those that stand in for them in tests whose name ends in _memory. */
#ifndef JLT_TESTS_WRAPPED_MEMORY_H
#define JLT_TESTS_WRAPPED_MEMORY_H

#include <stddef.h>

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
void *__real_aligned_alloc(size_t alignment, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *old, size_t size);
void *__wrap_aligned_alloc(size_t alignment, size_t size);

#endif
