/** Signal handling. INT, TERM and HUP ask a command to finish its current row. They end a command that has not called
 *  jlt_interrupt_install at once, and one that has after a second (jlt_interrupt_draw grants more), or at a further signal that
 *  comes a second after the first or later. No temporary file stays behind. */
#ifndef JLT_CLI_INTERRUPT_H
#define JLT_CLI_INTERRUPT_H

#include <signal.h>
#include <stdbool.h>
#include <sys/types.h>

#include "report/file.h"

/** Install handlers for the signals that are not ignored. Call it once, at the start of the program. */
void jlt_interrupt_begin(void);

/** Returns the flag that the first signal sets to its number for good; 0 before. The caller promises to look at it, and to save its
 *  rows when it is set. */
const volatile sig_atomic_t *jlt_interrupt_install(void);

/** Whether a signal has asked the program to end. */
bool jlt_interrupt_asked(void);

/** Before the command works on this many threads: start the threads of the OpenMP pool with INT, TERM and HUP blocked, so that only
 *  the first thread receives them. Otherwise two signals could be handled on two threads at once, the later one first. Parallel
 *  regions of as many threads or fewer reuse these threads. */
void jlt_interrupt_spare(size_t threads);

/** Call it before what takes long after an interrupt, such as drawing, or saving rows that are all in memory: if the flag is set,
 *  the command gets ten more seconds from now, unless another signal comes. */
void jlt_interrupt_draw(void);

/** If the flag is set, end the program by that signal, so that its parent sees what ended it. */
void jlt_interrupt_obey(void);

/** End the program by this signal. */
_Noreturn void jlt_interrupt_end(int signal_number);

/** Between these two calls no signal ends the program, so that files can be created, renamed and removed. Keep the span short; the
 *  calls do not nest. */
void jlt_interrupt_hold(void);
void jlt_interrupt_release(void);

/** Register a file that is being written; unregister it. Call both while signals are held. If the program is ended because the
 *  second has passed, its whole rows so far are saved; if a signal ends the program at once, it is removed. At most 8 files. */
void jlt_interrupt_remember(const jlt_file *file);
void jlt_interrupt_forget(const jlt_file *file);

/** Remove the registered files, before the program ends without finishing them. */
void jlt_interrupt_abandon(void);

/** Seconds of a clock that nobody sets. It may be read within a signal handler. */
double jlt_interrupt_clock(void);

/** Fork. The child starts with no signal pending and no file registered, as the program did. The parent passes signals on to the
 *  child until it calls jlt_interrupt_alone, which returns the first signal that came, or 0. jlt_interrupt_fork returns what fork
 *  does. */
pid_t jlt_interrupt_fork(void);
int jlt_interrupt_alone(void);

#endif
