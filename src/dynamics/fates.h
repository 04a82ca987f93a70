/** What becomes of orbits: which pole they end at, when, or never; and how many of a grid of starts turn over. */
#ifndef JLT_DYNAMICS_FATES_H
#define JLT_DYNAMICS_FATES_H

#include "dynamics/section.h"

typedef struct {
    jlt_fate fate;      /* ALIVE: neither an end nor a lost return within the budget */
    unsigned lost;      /* of invalid: the index of the condition that breaks */
    double t;           /* time of the end, or of the last return, since the start */
    size_t returns;
    double x[JLT_CHART_STATES_MAX]; /* the state at that time; at a pole the limit */
    double least;       /* least value of the model's conditions along the orbit: the model held throughout if it is positive */
    bool interrupted;
} jlt_fates_end;

/** Follow the orbit from q for at most `returns` returns. Errors: as jlt_section_start and jlt_section_next. */
JLT_CHECKED jlt_status jlt_fates_follow(jlt_section *section, jlt_fates_end *end, const double *q, size_t returns);

/** Numbers of starts by fate; begin with all zero. */
typedef struct {
    size_t starts;                /* that exist on the levels */
    size_t by_fate[JLT_FATE_COUNT];
    size_t valid[JLT_FATE_COUNT]; /* of these, those on which the model held throughout */
} jlt_fates_count;

void jlt_fates_add(jlt_fates_count *count, const jlt_fates_end *end);

/** Share of the starts with this fate, with its binomial standard error; NaN for no starts. held: only those on which
 *  the model held throughout. */
void jlt_fates_share(double *share, double *error, const jlt_fates_count *count, jlt_fate fate, bool held);

#endif
