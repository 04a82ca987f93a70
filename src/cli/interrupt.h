/** Ctrl-C asks a command to finish the row it is writing; a second one ends the program at once. */
#ifndef JLT_CLI_INTERRUPT_H
#define JLT_CLI_INTERRUPT_H

#include <signal.h>

/** Take over SIGINT and SIGTERM, once per process. Returns the flag that they raise. */
const volatile sig_atomic_t *jlt_interrupt_install(void);

#endif
