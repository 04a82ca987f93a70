/** What the commands that follow single orbits have in common: options, parameters and start. */
#ifndef JLT_CLI_SESSION_H
#define JLT_CLI_SESSION_H

#include "cli/plot.h"
#include "cli/stream.h"
#include "scene/course.h"

typedef struct {
    jlt_common common;
    jlt_accuracy accuracy; /* refers to the next two */
    double tolerance;      /* default 1e-12 */
    const jlt_method *method;
    jlt_assign_list start;
    const volatile sig_atomic_t *interrupt;

    /* after jlt_session_open */
    const jlt_descriptor *descriptor; /* the model's general field */
    jlt_way_tables others;            /* tables of the user's own that may serve in its place */
    double *params, *x;               /* owned */
} jlt_session;

/* Child parser: the options of common.h and --start; its input is a jlt_session. */
extern const struct argp jlt_session_argp;

/** To be called before argp_parse, with its argv; the session must not move after that. Installs the
 *  handler of Ctrl-C. */
void jlt_session_begin(jlt_session *self, int argc, char **argv);
void jlt_session_end(jlt_session *self);

/** Parameters, checked against the table. Says what is wrong. */
jlt_exit jlt_session_open(jlt_session *self);

/** The start: every state named, in the model's domain. Says what is wrong. */
jlt_exit jlt_session_start(jlt_session *self);

bool jlt_session_interrupted(const jlt_session *self);

/* For captions: the parameters. */
void jlt_session_caption(jlt_plot *plot, const jlt_session *self);

/** "what: reason", with the exit status that the library's status calls for. */
jlt_exit jlt_session_fail(jlt_status status, const char *what);

#endif
