/** Output files of a merged study: CSV, a structured NumPy array, or SQLite, by the path's ending; written whole or not at all. */
#ifndef JLT_CLI_MERGED_H
#define JLT_CLI_MERGED_H

#include "cli/stream.h"
#include "shards/database.h"
#include "report/table.h"

typedef struct {
    const char *path;
    jlt_stream stream;      /* of CSV and NumPy */
    jlt_file place;         /* of SQLite, as is the next; else zeroed */
    jlt_database *database;
} jlt_merged;

/** Whether a file of this name is one of SQLite: .sqlite or .db. */
bool jlt_merged_is_database(const char *path);

/** Whether a path's ending is known: .csv, .npy, .sqlite or .db; "-" is CSV. */
bool jlt_merged_known(const char *path);

/** Begin a file, and write what precedes its rows. The first `over` columns are those that the study runs over. study: its
 *  manifest, for SQLite; header: comments, for CSV and NumPy. Call jlt_merged_discard in the end, whatever is returned. */
jlt_exit jlt_merged_open(jlt_merged *self, const char *path, const jlt_table_form *form, size_t over, const char *study,
                         const char *header);

/** Begin the rows of a piece; write one row, its fields as text in the order of the columns. Return false if writing fails. */
bool jlt_merged_piece(jlt_merged *self, const jlt_shard_record *record);
bool jlt_merged_row(jlt_merged *self, const jlt_table_form *form, char *const *fields);

/** Finish the file, and rename it to its path. */
jlt_exit jlt_merged_close(jlt_merged *self);

/** Release everything, and remove an output that jlt_merged_close has not finished. Legal when zeroed, and twice. */
void jlt_merged_discard(jlt_merged *self);

#endif
