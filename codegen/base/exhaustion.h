/** A handler for running out of memory in FLINT and GMP, which cannot report it and would abort. */
#ifndef TTC_EXHAUSTION_H
#define TTC_EXHAUSTION_H

/** Make FLINT and GMP call `handler` when an allocation fails; it must not return. Call this first in main, before either library
 *  allocates anything. */
void ttc_exhaustion_handle(void (*handler)(void));

#endif
