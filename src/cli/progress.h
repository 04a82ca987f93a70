/** A progress line on standard error, with share, rate and remaining time, cut to the terminal's width; nothing is written if that
 *  is no terminal, or one that cannot rewrite a line (TERM=dumb). */
#ifndef JLT_CLI_PROGRESS_H
#define JLT_CLI_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    const char *unit; /* "returns", "starts" */
    bool visible;
    double started, shown;
    char showing; /* a thread is writing the line; set atomically */
} jlt_progress;

/* Begin; `unit` names what is counted, in the plural. */
void jlt_progress_start(jlt_progress *self, const char *unit);

/* Show that `done` of `all` are done; all: 0 if it is not known. Cheap to call often: the line is rewritten at most five times a
 * second. Several threads may call it at once. */
void jlt_progress_show(jlt_progress *self, size_t done, size_t all);

/* Show a text in place of counts, until the line is wiped. */
void jlt_progress_say(const jlt_progress *self, const char *text);

/* Wipe the line. */
void jlt_progress_end(jlt_progress *self);

#endif
