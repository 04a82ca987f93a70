/** A line of progress on standard error, with share, rate and remaining time; nothing is written where that is no terminal. */
#ifndef JLT_CLI_PROGRESS_H
#define JLT_CLI_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    const char *unit; /* "returns", "starts" */
    bool visible;
    double started, shown;
    char showing; /* a thread shows it; set atomically */
} jlt_progress;

/* Begin; `unit` names what is counted, in the plural. */
void jlt_progress_start(jlt_progress *self, const char *unit);

/* Show that `done` of `all` are done; all: 0 where that is not known. Cheap to call often: the line is renewed five times a second
 * at most. Several threads may call it at once. */
void jlt_progress_show(jlt_progress *self, size_t done, size_t all);

/* Wipe the line. */
void jlt_progress_end(jlt_progress *self);

#endif
