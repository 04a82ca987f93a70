/** A function of emitted C, read back as a program: what stands in the text, not what it was made from. */
#ifndef TTC_FUNCTION_READ_H
#define TTC_FUNCTION_READ_H

#include "optimize/program.h"

typedef enum {
    TTC_FUNCTION_READ,
    TTC_FUNCTION_ABSENT,  /* no function of this name, or not of the form that ttc_emit_function gives */
    TTC_FUNCTION_ROUNDED, /* a constant is written as a rounded number */
    TTC_FUNCTION_NO_MEMORY
} ttc_function_status;

/** The program of `static void NAME(x, params, out)`, for ttc_program_destroy; NULL unless READ. It has `outputs` of them, each set
 *  once. */
ttc_function_status ttc_function_read(ttc_program **out, const char *text, const char *name, size_t outputs);

#endif
