/** Reads a function of emitted C back as a program, from the text alone. */
#ifndef TTC_FUNCTION_READ_H
#define TTC_FUNCTION_READ_H

#include "optimize/program.h"

typedef enum {
    TTC_FUNCTION_READ,
    TTC_FUNCTION_ABSENT,  /* no function of this name, or not of the form that ttc_emit_function gives */
    TTC_FUNCTION_ROUNDED, /* a constant is written as a rounded number */
    TTC_FUNCTION_NO_MEMORY
} ttc_function_status;

/** Read `static void NAME(x, params, out)`, which sets each of `outputs` outputs once. *out: the program, for ttc_program_destroy;
 *  NULL unless READ. */
ttc_function_status ttc_function_read(ttc_program **out, const char *text, const char *name, size_t outputs);

#endif
