/** Runs of a command that were begun before they are asked for, and computed together. */
#ifndef JLT_CLI_SHELF_H
#define JLT_CLI_SHELF_H

#include "cli/command.h"

enum { JLT_SHELF_RUNS = 256 };

/** How runs of a command are computed together: all are begun, then what they have in common is computed, then each is finished.
 *  What is written for a run must not depend on the others. */
typedef struct jlt_shelf_form {
    /* Up to the first word of results; NULL: the run is over, with status *code. argv must stay. */
    void *(*begin)(jlt_exit *code, int argc, char **argv);
    bool (*are_enough)(void *const *runs, size_t count); /* nothing is gained by more of them; count <= JLT_SHELF_RUNS */
    void (*follow)(void *const *runs, size_t count);     /* silent: of what fails, `finish` says so when it computes it again */
    jlt_exit (*finish)(void *run);
    void (*drop)(void *run);                             /* whether finished or not */
} jlt_shelf_form;

/* A piece of work whose run was begun. */
typedef struct {
    size_t piece;
    char **argv;
    char *first; /* of argv, while the command's name stands there */
    int argc;
    char name[64];
    void *run;   /* NULL: it had something to say before its turn, and is begun again */
} jlt_shelf_place;

/* All zero: empty. */
typedef struct {
    jlt_shelf_place places[JLT_SHELF_RUNS];
    size_t count, taken; /* pieces are asked for in the order of places */
} jlt_shelf;

/** What pieces of work there are. */
typedef struct {
    const jlt_command *command;
    char **(*arguments)(const void *context, size_t piece, int *argc); /* of a piece; for jlt_command_free. NULL: no memory */
    const void *context;
    size_t (*next)(const void *context, size_t piece); /* the piece that is asked for after it; SIZE_MAX: there is none */
} jlt_work;

/** The run of a piece, with those that will be asked for next begun and computed beside it unless `alone`. What it writes, and its
 *  status, depend neither on that nor on what was asked for before. A command that was interrupted does not return, as with
 *  jlt_program_run. */
jlt_exit jlt_shelf_run(jlt_shelf *self, const jlt_work *work, size_t piece, bool alone);
void jlt_shelf_clear(jlt_shelf *self, const jlt_work *work);

#endif
