/** The times of rows of `jellett simulate`: those that --times lists, or multiples of a step, which are computed as they come, so
 *  that the first row does not wait for millions of others. */
#ifndef JLT_CLI_SIMULATE_TIMES_H
#define JLT_CLI_SIMULATE_TIMES_H

#include <stddef.h>

#include "cli/common.h"

enum { JLT_SIMULATE_TIMES_BLOCK = 1024 };

typedef struct {
    size_t count;
    double last;         /* the time of the last row */
    double *listed;      /* shape (count,), owned; NULL: multiples of a step */
    const char *step;    /* as typed, borrowed */
    size_t parts, first; /* times are k step/parts; `block` begins at k = first */
    double block[JLT_SIMULATE_TIMES_BLOCK];
} jlt_simulate_times;

/** Read --times. */
jlt_exit jlt_simulate_times_list(jlt_simulate_times *out, const char *text);

/** Read --until and --every, as numbers and as typed; every: NaN, and its text NULL, if it is not given. */
jlt_exit jlt_simulate_times_until(jlt_simulate_times *out, double until, const char *until_text, double every,
                                  const char *every_text);

/** Returns the time of row `index` < count. Cost: a few numbers read for every block of rows in order. */
double jlt_simulate_times_at(jlt_simulate_times *self, size_t index);

void jlt_simulate_times_clear(jlt_simulate_times *self); /* legal when zeroed */

#endif
