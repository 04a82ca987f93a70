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
