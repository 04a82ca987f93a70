/** A set of files that is written as a whole or not at all. */
#ifndef TTC_OUTPUT_H
#define TTC_OUTPUT_H

#include "base/text.h"

typedef struct {
    char *path; /* relative to the output folder, with at most one '/' */
    ttc_text text;
} ttc_output_file;

typedef struct {
    ttc_output_file *files;
    size_t count;
    bool failed;
    const char *taken; /* a path of the set that was added again, or with '/' in place of '_'; borrowed; NULL: none was */
} ttc_output;

void ttc_output_clear(ttc_output *output); /* legal on a zeroed set */

/* Add an empty file and return its text, valid until the next file is added; NULL when memory is out or the path is taken. */
ttc_text *ttc_output_add(ttc_output *output, const char *path);

/** Write every file below `folder`, and create this folder and those within paths if missing. Each file is first written and
 *  flushed under a temporary name; only when all are on disk are they renamed to their places. A file whose content is unchanged is
 *  not touched. On failure former files are put back and created folders removed; *restored says if that succeeded.
 *  Runs that write to one folder do so one after the other.
 *  Returns 0, or the errno of the failure, with the path it concerns in *where (borrowed from the set, or from `folder`). */
int ttc_output_write(const ttc_output *output, const char *folder, const char **where, bool *restored);

/* Open /dev/null in place of standard input, output and error where these are closed, so that no other file takes their
 * descriptors; writing to them still fails. When the program exits, also from within argp as after --help, and standard output
 * could not be written, this is reported under the name `program`, and the exit status is `status`. Call this once, before any
 * file is opened. Returns false on failure. */
bool ttc_output_standard(const char *program, int status);

#endif
