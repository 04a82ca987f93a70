/** A set of files that is written as a whole or not at all. */
#ifndef TTC_OUTPUT_H
#define TTC_OUTPUT_H

#include "base/text.h"

typedef struct {
    char *path; /* below the folder, with at most one '/' */
    ttc_text text;
} ttc_output_file;

typedef struct {
    ttc_output_file *files;
    size_t count;
    bool failed;
    const char *taken; /* a path that was asked for twice, borrowed from the set; NULL: none */
} ttc_output;

void ttc_output_clear(ttc_output *output); /* legal on a zeroed set */

/* A new, empty file; NULL when memory is out or the path is taken. Valid until the next file is added. */
ttc_text *ttc_output_add(ttc_output *output, const char *path);

/** Write every file below `folder`, which is made when it is missing, as are the folders of paths. Each file is written
 *  beside its place and flushed first; only when all of them are on disk are they moved into place, and a file whose
 *  content is unchanged is left alone. On failure those already moved give way to what was there before, and folders made go
 *  again; *restored tells whether this succeeded.
 *  Returns 0, or errno of what failed with its path in *where (borrowed from the set, or from `folder`). */
int ttc_output_write(const ttc_output *output, const char *folder, const char **where, bool *restored);

/* Open standard input, output and error where they are closed, so that no file is opened in their place: writing to them fails, as
 * before. To be called first; false: it cannot be done. */
bool ttc_output_standard(void);

#endif
