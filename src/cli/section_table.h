/** The table of `jellett section`: a row for every return. */
#ifndef JLT_CLI_SECTION_TABLE_H
#define JLT_CLI_SECTION_TABLE_H

#include <stdio.h>

#include "dynamics/map.h"
#include "dynamics/system.h"

typedef struct {
    const jlt_system *system;
    bool least; /* a column for the least value of the model's conditions */
    bool check;   /* columns for DP */
    jlt_map *map; /* of check; not owned */
    int time_direction;
    double worst_share, worst_defect; /* of the defect that is the largest part of its bound: that, and it */
    size_t checked, unchecked;        /* returns whose DP was computed, and could not be */
} jlt_section_table;

/* What of a return the table shows. */
typedef struct {
    size_t orbit, number;
    double t, least;
    jlt_fate fate;
    unsigned lost;
    double values[]; /* q (dim,); x (states,); the point before (dim,), which is read by check and not for number 0 */
} jlt_section_row;

/** Bytes of a row; filling one, before (dim,) or NULL. */
size_t jlt_section_row_size(const jlt_chart *chart);
void jlt_section_row_fill(jlt_section_row *row, const jlt_chart *chart, size_t orbit, const jlt_return *at, const double *before);

void jlt_section_table_names(FILE *stream, const jlt_section_table *table);

/** As jlt_writer_text: table is a jlt_section_table, row a jlt_section_row. With check for one thread at a time. */
void jlt_section_table_row(FILE *stream, void *table, const void *row);

/** Says on standard error what the check found. False: a determinant is beyond its bound, or there were returns and none of them
 *  could be checked. */
bool jlt_section_table_verdict(const jlt_section_table *table);

/** Which conditions are lost: "contact", or "contact (2) or grip (1)". orbits, shape (JLT_OBSERVED_CONDITIONS_MAX,): how many lose each,
 *  of `all` that lose one. */
void jlt_section_table_lost(char *text, size_t size, const size_t *orbits, size_t all, const jlt_observed *observed);

#endif
