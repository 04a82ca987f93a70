/** Commands of the program, one file each, all listed in command_table.c; and what they share: exit statuses, messages, outputs. */
#ifndef JLT_CLI_COMMAND_H
#define JLT_CLI_COMMAND_H

#include "core/status.h"
#include "kernel_abi.h"

#include <stdbool.h>
#include <stdio.h>

/** Exit statuses of the program, which the functions of commands return. One that returns neither JLT_EXIT_DONE nor
 *  JLT_EXIT_PLANNED has printed the reason on standard error; the caller cleans up and passes the status on. */
typedef enum {
    JLT_EXIT_DONE = 0,
    JLT_EXIT_FAILED = 1, /* a claim or a check does not hold */
    JLT_EXIT_USAGE = 2,
    JLT_EXIT_INPUT = 3, /* a name, a number or a state that cannot be used */
    JLT_EXIT_NUMERICAL = 4, /* a method did not reach what was asked, or memory is out, or threads are */
    JLT_EXIT_IO = 5,
    JLT_EXIT_PLANNED =
        6 /* within the program only: the plan has been printed, and nothing else is to be done; the program ends with 0 */
} jlt_exit;

typedef struct {
    const char *name;
    const char *arguments; /* as shown in the list of commands */
    const char *summary;   /* one line, no full stop */
    jlt_exit (*run)(int argc, char **argv); /* argv[0] is "jellett NAME"; NULL: the command is run by `together` */
    const struct argp *parser; /* its options are the keys of a scene's entry; NULL: scenes cannot ask for the command */
    const struct jlt_shelf_form *together; /* how several runs of a sweep or a study are computed together (cli/shelf.h); NULL: each
                                              is computed by itself */
} jlt_command;

extern const jlt_command jlt_command_verify, jlt_command_eigen, jlt_command_measure, jlt_command_models, jlt_command_simulate,
    jlt_command_run, jlt_command_plan, jlt_command_rod, jlt_command_portrait, jlt_command_section, jlt_command_orbits,
    jlt_command_fates, jlt_command_manifolds, jlt_command_lyapunov, jlt_command_continue, jlt_command_separation, jlt_command_drift,
    jlt_command_transfer, jlt_command_certify, jlt_command_check, jlt_command_bench, jlt_command_sweep, jlt_command_merge;

/* Number `index` of the table, in the order of --help; NULL beyond the last. */
const jlt_command *jlt_command_at(size_t index);

/* The command of this name; NULL when there is none. */
const jlt_command *jlt_command_find(const char *name);

/* Print "jellett: ", the message and a newline on standard error. Returns `code`, so that a caller can return it at once. */
JLT_PRINTF(2, 3) jlt_exit jlt_command_fail(jlt_exit code, const char *format, ...);

/* Print one line on standard error for a model whose kernels rest on claims that are not proved, and for each smaller model that
 * may answer in its place. */
void jlt_command_warn_unproved(const jlt_descriptor *descriptor);

/* Print that memory is out; that a file cannot be written, for the reason in errno. Return the exit status for it. */
jlt_exit jlt_command_no_memory(void);
jlt_exit jlt_command_cannot_write(const char *path);

/* The exit status that a library status calls for. Prints nothing. */
jlt_exit jlt_command_exit(jlt_status status);

/* Whether jlt_command_no_memory or jlt_command_exit has been told that memory is out. */
bool jlt_command_lacked_memory(void);

/* The prefix of options that the program passes to its own commands: no abbreviation that a user types can match one of them. */
#define JLT_COMMAND_HIDDEN "--@"

/* The command as typed, one line of text for headers of files; for the caller to free(). NULL when memory is out. */
char *jlt_command_line(int argc, char **argv);

/* Free an argument vector and each of its arguments. */
void jlt_command_free(char **argv, int argc);

/** Results of a command, collected in memory and delivered at once: to a file, whole or not at all, or to standard output.
 *  Callers need not check writes to `stream`: a failure shows at delivery. */
typedef struct {
    FILE *stream;
    char *text;
    size_t size;
} jlt_command_output;

/* Open the stream. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_command_open(jlt_command_output *output);

/* Close the stream; `text` then has all that was written, `size` bytes. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_command_close(jlt_command_output *output);

/* Whether a path means standard output: NULL and "-" do. */
bool jlt_command_is_standard_output(const char *path);

/** A file that a command reads or writes: the option that names it, and its path. */
typedef struct {
    const char *option, *path;
} jlt_command_file;

/* Check, before anything is written, that no two of these paths lead to one file. */
jlt_exit jlt_command_distinct(const jlt_command_file *files, size_t count);

/* Write a file, whole or not at all. */
jlt_exit jlt_command_write(const char *path, const char *data, size_t size);

/* Check, before long work, that a result can be written to this path. */
jlt_exit jlt_command_check_output(const char *path);

/* Write the output to a file, or to standard output where path is NULL or "-", and close it. */
jlt_exit jlt_command_deliver(jlt_command_output *output, const char *path);
void jlt_command_discard(jlt_command_output *output); /* legal when never opened, if zeroed */

#endif
