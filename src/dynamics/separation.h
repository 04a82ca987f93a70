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
    size_t returns;        /* counted of each orbit, at most, after those left out */
    size_t alive_forward, alive_backward; /* orbits alive after options->settle + options->returns: the same in every row */
    size_t strayed;        /* orbits that left the branch of a chart that solves for states, and were followed no further: the same
                              in every row */
    size_t forward, backward, common;     /* cells visited: forwards, backwards, and both ways */
    double overlap;        /* common/(forward + backward - common); 1: the same set, 0: apart; NaN: no cell was visited */
    double mirror_overlap; /* that of the forward set's mirror image and the backward set: tends to 1 with `returns` */
} jlt_separation;

typedef struct {
    double low[2], high[2];
    size_t cells[2];
    size_t settle;     /* returns left out at the start */
    size_t returns;    /* counted at most */
    const jlt_kernel_batch *kernels; /* of the flow's field, for lanes; NULL: each orbit alone, by the flow's method */
    unsigned threads;  /* 0 and 1: the caller's alone */
    bool by_mirror;    /* the chart's reversor is proved: where a start and its mirror image are both starts, the backward orbit of
                          one is not followed, but taken to be the mirror image of the forward orbit of the other. Half the cost on
                          a symmetric grid. Where orbits may end at the edge of a domain, or as a condition of the model breaks, all
                          are followed */
} jlt_separation_options;

/** Count the cells visited. Out: out, with room for 48 rows: one for each power of two of returns below options->returns, and one
 *  for options->returns; *rows, how many. In: starts, shape (count, 2); a start without a state is skipped, and an orbit that ends
 *  is counted up to its end.
 *  Errors: ARG, a section of other than two coordinates or without reversor, no cells or more than can be counted, a region that is
 *  empty or not finite, no returns or more than 2^47;
 *  NO_CONVERGENCE (interrupted); as jlt_section_batch_run. */
JLT_CHECKED jlt_status jlt_separation_measure(jlt_separation *out, size_t *rows, const jlt_flow *flow,
                                              const double *starts, size_t count,
                                              const jlt_separation_options *options);

#endif
