/** Messages of commands with closed forms of the spherical top for tables to which these do not apply. */
#ifndef JLT_TOP_COMMAND_COUNTERPART_H
#define JLT_TOP_COMMAND_COUNTERPART_H

#include "cli/session.h"
#include "top/counterpart.h"

/** Find the top that the session's table is equivalent to, by its reduction to the built-in table named `shared`, at any state. On
 *  failure, prints what the table lacks, or which of its claims is not proved; what: the subject of the message, such as "M^2". */
jlt_exit jlt_top_counterpart(jlt_counterpart *out, const jlt_session *session, const char *shared, const char *what);

/** Print that a claim of the table `of`, on which `what` would rest, is not proved, and why. Returns JLT_EXIT_INPUT. */
jlt_exit jlt_top_unproved(const jlt_claim *broken, const char *of, const char *what);

#endif
