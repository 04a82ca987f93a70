/** What commands on closed forms of the spherical top say of a table for which those do not serve. */
#ifndef JLT_TOP_COMMAND_COUNTERPART_H
#define JLT_TOP_COMMAND_COUNTERPART_H

#include "cli/session.h"
#include "top/counterpart.h"

/** The top that the session's table is by its reduction to the table built in of the name `shared`, at any state. Says what the
 *  table lacks, or which claim of it is not proved; what: "M^2". */
jlt_exit jlt_top_counterpart(jlt_counterpart *out, const jlt_session *session, const char *shared, const char *what);

/** Say that a claim of the table `of` is not proved, on which `what` would rest, and why. Returns JLT_EXIT_INPUT. */
jlt_exit jlt_top_unproved(const jlt_claim *broken, const char *of, const char *what);

#endif
