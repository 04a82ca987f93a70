/* Reads the times of `jellett simulate`. */
#include "cli/simulate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/grid.h"

enum { TIMES_MAX = 100000000 };

static jlt_exit listed_times(jlt_simulate_request *r)
{
    size_t room = 1;

    for (const char *c = r->times_text; *c != '\0'; c++) room += *c == ',';
    r->times = calloc(room, sizeof *r->times);
    if (r->times == NULL) return jlt_session_fail(JLT_ERR_NOMEM, "--times");
    for (const char *at = r->times_text;; at++) {
        const size_t length = strcspn(at, ",");
        JLT_PASS(jlt_grid_number(&r->times[r->time_count++], at, length, "--times"));
        at += length;
        if (*at == '\0') break;
    }
    for (size_t i = 1; i < r->time_count; i++) {
        const bool forwards = r->times[i] >= r->times[i - 1] && r->times[0] >= 0;
        const bool backwards = r->times[i] <= r->times[i - 1] && r->times[0] <= 0;
        if (!(r->times[r->time_count - 1] >= 0 ? forwards : backwards))
            return jlt_command_fail(JLT_EXIT_INPUT, "--times: they must go from 0 in one direction, in order");
    }
    return JLT_EXIT_DONE;
}

static jlt_exit regular_times(jlt_simulate_request *r)
{
    const double every = !isnan(r->every) ? r->every : fabs(r->until) / 100;
    const double steps = r->until == 0 ? 0 : floor(fabs(r->until) / every * (1 + 4e-16));

    if (!(steps < TIMES_MAX)) return jlt_command_fail(JLT_EXIT_INPUT, "--every: more than %d rows: take a larger step", TIMES_MAX);
    r->time_count = (size_t)steps + 1;
    r->times = calloc(r->time_count + 1, sizeof *r->times);
    if (r->times == NULL) return jlt_session_fail(JLT_ERR_NOMEM, "--until");
    for (size_t i = 0; i < r->time_count; i++) r->times[i] = copysign((double)i * every, r->until);
    r->times[0] = 0;
    if (fabs(r->until) - fabs(r->times[r->time_count - 1]) > 1e-12 * every) r->times[r->time_count++] = r->until;
    return JLT_EXIT_DONE;
}

jlt_exit jlt_simulate_times(jlt_simulate_request *r)
{
    return r->times_text != NULL ? listed_times(r) : regular_times(r);
}
