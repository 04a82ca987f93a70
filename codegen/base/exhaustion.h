/** What happens when memory is out in FLINT and GMP, which have no way to report it, and abort otherwise. */
#ifndef TTC_EXHAUSTION_H
#define TTC_EXHAUSTION_H

/** Have this called then; it must not return. For a program's main, before anything else. */
void ttc_exhaustion_handle(void (*handler)(void));

#endif
