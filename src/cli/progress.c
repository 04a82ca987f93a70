#include "cli/progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/interrupt.h"

void jlt_progress_start(jlt_progress *self, const char *unit)
{
    *self = (jlt_progress){ .unit = unit };
    const char *terminal = getenv("TERM");
    self->visible = isatty(STDERR_FILENO) == 1 && (terminal == NULL || strcmp(terminal, "dumb") != 0);
    self->started = self->shown = jlt_interrupt_clock();
}

/* The columns of the terminal, less one, as the cursor would go to the next line. */
static int columns(void)
{
    struct winsize size;

    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col - 1 : 79;
}

void jlt_progress_show(jlt_progress *self, size_t done, size_t all)
{
    if (!self->visible || __atomic_test_and_set(&self->showing, __ATOMIC_ACQUIRE)) return;
    const double now = jlt_interrupt_clock(), seconds = now - self->started, rate = (double)done / seconds;
    if (now - self->shown < 0.2) goto done;
    self->shown = now;
    char line[256], of[32] = "", left[64] = "";
    if (all > 0) snprintf(of, sizeof of, " of %zu", all);
    if (all > done && done > 0) snprintf(left, sizeof left, ", %.0f s to go", seconds * (double)(all - done) / (double)done);
    snprintf(line, sizeof line, "%zu%s %s, %.*f a second%s", done, of, self->unit, rate < 1 ? 3 : rate < 100 ? 1 : 0, rate, left);
    fprintf(stderr, "%.*s\033[K\r", columns(), line); /* what else is printed begins on this line */
done:
    __atomic_clear(&self->showing, __ATOMIC_RELEASE);
}

void jlt_progress_say(const jlt_progress *self, const char *text)
{
    if (self->visible) fprintf(stderr, "%.*s\033[K\r", columns(), text);
}

void jlt_progress_end(jlt_progress *self)
{
    if (self->visible) fputs("\r\033[K", stderr);
}
