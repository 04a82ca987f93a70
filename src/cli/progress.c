#include "cli/progress.h"

#include <stdio.h>
#include <unistd.h>

#include "cli/interrupt.h"

void jlt_progress_start(jlt_progress *self, const char *unit)
{
    *self = (jlt_progress){ .unit = unit };
    self->visible = isatty(STDERR_FILENO) == 1;
    self->started = self->shown = jlt_interrupt_clock();
}

void jlt_progress_show(jlt_progress *self, size_t done, size_t all)
{
    if (!self->visible || __atomic_test_and_set(&self->showing, __ATOMIC_ACQUIRE)) return;
    const double now = jlt_interrupt_clock(), seconds = now - self->started, rate = (double)done / seconds;
    if (now - self->shown < 0.2) goto done;
    self->shown = now;
    fprintf(stderr, "%zu", done);
    if (all > 0) fprintf(stderr, " of %zu", all);
    fprintf(stderr, " %s, %.*f a second", self->unit, rate < 1 ? 3 : rate < 100 ? 1 : 0, rate);
    if (all > done && done > 0) fprintf(stderr, ", %.0f s to go", seconds * (double)(all - done) / (double)done);
    fputs("\033[K\r", stderr); /* what else is printed begins on this line */
done:
    __atomic_clear(&self->showing, __ATOMIC_RELEASE);
}

void jlt_progress_end(jlt_progress *self)
{
    if (self->visible) fputs("\r\033[K", stderr);
}
