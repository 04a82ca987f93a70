/** A command at every point of a grid in parameters and levels: --sweep. Each point is the command line once more, computed in
 *  a process of its own; values of the point stand first in each of its rows. */
#ifndef JLT_CLI_SWEPT_H
#define JLT_CLI_SWEPT_H

#include "cli/common.h"

/* Child parser, with a jlt_common for input. */
extern const struct argp jlt_swept_argp;

/** What a command that may be swept knows of its rows. */
typedef struct {
    const jlt_command *command;
    bool has_levels; /* --level is an option of it */
    unsigned lead;   /* columns that only number the rows; a picture shows the next one where --axes says nothing */
} jlt_swept_form;

/** Where the command line is of many points, and not of one of them: compute all and write their rows, or show the plan of the
 *  first; then nothing is left to do. common: the command line, parsed. A point where there is nothing (bad input) has no rows.
 *  Says what is wrong. Out: *code, the largest status of points with rows. False: there is no sweep. */
bool jlt_swept_done(jlt_exit *code, const jlt_swept_form *form, jlt_common *common);

#endif
