/** Are attractor and repeller apart? Cells of the section visited by long orbits forwards and backwards in time.
 *
 *  The reversor maps the forward set onto the backward one. Where the two sets agree the dynamics looks conservative; where
 *  they share no cell an attractor and a repeller are apart; a part in common is what mixed dynamics shows. Which of these
 *  is seen depends on the cells and on the orbit's length, so counts are given as the length doubles.
 *  Source: A. Gonchenko, S. Gonchenko, A. Kazakov, D. Turaev, Physica D 350 (2017). */
#ifndef JLT_DYNAMICS_SEPARATION_H
#define JLT_DYNAMICS_SEPARATION_H

#include "dynamics/section.h"

typedef struct {
    size_t returns;        /* counted after the settling, of each orbit */
    size_t alive_forward, alive_backward;
    size_t forward, backward, common; /* cells visited */
    double overlap;        /* common/(forward + backward - common); 1: the same set, 0: apart */
    double mirror_overlap; /* of the forward set's mirror image with the backward set: 1 but for finite length */
} jlt_separation;

typedef struct {
    double low[2], high[2];
    size_t cells[2];
    size_t settle;     /* returns left out at the start */
    size_t returns;    /* counted at most */
} jlt_separation_options;

/** Rows for returns = 2^k up to options->returns, *rows of them (at most 48), into out. starts: (count, 2); those that
 *  have no state are passed over; orbits that end are counted up to their end when it comes after the settling.
 *  Errors: ARG, a section of more than two coordinates or without reversor; NOMEM; NO_CONVERGENCE (interrupted). */
JLT_CHECKED jlt_status jlt_separation_measure(jlt_separation *out, size_t *rows, const jlt_flow *flow,
                                              const double *starts, size_t count,
                                              const jlt_separation_options *options);

#endif
