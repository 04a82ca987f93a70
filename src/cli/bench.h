/** The section-map workload of `jellett bench`: what each form of the field and each method gives for the same question. */
#ifndef JLT_CLI_BENCH_H
#define JLT_CLI_BENCH_H

#include <stddef.h>

#include "core/status.h"
#include "kernel_abi.h"

enum { JLT_BENCH_STATES = 8 };

/** Starts and the true returns of the map: what a reference file holds. (gamma3, v_nu, omega_n, omega3) a point. */
typedef struct {
    size_t orbits, checked; /* returns known of every orbit */
    double (*start)[4];     /* shape (orbits,) */
    double (*expected)[4];  /* shape (orbits, checked) */
} jlt_bench_grid;

/** Read a file with the columns orbit, return, t, gamma3, v_nu, omega_n, omega3, ordered by orbit and return; return 0 is
 *  the start. Errors: IO; ARG, the file has another form; NOMEM. */
JLT_CHECKED jlt_status jlt_bench_read(jlt_bench_grid *grid, const char *path);
void jlt_bench_clear(jlt_bench_grid *grid); /* legal on a zeroed grid */

/** A form of the field: the same motion in other variables. */
typedef struct {
    const char *name; /* "level", "regular", "plain", ... */
    const char *meaning;
    const char *model, *time, *elimination;
} jlt_bench_form;

extern const jlt_bench_form jlt_bench_forms[]; /* ends with a NULL name */

/** One measurement. */
typedef struct {
    double error;   /* largest in gamma3, v_nu, omega3 over the returns known; NaN where an orbit gave none */
    double seconds[3]; /* least, median and largest of the repeats, for all returns of all orbits */
    double returns;    /* made in each repeat */
    double steps;      /* a return */
    size_t failed;     /* orbits that ended before their returns were made */
} jlt_bench_result;

/** Scalar: a method by name. Errors: UNSUPPORTED, no such kernel or no jet; NOMEM. */
JLT_CHECKED jlt_status jlt_bench_scalar(jlt_bench_result *result, const jlt_bench_form *form, const char *method,
                                        const jlt_bench_grid *grid, double tolerance, size_t returns, unsigned repeats);

/** Batched: at most `lanes` lanes, `threads` threads. Errors: UNSUPPORTED, the processor has no such lanes; NOMEM. */
JLT_CHECKED jlt_status jlt_bench_batch(jlt_bench_result *result, const jlt_bench_form *form, unsigned lanes,
                                       unsigned threads, const jlt_bench_grid *grid, double tolerance, size_t returns,
                                       unsigned repeats);

#endif
