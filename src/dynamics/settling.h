/** Detects an orbit that settles on its section, where returns cannot be told from errors any more.
 *
 *  A mere passage looks the same for a while: where an orbit leaves a saddle in the section, is slow relative to fast oscillations,
 *  or decays and grows again as one of its parameters swings. So an orbit has settled only after a thousand steps within the
 *  errors, and four times as long as all the time before, while its distance does not grow. Waiting in vain then costs a multiple
 *  of the returns that were found. */
#ifndef JLT_DYNAMICS_SETTLING_H
#define JLT_DYNAMICS_SETTLING_H

#include <stdbool.h>
#include <stddef.h>

/** The caller zeroes it at the start and at each return. */
typedef struct {
    size_t steps;             /* how many of the last steps all ended within the errors of the section */
    double since;             /* |t| at the first of them, where t counts from the start of the orbit */
    double farthest, earlier; /* the largest distance since `steps` was a power of two, and that between the two powers before */
    bool grows;               /* `farthest` was above `earlier` when `steps` last was a power of two */
} jlt_settling;

/** Call after an accepted step. distance: from the section, in units of its errors; time: |t|. Returns whether the orbit has
 *  settled. */
bool jlt_settling_step(jlt_settling *self, double distance, double time);

#endif
