#include "base/exhaustion.h"

#include <flint/flint.h>

#include <stdlib.h>

/* A global, because allocation functions of FLINT and GMP take no context argument. */
static void (*when_out)(void);

static void *checked(void *memory)
{
    if (memory == NULL) when_out();
    return memory;
}

static void *allocate(size_t size) { return checked(malloc(size)); }

static void *allocate_zeroed(size_t count, size_t size) { return checked(calloc(count, size)); }

static void *reallocate(void *old, size_t size) { return checked(realloc(old, size)); }

static void *reallocate_sized(void *old, size_t old_size, size_t size)
{
    (void)old_size;
    return reallocate(old, size);
}

static void release_sized(void *memory, size_t size)
{
    (void)size;
    free(memory);
}

void ttc_exhaustion_handle(void (*handler)(void))
{
    when_out = handler;
    __flint_set_memory_functions(allocate, allocate_zeroed, reallocate, free);
    mp_set_memory_functions(allocate, reallocate_sized, release_sized);
}
