#include "validated/refuse.h"

#include <stdarg.h>
#include <stdio.h>

bool jlt_refuse(char problem[JLT_GIVEN_PROBLEM_MAX], const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(problem, JLT_GIVEN_PROBLEM_MAX, format, arguments);
    va_end(arguments);
    return false;
}

bool jlt_refuse_claim(char problem[JLT_GIVEN_PROBLEM_MAX], const jlt_claim *claim)
{
    return jlt_refuse(problem, "the %s claim %s of this table is not proved: %s", claim->kind, claim->name, claim->reason);
}
