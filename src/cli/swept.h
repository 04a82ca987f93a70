/** --sweep: a command at every point of a grid in parameters and levels. A child process runs the command line once for each point,
 *  whose values come first in each of its rows. */
#ifndef JLT_CLI_SWEPT_H
#define JLT_CLI_SWEPT_H

#include "cli/common.h"

/* The parser of --sweep, to be named as a child; its input is a jlt_common. */
extern const struct argp jlt_swept_argp;

/** What a sweep needs to know of a command and its rows. */
typedef struct {
    const jlt_command *command;
    bool has_levels; /* it has the option --level, so that levels can run as well */
    unsigned lead;   /* how many leading columns only number the rows; without --axes a picture shows the column after them */
} jlt_swept_form;

/** Do the sweep if common->sweep asks for one: compute all points and write their rows, or with `jellett plan` print the plan of
 *  the first point. Returns false if there is no sweep, or this process computes one of its points: the command then goes on.
 *  Otherwise the command ends with *code: the status of an error that ended the sweep, else the largest status of the points, where
 *  JLT_EXIT_INPUT counts only if no point has rows. */
bool jlt_swept_done(jlt_exit *code, const jlt_swept_form *form, jlt_common *common);

#endif
