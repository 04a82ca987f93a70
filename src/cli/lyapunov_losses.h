/** Which orbits of a chart, or of the histories of a sweep, break a condition of the model. Maps in lanes do not watch conditions:
 *  these orbits are followed once more, without tangent vectors. */
#ifndef JLT_CLI_LYAPUNOV_LOSSES_H
#define JLT_CLI_LYAPUNOV_LOSSES_H

#include "dynamics/section_batch.h"
#include "dynamics/system.h"

/* UNKNOWN: a condition has had no value, and none is known to have broken. */
enum { JLT_LYAPUNOV_HELD = -1, JLT_LYAPUNOV_NO_ORBIT = -2, JLT_LYAPUNOV_UNKNOWN = -3 };

/** How an orbit is recorded whose conditions had the least value `least`, that of the condition with this index; NaN: one had no
 *  value. Returns this index if `least` is <= 0, else HELD or UNKNOWN. */
int jlt_lyapunov_loss(double least, unsigned condition);

/** Follow the orbits from q, shape (count, dim), for `returns` returns, orbit i under systems[system_of[i]], shape (count,), NULL:
 *  under the first. systems: shape (system_count,), alike but for parameters and levels. Out: lost, shape (count,): the index of
 *  the condition that breaks, or one of the above. Cost: nothing for a model without conditions. Errors: as
 *  jlt_section_batch_run. */
JLT_CHECKED jlt_status jlt_lyapunov_losses(int *lost, const jlt_system *const *systems, size_t system_count, const double *q,
                                           const size_t *system_of, size_t count, size_t returns, bool in_lanes, size_t threads);

#endif
