/** The program `jellett-bench`, which `jellett bench` runs: what a question costs by each method, and how far off the answer
 *  is. One file a kind of question; each writes the rows of one table. Times are seconds of this processor, errors distances to
 *  a reference far below rounding. */
#ifndef JLT_BENCH_H
#define JLT_BENCH_H

#include <stdbool.h>
#include <stddef.h>

#include "cli/command.h"
#include "cli/progress.h"

typedef struct {
    const char *reference; /* NULL: not given */
    const char *form, *method; /* only this tier, this method; NULL: all */
    size_t returns, repeats, threads;
    bool quick;            /* every third decade of tolerance, from 1e-5 */
    bool list;             /* section, slope: only name what there is, a line "TIER METHOD" or "METHOD" each */
} jlt_bench_options;

typedef struct {
    const char *name, *meaning;
    const char *columns;   /* the table's header */
    bool needs_reference;  /* or takes none */
    bool has_forms, has_methods; /* takes --form, --method */
    /* Writes rows. Says what is wrong, and returns the exit status. */
    jlt_exit (*run)(FILE *table, const jlt_bench_options *options);
} jlt_bench_kind;

extern const jlt_bench_kind jlt_bench_section, jlt_bench_slope, jlt_bench_jacobian, jlt_bench_eigenvalues, jlt_bench_tiers;

/** A file of numbers, row by row; lines that do not begin with a number are passed over. */
typedef struct {
    size_t rows, columns;
    double *values; /* shape (rows, columns), owned */
} jlt_bench_table;

/** Errors: IO; ARG, no row, or a row with fewer numbers than columns; NOMEM. */
JLT_CHECKED jlt_status jlt_bench_read(jlt_bench_table *table, const char *path, size_t columns);
void jlt_bench_clear(jlt_bench_table *table); /* legal on a zeroed table */

/** Say that a table could not be read, and why (for IO in errno), with the exit status that it calls for. */
jlt_exit jlt_bench_unread(const char *path, jlt_status status);

/** Least, median and largest of the repeats, in seconds. */
typedef struct {
    double least, median, largest;
} jlt_bench_time;

/** Run pass(context) once to warm up, `first` being true then, and `repeats` times for the clock. A pass that takes longer
 *  than half a second is not repeated: its time is all three figures. With one thread the clock is that of the processor, which
 *  stands still while other processes run; with more it is the wall's. Errors: those of pass, NOMEM. */
JLT_CHECKED jlt_status jlt_bench_clock(jlt_bench_time *time, size_t repeats, unsigned threads,
                                       jlt_status (*pass)(void *context, bool first), void *context);

/* A field of a table, after a comma: empty for NaN. */
void jlt_bench_number(FILE *table, const char *format, double value);

/* The tolerances of a diagram, from 1e-4 to 1e-15, by index; 0 past the end. */
double jlt_bench_tolerance(const jlt_bench_options *options, size_t index);

#endif
