#include "cli/simulate_times.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "cli/grid.h"
#include "ext/number.h"

enum { TIMES_MAX = 100000000 };

jlt_exit jlt_simulate_times_list(jlt_simulate_times *out, const char *text)
{
    size_t room = 1;

    for (const char *c = text; *c != '\0'; c++) room += *c == ',';
    out->listed = calloc(room, sizeof *out->listed);
    if (out->listed == NULL) return jlt_command_no_memory();
    for (const char *at = text;; at++) {
        const size_t length = strcspn(at, ",");
        JLT_PASS(jlt_grid_number(&out->listed[out->count++], at, length, "--times"));
        at += length;
        if (*at == '\0') break;
    }
    const double *t = out->listed;
    out->last = t[out->count - 1];
    for (size_t i = 1; i < out->count; i++) {
        const bool forwards = t[i] >= t[i - 1] && t[0] >= 0, backwards = t[i] <= t[i - 1] && t[0] <= 0;
        if (!(out->last >= 0 ? forwards : backwards))
            return jlt_command_fail(JLT_EXIT_INPUT, "--times: they must go from 0 in one direction, in order");
    }
    return JLT_EXIT_DONE;
}

/* The step was read before, so that this does not fail. */
static double multiple(jlt_simulate_times *self, size_t k)
{
    if (k < self->first || k - self->first >= JLT_SIMULATE_TIMES_BLOCK) {
        self->first = k;
        if (jlt_number_multiples(self->block, self->step, strlen(self->step), self->parts, k, JLT_SIMULATE_TIMES_BLOCK) != JLT_OK)
            return NAN;
    }
    return copysign(self->block[k - self->first], self->last);
}

jlt_exit jlt_simulate_times_until(jlt_simulate_times *out, double until, const char *until_text, double every,
                                  const char *every_text)
{
    const double step = every_text != NULL ? every : fabs(until) / 100;
    const double steps = until == 0 ? 0 : floor(fabs(until) / step * (1 + 4e-16));

    if (!(steps < TIMES_MAX)) return jlt_command_fail(JLT_EXIT_INPUT, "--every: more than %d rows: take a larger step", TIMES_MAX);
    out->step = every_text != NULL ? every_text : until_text;
    out->parts = every_text != NULL ? 1 : 100;
    out->first = SIZE_MAX; /* no block yet */
    out->last = until;
    out->count = (size_t)steps + 1;
    const double end = multiple(out, out->count - 1);
    if (fabs(until) - fabs(end) > 1e-12 * step) out->count++;
    else out->last = end;
    return JLT_EXIT_DONE;
}

double jlt_simulate_times_at(jlt_simulate_times *self, size_t index)
{
    if (self->listed != NULL) return self->listed[index];
    return index == 0 ? 0 : index + 1 == self->count ? self->last : multiple(self, index);
}

void jlt_simulate_times_clear(jlt_simulate_times *self)
{
    free(self->listed);
    self->listed = NULL;
}
