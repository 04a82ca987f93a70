/** Records of many sequences, written as they come and read back one sequence after another: the latest of each in memory, what
 *  is older in an unnamed temporary file, so that memory does not grow with their number. */
#ifndef JLT_CORE_SPOOL_H
#define JLT_CORE_SPOOL_H

#include <stddef.h>

#include "core/status.h"

typedef struct jlt_spool jlt_spool;

/** Records of `width` numbers in `sequences` sequences, each with `room` records in memory. The file, in TMPDIR or /tmp, is not
 *  made before it is needed, and closed in programs that are started. Errors: ARG, a zero; NOMEM.
 *  Memory: (sequences + 1) * room records. */
JLT_CHECKED jlt_status jlt_spool_create(jlt_spool **out, size_t width, size_t sequences, size_t room);
void jlt_spool_destroy(jlt_spool *self); /* NULL is legal */

/** Add a record (width,). Several threads may do so at once, each to sequences of its own. Errors: IO. */
JLT_CHECKED jlt_status jlt_spool_add(jlt_spool *self, size_t sequence, const double *record);

size_t jlt_spool_count(const jlt_spool *self, size_t sequence);

/** Read from the beginning of a sequence from now on. */
void jlt_spool_rewind(jlt_spool *self, size_t sequence);

/** The next record of the sequence that is being read, (width,). Errors: IO; EMPTY, there is no more. */
JLT_CHECKED jlt_status jlt_spool_read(jlt_spool *self, double *record);

#endif
