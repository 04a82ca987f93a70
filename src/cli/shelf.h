/** Runs of a command that are begun before they are asked for, so that they can be computed together. */
#ifndef JLT_CLI_SHELF_H
#define JLT_CLI_SHELF_H

#include "cli/command.h"

enum { JLT_SHELF_RUNS = 256 };

/** How runs of a command are computed together: all are begun, then their common work is done, then each is finished. What a run
 *  writes must not depend on the others. */
typedef struct jlt_shelf_form {
    /* Do everything before the first output. Returns the run; NULL: it has ended, with status *code. argv must live until
     * `drop`. */
    void *(*begin)(jlt_exit *code, int argc, char **argv);
    bool (*are_enough)(void *const *runs, size_t count); /* whether more runs would gain nothing; count <= JLT_SHELF_RUNS */
    void (*follow)(void *const *runs, size_t count);     /* do the common work; silent on failure, which `finish` reports */
    jlt_exit (*finish)(void *run);                       /* write the results */
    void (*drop)(void *run);                             /* free a run, finished or not */
} jlt_shelf_form;

/* A piece of work whose run was begun. */
typedef struct {
    size_t piece;
    char **argv;
    char *first; /* the original argv[0], which `name` replaces */
    int argc;
    char name[64];
    void *run;   /* NULL: it wrote a message or ended before its turn, and is begun again then */
} jlt_shelf_place;

/* All zero: empty. */
typedef struct {
    jlt_shelf_place places[JLT_SHELF_RUNS];
    size_t count, taken; /* pieces are asked for in the order of places; the first `taken` are finished */
} jlt_shelf;

/** The pieces of work: one command with different command lines. */
typedef struct {
    const jlt_command *command;
    char **(*arguments)(const void *context, size_t piece, int *argc); /* a piece's command line, for jlt_command_free; NULL: no
                                                                          memory */
    const void *context;
    size_t (*next)(const void *context, size_t piece); /* the piece that will be asked for after this one; SIZE_MAX: none */
} jlt_work;

/** Run a piece, and unless `alone` begin the pieces that will be asked for next and do their common work. What a piece writes, and
 *  its status, depend neither on that nor on earlier calls. Does not return if the command was interrupted, as with
 *  jlt_program_run. */
jlt_exit jlt_shelf_run(jlt_shelf *self, const jlt_work *work, size_t piece, bool alone);

#endif
