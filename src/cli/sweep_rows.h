/** What pieces of a study write: rows of one table. */
#ifndef JLT_CLI_SWEEP_ROWS_H
#define JLT_CLI_SWEEP_ROWS_H

#include "cli/study.h"

/** Leave of a piece's text what is no comment: the line of names, and rows. Returns its length, without the NUL. */
size_t jlt_sweep_rows_of(char *text);

/** Whether the rows have the columns of the study's other pieces, and none of those that the study has beside them. In and out:
 *  *names, those of the first piece, NULL before it, owned by the caller. Says what is wrong. */
jlt_exit jlt_sweep_rows_check(char **names, const jlt_study *study, const char *rows);

#endif
