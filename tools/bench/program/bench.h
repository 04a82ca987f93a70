/** The program `jellett-bench`, which `jellett bench` runs: it measures what a computation costs by each method, and the error of
 *  its result. There is one file for each kind of computation, which writes the rows of one table. Times are in seconds on this
 *  processor; errors are distances to a reference whose own error is far below rounding. */
#ifndef JLT_BENCH_H
#define JLT_BENCH_H

#include <stdbool.h>
#include <stddef.h>

#include "cli/command.h"
#include "cli/progress.h"

typedef struct {
    const char *reference; /* file, or folder, of reference values; NULL: not given */
    const char *form, *method; /* only this tier; only this method; NULL: all */
    size_t returns, repeats, threads;
    bool quick;            /* only every third decade of tolerance, from 1e-5 on */
    bool list;             /* for section and slope: only list what could be measured, in lines "TIER METHOD" or "METHOD" */
} jlt_bench_options;

typedef struct {
    const char *name, *meaning;
    const char *columns;   /* the table's header */
    const char *takes;     /* the letters of its options; where -r is among them, it must be given */
    /* Writes rows. Returns the exit status, after a message unless it is JLT_EXIT_DONE. */
    jlt_exit (*run)(FILE *table, const jlt_bench_options *options);
} jlt_bench_kind;

extern const jlt_bench_kind jlt_bench_section, jlt_bench_slope, jlt_bench_jacobian, jlt_bench_eigenvalues, jlt_bench_tiers;

/** Numbers from a CSV file, row by row; lines that do not begin with a number are skipped. */
typedef struct {
    size_t rows, columns;
    double *values; /* shape (rows, columns), owned */
} jlt_bench_table;

/** Read a file; columns: how many numbers to take from each row. Errors: IO (errno says why); ARG, there is no row, or a row has
 *  fewer numbers; NOMEM. */
JLT_CHECKED jlt_status jlt_bench_read(jlt_bench_table *table, const char *path, size_t columns);
void jlt_bench_clear(jlt_bench_table *table); /* legal on a zeroed table */

/** Print that a table could not be read, and why (for IO from errno). Returns the exit status for it. */
jlt_exit jlt_bench_unread(const char *path, jlt_status status);

/** Least, median and largest of the repeats, in seconds. */
typedef struct {
    double least, median, largest;
} jlt_bench_time;

/** Run pass(context, true) once to warm up, then pass(context, false) `repeats` times, timed. If the first pass takes longer than
 *  half a second, it is the only one, and its time is all three figures. With one thread processor time is measured, which does not
 *  run while other processes do; with more threads wall time. Errors: those of pass, NOMEM. */
JLT_CHECKED jlt_status jlt_bench_clock(jlt_bench_time *time, size_t repeats, unsigned threads,
                                       jlt_status (*pass)(void *context, bool first), void *context);

/* Write a comma and a number, or an empty field for NaN. */
void jlt_bench_number(FILE *table, const char *format, double value);

/* Tolerance number `index` of a diagram, from 1e-4 down to 1e-15; 0 past the end. */
double jlt_bench_tolerance(const jlt_bench_options *options, size_t index);

#endif
