/** Puts the rows of a point of a sweep, or of a piece of a study, under the columns of the table, which are those of the first
 *  point or piece: where a tier or variant changes, columns may change as well. */
#ifndef JLT_CLI_COLUMN_MAP_H
#define JLT_CLI_COLUMN_MAP_H

#include <stdbool.h>

enum { JLT_COLUMN_MAP_MAX = 512 };

/** from: for each column of the table, shape (count,), its index among a point's columns, JLT_COLUMN_MAP_MAX if it is not there. */
typedef struct {
    unsigned from[JLT_COLUMN_MAP_MAX], count;
    unsigned own; /* how many columns the point has */
    bool same;    /* they are the table's */
} jlt_column_map;

/** Map the columns `own` of a point, names between commas, to those of the table, `whole`. Prints what is left empty and what is
 *  left out, with the point in words, `where`, unless `own` equals *odd, the columns for which this was printed last (for free();
 *  NULL at first). Returns false when memory is out. */
bool jlt_column_map_make(jlt_column_map *map, char **odd, const char *where, const char *whole, const char *own);

/** Cut a line at its commas into fields. Returns their number, at most JLT_COLUMN_MAP_MAX. */
unsigned jlt_column_map_cut(char *fields[JLT_COLUMN_MAP_MAX], char *line);

#endif
