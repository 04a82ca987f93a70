/** How integrals drift along one orbit of a section. */
#ifndef JLT_DYNAMICS_DRIFT_H
#define JLT_DYNAMICS_DRIFT_H

#include "dynamics/section.h"
#include "dynamics/system.h"
#include "integrate/invariant.h"

enum { JLT_DRIFT_ROWS_MAX = 64 }; /* powers of two */

typedef struct {
    size_t returns;
    double t, drift[JLT_INVARIANTS_MAX]; /* the largest |F - F(start)|/size so far of each watched integral; size: |F(start)|, or 1
                                            where that is 0 or no more than rounding */
    size_t evaluations;
} jlt_drift_row;

/* How the orbit ended before all returns were done. */
typedef struct {
    char name[JLT_FATE_TEXT_MAX]; /* by jlt_section_fate_text; "": the orbit has not ended */
    double t;                     /* in the table's unit */
    size_t returns;
} jlt_drift_end;

typedef struct {
    const jlt_system *system;
    double q[JLT_CHART_DIM_MAX]; /* the start on the section */
    size_t returns;
    unsigned count;                       /* integrals watched */
    unsigned watched[JLT_INVARIANTS_MAX]; /* their indices among those of the kernel */

    /* Called after every return; returns false to stop. due: the row's returns are a power of two, or it is the last row. */
    bool (*tell)(void *context, const jlt_drift_row *row, bool due);
    void *context;

    /* State of the orbit under way. */
    double first[JLT_INVARIANTS_MAX], sizes[JLT_INVARIANTS_MAX]; /* of the watched integrals, at the start */
    jlt_drift_row row;
    size_t last_due; /* returns of the last row that was due */
    bool stopped;
} jlt_drift;

/** Find out whether the integral with this index in the kernel changes when the section's angle grows by one period from q. Its
 *  drift cannot be measured then, since returns do not count turns. Errors: as the chart's lift; NOMEM. */
JLT_CHECKED jlt_status jlt_drift_turns(bool *turns, const jlt_system *system, const double *q, unsigned integral);

/** Follow the orbit from self->q with one method, for all returns or to its end. Errors: NONFINITE, an integral; those of the
 *  section, also the status that a failure of the method means (jlt_section_fate_status). */
JLT_CHECKED jlt_status jlt_drift_section(jlt_drift *self, jlt_drift_end *end, const jlt_method *method);

/** Exponent of the power of returns with which the drift of watched integral k grows: the least-squares slope in logarithms over
 *  the last four doublings; NaN where fewer than three of the rows, shape (count,), there have a drift > 0. */
double jlt_drift_slope(const jlt_drift_row *rows, size_t count, unsigned k);

/** The parts of jlt_drift_section, for callers that follow the orbit themselves. Call _begin and _first before the first return, x
 *  being the start, in the units of the instance; _note after each return, with `now`, shape (integral_count,), the kernel's
 *  integrals at that point; _finish after the last.
 *  Errors of _first: NOMEM; of _note: NONFINITE. */
void jlt_drift_begin(jlt_drift *self, jlt_drift_end *end);
JLT_CHECKED jlt_status jlt_drift_first(jlt_drift *self, const jlt_instance *instance, const double *x);
JLT_CHECKED jlt_status jlt_drift_note(jlt_drift *self, size_t returns, double t, size_t evaluations, const double *now);
void jlt_drift_finish(jlt_drift *self, const jlt_drift_end *end);

#endif
