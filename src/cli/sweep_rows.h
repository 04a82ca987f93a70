/** Checks what the pieces of a study write: rows of one table. */
#ifndef JLT_CLI_SWEEP_ROWS_H
#define JLT_CLI_SWEEP_ROWS_H

#include "cli/study.h"

/** Remove the comment lines from a piece's text, so that the line of column names and the rows remain. Returns the new length,
 *  without the NUL. */
size_t jlt_sweep_rows_of(char *text);

/** Check that no column of these rows has the name of something that the study runs over. Says what is wrong. */
jlt_exit jlt_sweep_rows_check(const jlt_study *study, const char *rows);

#endif
