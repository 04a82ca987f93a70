#include "ext/gsl.h"

#include <gsl/gsl_errno.h>

#include <threads.h>

static void switch_off(void)
{
    gsl_set_error_handler_off();
}

void jlt_gsl_quiet(void)
{
    static once_flag once = ONCE_FLAG_INIT;

    call_once(&once, switch_off);
}
