/** How a program begins and ends, whatever it does in between, and where it finds its companions. */
#ifndef JLT_CLI_PROGRAM_H
#define JLT_CLI_PROGRAM_H

#include "cli/command.h"

/** Before anything else: standard descriptors, signals, memory that runs out, and that standard output arrives. */
jlt_exit jlt_program_begin(void);

/* Run it, with its name for argv[0]. A command that was interrupted does not return: it has finished its row, and ends the
 * program by the signal. */
jlt_exit jlt_program_run(const jlt_command *command, int argc, char **argv);

/** The path of a file, named from the folder of this program. False: it cannot be known. */
bool jlt_program_beside(char *path, size_t size, const char *name);

#endif
