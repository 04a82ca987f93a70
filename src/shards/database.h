/** A merged study as one file of SQLite: `rows`, in the order of the study, with an index on every column that the study runs over
 *  and on every column of text; `pieces`, how each piece ended and what was said; `provenance`, what the rows were computed by. The
 *  file is in WAL mode, so that readers and one writer who adds tables to it do not wait for each other. */
#ifndef JLT_SHARDS_DATABASE_H
#define JLT_SHARDS_DATABASE_H

#include "shards/shard.h"
#include "report/table.h"

typedef struct jlt_database jlt_database;

/** Begin a database. In: path, an empty file, or none; form, the columns, of which the first `over` are those that the study runs
 *  over; study, its JSON. Out: *out, for jlt_database_destroy, unless it is finished; *message, what is wrong, for the caller to
 *  free(), else NULL. Errors: IO, NOMEM. The same calls give the same bytes by one version of SQLite. */
JLT_CHECKED jlt_status jlt_database_create(jlt_database **out, char **message, const char *path, const jlt_table_form *form,
                                           size_t over, const char *study);

/** Add how a piece ended; add a row by its fields, one a column. Errors: IO, NOMEM. */
JLT_CHECKED jlt_status jlt_database_piece(jlt_database *self, const jlt_shard_record *record);
JLT_CHECKED jlt_status jlt_database_row(jlt_database *self, char *const *fields);

/** Make the indexes, and close. On failure *message as above. */
JLT_CHECKED jlt_status jlt_database_finish(jlt_database *self, char **message);
void jlt_database_destroy(jlt_database *self); /* NULL is legal, and one that is finished is not */

#endif
