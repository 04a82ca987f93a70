#include "cli/interrupt.h"

#include <stddef.h>

/* A handler can reach nothing but a global. */
static volatile sig_atomic_t raised;

static void raise_flag(int signal_number)
{
    (void)signal_number;
    raised = 1;
}

const volatile sig_atomic_t *jlt_interrupt_install(void)
{
    struct sigaction action = { .sa_handler = raise_flag, .sa_flags = (int)SA_RESETHAND };

    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    return &raised;
}
