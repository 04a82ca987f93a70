/** How a program begins and ends, whatever it does in between, and where it finds its companions. */
#ifndef JLT_CLI_PROGRAM_H
#define JLT_CLI_PROGRAM_H

#include "cli/command.h"

/** Call it first: it opens standard descriptors that are closed, takes over signals, makes exhausted memory an error, and sees to
 *  it that a failure of standard output is noticed at the end. */
jlt_exit jlt_program_begin(void);

/** One run of the command, by itself, with its name for argv[0] already. */
jlt_exit jlt_program_call(const jlt_command *command, int argc, char **argv);

/* Run it, with its name for argv[0]. A command that was interrupted does not return: it has finished its row, and ends the
 * program by the signal. */
jlt_exit jlt_program_run(const jlt_command *command, int argc, char **argv);

/** The path of the file `name` beside this program's own. Out: path, shape (size,). False: that folder cannot be found out. */
bool jlt_program_beside(char *path, size_t size, const char *name);

#endif
