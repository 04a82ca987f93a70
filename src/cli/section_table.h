/** The table of `jellett section`: a row for every return. */
#ifndef JLT_CLI_SECTION_TABLE_H
#define JLT_CLI_SECTION_TABLE_H

#include <stdio.h>

#include "dynamics/map_batch.h"
#include "dynamics/system.h"

typedef struct {
    const jlt_system *system;
    bool least;   /* add a column for the least value of the model's conditions */
    bool check;   /* add columns for DP */
    bool as_bits; /* the rows go to an array: numbers may be written as bits */
    jlt_map_batch *maps; /* computes DP for `check`; not owned */
    int time_direction;
    double worst_share, worst_defect; /* the largest ratio of a defect to its bound, the largest defect */
    size_t checked, strayed, unchecked; /* returns with DP; from or to another branch, where no DP exists; failed ones */
    size_t dropped;                     /* rows left out, from the first return whose DP an interrupt cut off */
} jlt_section_table;

/* What the table shows of one return. */
typedef struct {
    size_t orbit, number;
    double t, least;
    jlt_fate fate;
    unsigned lost;
    double values[]; /* q (dim,); x (states,); for `check` the previous point (dim,), NaN if the chart does not lift it to the
                        orbit's state, and what jlt_section_table_check makes of it, (4,) */
} jlt_section_row;

/** The size in bytes of a row for sections of this chart. Fill a row from `at`, return number at->number of orbit number `orbit`;
 *  before, shape (dim,), is the point of which it is the return, NULL at the start of an orbit. */
size_t jlt_section_row_size(const jlt_chart *chart);
void jlt_section_row_fill(jlt_section_row *row, const jlt_chart *chart, size_t orbit, const jlt_return *at, const double *before);

void jlt_section_table_names(FILE *stream, const jlt_section_table *table);

/** Write a row, as a jlt_writer_text: table is a jlt_section_table, row a jlt_section_row. */
void jlt_section_table_row(FILE *stream, void *table, const void *row);

/** Compute the columns of `check` for rows, as a jlt_writer_complete. Errors: NOMEM; as jlt_batch_section. */
JLT_CHECKED jlt_status jlt_section_table_check(void *table, void *rows, size_t *count);

/** Print on standard error what the check of DP found. Returns false if a defect of det DP exceeds its bound or is not a number, if
 *  DP could not be computed at a return that has one, or if no return has one. */
bool jlt_section_table_verdict(const jlt_section_table *table);

/** Name the conditions that orbits lose: "contact", or "contact (2) or grip (1)". Out: text, `size` bytes. orbits, shape
 *  (JLT_OBSERVED_CONDITIONS_MAX,): how many orbits lose each condition, of `all` that lose one. */
void jlt_section_table_lost(char *text, size_t size, const size_t *orbits, size_t all, const jlt_observed *observed);

#endif
