/** Commands of ttc: one file a command, dispatched by the table in main.c. Results go to stdout, everything else to
 *  stderr. To add one: a function here, its file, and a row of the table. */
#ifndef TTC_COMMAND_H
#define TTC_COMMAND_H

#include "optimize/optimize.h"
#include "read/model.h"

typedef enum {
    TTC_EXIT_DONE = 0,
    TTC_EXIT_REFUTED = 1,   /* a claim is false */
    TTC_EXIT_USAGE = 2,
    TTC_EXIT_BAD_TABLE = 3,
    TTC_EXIT_IO = 5
} ttc_exit_status;

/* What the command line says. Options that a command does not list in the table are refused before it runs. */
typedef struct {
    char **files; /* tables, at least one */
    size_t file_count;
    bool json;
    bool mutate;
    bool kernels;
    ttc_effort effort;
    const char *out;    /* directory */
    const char *format; /* "text", "latex" or "dot" */
    const char *command_line; /* "ttc COMMAND OPTIONS..." without directories of files, for headers of what is written */
} ttc_options;

/* Each returns a ttc_exit_status; with several tables the largest. */
int ttc_command_check(const ttc_options *options);
int ttc_command_prove(const ttc_options *options);
int ttc_command_generate(const ttc_options *options);
int ttc_command_cost(const ttc_options *options);
int ttc_command_show(const ttc_options *options);

/** Read a table and print its diagnostics on stderr. NULL when it is wrong; *status is then raised to TTC_EXIT_BAD_TABLE
 *  or TTC_EXIT_IO. The caller destroys the model. */
ttc_model *ttc_command_read(const char *path, int *status);

#endif
