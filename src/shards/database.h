/** A merged study as one SQLite file of three tables: `rows`, in the order of the study, with an index on every column that the
 *  study runs over and on every text column; `pieces`, with each piece's exit status and what its command wrote to standard error;
 *  `provenance`, the study's JSON and its members. The file is in WAL mode, so that readers and one writer do not block each
 *  other. */
#ifndef JLT_SHARDS_DATABASE_H
#define JLT_SHARDS_DATABASE_H

#include "shards/shard.h"
#include "report/table.h"

typedef struct jlt_database jlt_database;

/** Begin a database. In: path, an empty file, or none; form, the columns, the first `over` of which the study runs over; it must
 *  outlive the database; study, its JSON. Out: *out, for jlt_database_finish or jlt_database_destroy; *message, the reason of a
 *  failure, for the caller to free(), else NULL. Errors: IO, NOMEM. With one version of SQLite the same calls give the same
 *  bytes. */
JLT_CHECKED jlt_status jlt_database_create(jlt_database **out, char **message, const char *path, const jlt_table_form *form,
                                           size_t over, const char *study);

/** Add a piece's number, status and words; add a row from its fields, one for each column. Errors: IO, NOMEM. */
JLT_CHECKED jlt_status jlt_database_piece(jlt_database *self, const jlt_shard_record *record);
JLT_CHECKED jlt_status jlt_database_row(jlt_database *self, char *const *fields);

/** Make the indexes, close the file, and free `self`, also on failure. *message: as above. Errors: IO, NOMEM. */
JLT_CHECKED jlt_status jlt_database_finish(jlt_database *self, char **message);
void jlt_database_destroy(jlt_database *self); /* NULL is legal; not legal after jlt_database_finish */
JLT_OWNED_TYPE(jlt_database)

#endif
