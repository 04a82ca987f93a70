/** A command at every point of a grid in parameters and levels: --sweep. Each point is the command line once more, computed in
 *  a process beside this one; values of the point stand first in each of its rows. */
#ifndef JLT_CLI_SWEPT_H
#define JLT_CLI_SWEPT_H

#include "cli/common.h"

/* The parser of --sweep, to be named as a child; its input is a jlt_common. */
extern const struct argp jlt_swept_argp;

/** What a command says of itself and its rows so that it can be swept. */
typedef struct {
    const jlt_command *command;
    bool has_levels; /* it has the option --level, so that levels can run as well */
    unsigned lead;   /* columns that only number the rows; a picture shows the next one where --axes says nothing */
} jlt_swept_form;

/** Do the sweep where common->sweep asks for one: compute all points and write their rows, or with `jellett plan` print the plan of
 *  the first. Out: *code, the largest exit status of the points that have rows; a point that ends with JLT_EXIT_INPUT has none, and
 *  the sweep goes on. Returns true when this is all the command has to do; false: there is no sweep, or this process computes one
 *  of its points. */
bool jlt_swept_done(jlt_exit *code, const jlt_swept_form *form, jlt_common *common);

#endif
