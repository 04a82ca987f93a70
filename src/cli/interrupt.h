/** Ctrl-C asks a command to finish the row it is writing; a second one ends the program at once. */
#ifndef JLT_CLI_INTERRUPT_H
#define JLT_CLI_INTERRUPT_H

#include <signal.h>

/** Take over SIGINT, SIGTERM and SIGHUP where they are not ignored, once per process. Returns the flag that they raise. */
const volatile sig_atomic_t *jlt_interrupt_install(void);

/** When the flag was raised: end the program by that signal, as whoever sent it expects. Otherwise nothing. */
void jlt_interrupt_obey(void);

/** End the program by this signal. */
_Noreturn void jlt_interrupt_end(int signal_number);

#endif
