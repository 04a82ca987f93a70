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
    jlt_way_tables others;            /* the user's own tables that may serve in its place */
    double *params, *x;               /* owned */
} jlt_session;

/* A child parser of --start and the options of common.h; its input is a jlt_session. */
extern const struct argp jlt_session_argp;

/** Set defaults and install the handler of Ctrl-C. Call it before ttc_options_parse, with the same argv, and _end last, with the
 *  session or a structure whose first member it is, as JLT_CLEARED does; it must not move in between. */
void jlt_session_begin(jlt_session *self, int argc, char **argv);
void jlt_session_end(void *place);

/** Open the model and check the parameters. Sets descriptor; params, shape (param_count,); others, to tables with fewer states. */
jlt_exit jlt_session_open(jlt_session *self);

/** Set others to tables with more states too; compiling these takes longer than anything else. */
jlt_exit jlt_session_look_at_larger(jlt_session *self);

/** Read --start into x, shape (state_count,), in the table's units: it must name every state and lie in the model's domain. */
jlt_exit jlt_session_start(jlt_session *self);

/** Whether a signal has asked the command to finish. */
bool jlt_session_interrupted(const jlt_session *self);

/* Write the parameters into the caption of a picture. */
void jlt_session_caption(jlt_plot *plot, const jlt_session *self);

/** Print "WHAT: reason". Returns the exit status that the library's status calls for. */
jlt_exit jlt_session_fail(jlt_status status, const char *what);

#endif
