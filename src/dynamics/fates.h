/** What becomes of an orbit from a section within a number of returns: whether it ends, how (jlt_fate, dynamics/section.h) and
 *  when; and counts of that over many starts. */
#ifndef JLT_DYNAMICS_FATES_H
#define JLT_DYNAMICS_FATES_H

#include "dynamics/failures.h"

typedef struct {
    jlt_fate fate;      /* ALIVE: all returns were found */
    unsigned unbounded; /* as in jlt_return */
    unsigned lost;      /* where fate is INVALID: the index of the condition that breaks, as in jlt_observed_condition */
    double t;           /* [time] of the end, or of the last return, since the start */
    size_t returns;     /* found before the end */
    double x[JLT_CHART_STATES_MAX]; /* (chart->states,), the state at that time; at a pole its limit */
    double least;       /* least value of the model's conditions (`valid` in its table) along the orbit: the model held throughout
                           if it is positive; INFINITY where there are none */
    bool interrupted;   /* by flow.interrupt: fate is ALIVE, and returns says how many were found until then */
} jlt_fates_end;

/** Follow the orbit forwards from q, shape (dim,), coordinates of the section, for at most `returns` returns. An orbit that
 *  ends, or on which the method fails, is no error: *end says so. Errors: as jlt_section_start (q is no start) and
 *  jlt_section_next; *end is then not touched. */
JLT_CHECKED jlt_status jlt_fates_follow(jlt_section *section, jlt_fates_end *end, const double *q, size_t returns);

/** The end of an orbit, from its last row. */
jlt_fates_end jlt_fates_of(const jlt_return *last);

/** Numbers of starts by fate; begin with all zero. */
typedef struct {
    size_t starts;                /* added so far */
    size_t by_fate[JLT_FATE_COUNT]; /* index: jlt_fate */
    size_t valid[JLT_FATE_COUNT]; /* of these, those on which the model held throughout */
    jlt_failures failures;
    size_t unknown;               /* starts on which it is unknown whether the model held: a condition had no value */
} jlt_fates_count;

/* Count one start. */
void jlt_fates_add(jlt_fates_count *count, const jlt_fates_end *end);

/** The number of starts on which the model held throughout. */
size_t jlt_fates_held(const jlt_fates_count *count);

/** Compute the share, 0 to 1, that `number` of all starts are. *error: the
 *  distance to the farther end of the interval of all x that differ from *share by at most their standard error,
 *  sqrt(x (1 - x)/starts) (E. B. Wilson, J. Amer. Stat. Assoc. 22 (1927)). Both are NaN for no starts. */
void jlt_fates_share(double *share, double *error, size_t number, size_t starts);

#endif
