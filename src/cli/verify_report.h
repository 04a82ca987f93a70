/** Writes the findings of `jellett verify` as text or JSON. */
#ifndef JLT_CLI_VERIFY_REPORT_H
#define JLT_CLI_VERIFY_REPORT_H

#include "claims/verify.h"

#include <stdio.h>

void jlt_verify_report_text(FILE *stream, const jlt_verify_run *run);
JLT_CHECKED jlt_status jlt_verify_report_json(FILE *stream, const jlt_verify_run *run);

#endif
