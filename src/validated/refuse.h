/** Describes what is wrong with a certificate, or with a request for one, in words. */
#ifndef JLT_VALIDATED_REFUSE_H
#define JLT_VALIDATED_REFUSE_H

#include "core/status.h"
#include "kernel_abi.h"

#include <stdbool.h>

enum { JLT_GIVEN_PROBLEM_MAX = 1024 };

/** Write a problem, formatted as by printf. Returns false. */
JLT_PRINTF(2, 3) bool jlt_refuse(char problem[JLT_GIVEN_PROBLEM_MAX], const char *format, ...);

/** Write that this claim is not proved, and why. Returns false. */
bool jlt_refuse_claim(char problem[JLT_GIVEN_PROBLEM_MAX], const jlt_claim *claim);

#endif
