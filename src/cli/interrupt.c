#include "cli/interrupt.h"

#include <stdio.h>
#include <stdlib.h>

/* A handler can reach nothing but a global. */
static volatile sig_atomic_t raised;

static void raise_flag(int signal_number)
{
    raised = signal_number;
}

const volatile sig_atomic_t *jlt_interrupt_install(void)
{
    static const int asking[] = { SIGINT, SIGTERM, SIGHUP };

    for (unsigned i = 0; i < sizeof asking / sizeof *asking; i++) {
        struct sigaction action = { .sa_handler = raise_flag, .sa_flags = (int)SA_RESETHAND }, before;
        sigemptyset(&action.sa_mask);
        if (sigaction(asking[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(asking[i], &action, NULL);
    }
    return &raised;
}

void jlt_interrupt_obey(void)
{
    if (raised != 0) jlt_interrupt_end(raised);
}

void jlt_interrupt_end(int signal_number)
{
    fflush(stdout);
    signal(signal_number, SIG_DFL);
    raise(signal_number);
    _Exit(128 + signal_number);
}
