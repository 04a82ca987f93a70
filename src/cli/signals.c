#include "cli/signals.h"

#include <errno.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

/* On Linux the main thread's id is the process id. There the signal takes its default action, once the main thread lets it
 * through; elsewhere it is passed on. */
static void pass_on(int signal_number)
{
    const int reason = errno;
    const long process = syscall(SYS_getpid);

    if (syscall(SYS_gettid) == process) {
        signal(signal_number, SIG_DFL);
        raise(signal_number);
    } else {
        syscall(SYS_tgkill, process, process, signal_number);
    }
    errno = reason;
}

void jlt_signals_to_main(void)
{
    static const int ending[] = { SIGINT, SIGTERM, SIGHUP };

    for (unsigned i = 0; i < sizeof ending / sizeof *ending; i++) {
        struct sigaction action = { .sa_flags = SA_RESTART }, before;
        sigemptyset(&action.sa_mask);
        action.sa_handler = pass_on;
        /* A shell that starts a job in the background has it ignore SIGINT, and nohup SIGHUP: let it be so. */
        if (sigaction(ending[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(ending[i], &action, NULL);
    }
}
