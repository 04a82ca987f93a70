/** Signals INT, TERM and HUP ask a command to finish the row it is at. A command that does not look at that request, or does
 *  not finish within a second (jlt_interrupt_draw gives it longer), is ended, and a signal more than a second after the first ends
 *  it at once. No temporary file stays behind. */
#ifndef JLT_CLI_INTERRUPT_H
#define JLT_CLI_INTERRUPT_H

#include <signal.h>
#include <sys/types.h>

#include "report/file.h"

/** Take over the signals that are not ignored. Call it once, as the program begins. */
void jlt_interrupt_begin(void);

/** From now on the command looks at the flag that this returns, which is raised for good by the first signal, and saves what it
 *  has. Until then a signal ends the program at once. */
const volatile sig_atomic_t *jlt_interrupt_install(void);

/** Signals are left to the first thread, now that the command is to work on so many: threads are begun here that have them
 *  blocked, and parallel regions of as many or fewer use these. Of two signals that come together on two threads, the later could
 *  be met first. */
void jlt_interrupt_spare(size_t threads);

/** The rows are saved, and a picture of them is drawn: where the flag was raised, the command has ten seconds from now, unless
 *  another signal comes. */
void jlt_interrupt_draw(void);

/** When the flag was raised: end the program by that signal, as whoever sent it expects. Otherwise nothing. */
void jlt_interrupt_obey(void);

/** End the program by this signal. */
_Noreturn void jlt_interrupt_end(int signal_number);

/** Between the two, no signal ends the program: a file is made, moved or removed. Short, and not nested. */
void jlt_interrupt_hold(void);
void jlt_interrupt_release(void);

/** A file under way, until it is forgotten; the signals are held meanwhile. Where the program is ended because a second has
 *  passed, the whole rows written so far are saved; by another signal, it is removed. At most 8. */
void jlt_interrupt_remember(const jlt_file *file);
void jlt_interrupt_forget(const jlt_file *file);

/** Remove the files under way: the program is about to end without their being finished. */
void jlt_interrupt_abandon(void);

/** Seconds of a clock that nobody sets. It may be read while a signal is met. */
double jlt_interrupt_clock(void);

/** Fork. The child begins as the program did; in the parent, signals are passed on to it until jlt_interrupt_alone, which
 *  returns the first of them, 0 where there was none. Returns as fork. */
pid_t jlt_interrupt_fork(void);
int jlt_interrupt_alone(void);

#endif
