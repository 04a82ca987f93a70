/** Output files of a merged study: CSV, a structured NumPy array, or SQLite, by the path's ending; written whole or not at all. */
#ifndef JLT_CLI_MERGED_H
#define JLT_CLI_MERGED_H

#include <stdio.h>

#include "cli/command.h"
#include "report/npy.h"
#include "shards/database.h"
#include "report/table.h"

typedef enum { JLT_MERGED_CSV, JLT_MERGED_NPY, JLT_MERGED_SQLITE } jlt_merged_kind;

typedef struct {
    const char *path;
    jlt_merged_kind kind;
    jlt_file place; /* zeroed for standard output */
    FILE *stream;   /* takes the CSV */
    jlt_npy *array;
    jlt_database *database;
} jlt_merged;

/** The kind of file that a path's ending means: .csv, .npy, .sqlite or .db; "-" is CSV. Returns false for any other ending. */
bool jlt_merged_known(jlt_merged_kind *kind, const char *path);

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
