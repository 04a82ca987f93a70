/* Declares libc's allocation functions, __real_*, and their replacements, __wrap_*, to which the linker's --wrap redirects calls in
 * tests whose names end in _memory. */
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
