/** What jellett transfer says: rows of boxes, a report in JSON, lines on standard error. */
#ifndef JLT_CLI_TRANSFER_REPORT_H
#define JLT_CLI_TRANSFER_REPORT_H

#include "analysis/transfer_finding.h"
#include "cli/motion.h"

/* One operator: the boxes of the command `factor` times wider. */
typedef struct {
    size_t factor;
    double noise;
    const jlt_transfer *transfer;
    jlt_transfer_finding finding;
} jlt_transfer_case;

typedef struct {
    const jlt_motion_options *motion;
    const jlt_system *system;
    const jlt_transfer_case *cases; /* (case_count,): by noise, and of each from the finest boxes to the widest */
    size_t case_count;
    size_t wanted;                  /* eigenvalues */
    size_t points, strata, seed;    /* mapped in all; along each coordinate of a box; of their places */
    bool backwards;
    const char *known;              /* a density of the table; NULL: there is none */
    const size_t *candidates;       /* (candidate_count,): places in the first operator */
    size_t candidate_count;
} jlt_transfer_report;

/** Write the names of the columns, and a row for each box of the first operator. */
void jlt_transfer_report_rows(FILE *file, const jlt_transfer_report *report);

/** Write in JSON, for programs, what jlt_transfer_report_text says. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_transfer_report_json(FILE *file, const jlt_transfer_report *report);

/** Write lines for a reader: each operator, what it tells, and where to look. */
void jlt_transfer_report_text(FILE *stream, const jlt_transfer_report *report);

#endif
