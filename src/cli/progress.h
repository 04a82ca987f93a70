/** A line on standard error with share, rate and remaining time; silent where that is no terminal. */
#ifndef JLT_CLI_PROGRESS_H
#define JLT_CLI_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>
#include <time.h>

typedef struct {
    const char *unit; /* "returns", "starts" */
    bool visible;
    struct timespec started, shown;
    char showing; /* a thread shows it; set atomically */
} jlt_progress;

void jlt_progress_start(jlt_progress *self, const char *unit);

/* Cheap: the line is renewed five times a second at most. all: 0 where not known. Several threads may call it at once. */
void jlt_progress_show(jlt_progress *self, size_t done, size_t all);

/* Wipe the line. */
void jlt_progress_end(jlt_progress *self);

#endif
