/** A handler for running out of memory in FLINT and GMP, which cannot report it and would abort. */
#ifndef TTC_EXHAUSTION_H
#define TTC_EXHAUSTION_H

/** Make FLINT and GMP call `handler`, which must not return, when an allocation fails. Call this before they allocate anything. */
void ttc_exhaustion_handle(void (*handler)(void));

#endif
