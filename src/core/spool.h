/** Stores the records of many interleaved sequences, and reads them back one sequence after another. The latest records of each
 *  sequence stay in memory, older ones go to an unnamed temporary file: memory does not grow with the number of records. */
#ifndef JLT_CORE_SPOOL_H
#define JLT_CORE_SPOOL_H

#include <stddef.h>

#include "core/status.h"

typedef struct jlt_spool jlt_spool;

/** Create an empty spool. A record is `width` numbers; each of the `sequences` sequences keeps up to `room` records in memory. The
 *  file lies in $TMPDIR or /tmp; it is created when it is first needed, and child processes do not inherit it.
 *  Errors: ARG, one of the three counts is 0; NOMEM. Memory: (sequences + 1) * room records. */
JLT_CHECKED jlt_status jlt_spool_create(jlt_spool **out, size_t width, size_t sequences, size_t room);
void jlt_spool_destroy(jlt_spool *self); /* NULL is legal */

/** Append a record, shape (width,), to a sequence. Several threads may do so at once, each to sequences of its own. Errors: IO. */
JLT_CHECKED jlt_status jlt_spool_add(jlt_spool *self, size_t sequence, const double *record);

/** Forget the records of a sequence. Several threads may do so at once, each with sequences of its own. */
void jlt_spool_forget(jlt_spool *self, size_t sequence);

/** Make jlt_spool_read begin at the first record of this sequence. Only one sequence is read at a time. */
void jlt_spool_rewind(jlt_spool *self, size_t sequence);

/** The next record, shape (width,), of the sequence chosen by jlt_spool_rewind. Errors: IO; EMPTY after the last record. */
JLT_CHECKED jlt_status jlt_spool_read(jlt_spool *self, double *record);

#endif
