/** What `jellett` and `jellett-bench` share: how a program begins and ends, and where it finds programs installed with it. */
#ifndef JLT_CLI_PROGRAM_H
#define JLT_CLI_PROGRAM_H

#include "cli/command.h"

/** Call it first. It opens standard descriptors that are closed, asks for the usual stack where there is less, and says so where it
 *  gets none, installs signal handlers, lets the program end with a message when FLINT or GMP run out of memory, and with
 *  JLT_EXIT_IO when standard output could not be written. */
jlt_exit jlt_program_begin(void);

/** Run the command once in this process, without other runs beside it (cli/shelf.h); argv[0] is "jellett NAME" already. Returns its
 *  status, which may be JLT_EXIT_PLANNED. */
jlt_exit jlt_program_call(const jlt_command *command, int argc, char **argv);

/* jlt_program_call for a command that the user typed: sets argv[0] meanwhile, and a plan counts as JLT_EXIT_DONE. Does not return
 * if the command was interrupted: the program then ends by the signal, after the command has saved its rows. */
jlt_exit jlt_program_run(const jlt_command *command, int argc, char **argv);

/** The path of the file `name` in the folder of this program. Out: path, shape (size,). Returns false if the folder is not known,
 *  or the path is too long. */
bool jlt_program_beside(char *path, size_t size, const char *name);

#endif
