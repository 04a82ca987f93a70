/** Writes the results of `jellett transfer`: rows of boxes, a report in JSON, lines on standard error. */
#ifndef JLT_CLI_TRANSFER_REPORT_H
#define JLT_CLI_TRANSFER_REPORT_H

#include "analysis/transfer_finding.h"
#include "cli/motion.h"

/* One operator, on boxes `factor` times as wide as those asked for. */
typedef struct {
    size_t factor;
    double noise;
    const jlt_transfer *transfer;
    jlt_transfer_finding finding;
} jlt_transfer_case;

typedef struct {
    const jlt_motion_options *motion;
    const jlt_system *system;
    const jlt_transfer_case *cases; /* (case_count,), grouped by noise, in each group from the finest boxes to the widest */
    size_t case_count;
    size_t wanted;                  /* how many eigenvalues were asked for */
    size_t points, strata, seed;    /* points mapped in all; strata along each coordinate of a box; seed of the points' places */
    bool backwards;
    const char *known;              /* name of a density that the table claims; NULL: there is none */
    const size_t *candidates;       /* (candidate_count,): boxes of the first operator, those of highest density */
    size_t candidate_count;
} jlt_transfer_report;

/** Write the names of the columns, and a row for each box of the first operator. */
void jlt_transfer_report_rows(FILE *file, const jlt_transfer_report *report);

/** Write in JSON, for programs, what jlt_transfer_report_text says. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_transfer_report_json(FILE *file, const jlt_transfer_report *report);

/** Write lines for a reader: each operator with what it shows, and where to look further. */
void jlt_transfer_report_text(FILE *stream, const jlt_transfer_report *report);

#endif
