/** How integrals drift along one orbit: what `jellett drift` follows, and the rows that come of it. */
#ifndef JLT_CLI_DRIFT_H
#define JLT_CLI_DRIFT_H

#include "cli/motion.h"
#include "cli/progress.h"
#include "integrate/invariant.h"
#include "top/top_five.h"

enum { JLT_DRIFT_ROWS_MAX = 64 }; /* powers of two */

typedef struct {
    size_t returns;
    double t, drift[JLT_INVARIANTS_MAX]; /* the largest so far of each integral that is watched */
    size_t evaluations;
} jlt_drift_row;

/* What may come before all returns are done. */
typedef struct {
    char name[JLT_FATE_TEXT_MAX]; /* as fates are called; "": none */
    double t;                     /* in the table's unit */
    size_t returns;
} jlt_drift_end;

typedef struct {
    const jlt_system *system;
    size_t returns;
    bool project;                         /* of the five states; a section has it in its flow */
    FILE *file, *points;                  /* points: the same for a picture, or NULL */
    unsigned count;                       /* integrals watched */
    unsigned watched[JLT_INVARIANTS_MAX]; /* their indices among those of the kernel */
    const char *names[JLT_INVARIANTS_MAX];
    double q[JLT_CHART_DIM_MAX]; /* the start on the section */
    jlt_progress progress;
    jlt_top_five five;           /* of the spherical top: all states, in which what levels fix are integrals */
} jlt_drift;

/** One method over all returns of the section, or to the orbit's end; rows at powers of two and at the end, *count of them in
 *  rows (JLT_DRIFT_ROWS_MAX,). Errors: those of the section. */
JLT_CHECKED jlt_status jlt_drift_section(jlt_drift *self, jlt_drift_row *rows, size_t *count, jlt_drift_end *end,
                                         const jlt_method *method);

/** The same of the spherical top, in the states of `five`: the only section that is known by name. Errors: those of the orbit. */
JLT_CHECKED jlt_status jlt_drift_top(jlt_drift *self, jlt_drift_row *rows, size_t *count, jlt_drift_end *end,
                                       const jlt_method *method);

/* For those two: takes the drifts `now` after row->returns returns, and writes the row where that is a power of two or the last.
 * sizes: of the integrals at the start, shape as first, which drifts are divided by. Errors: NONFINITE, an integral. */
JLT_CHECKED jlt_status jlt_drift_note(jlt_drift *self, const jlt_method *method, jlt_drift_row *row, jlt_drift_row *rows, size_t *count,
                                      const double *first, const double *sizes, const double *now);

/* The last row, where the orbit ended on the way. */
void jlt_drift_end_row(const jlt_drift *self, const jlt_method *method, const jlt_drift_row *row, jlt_drift_row *rows, size_t *count,
                       const jlt_drift_end *end);

#endif
