/** Symmetric periodic orbits of a reversible map, as zeros of one function of one variable.
 *
 *  The reversor S of the flow leaves the states alone whose mirrored coordinates vanish. An orbit that meets this set twice is
 *  periodic and its own mirror image, and every symmetric periodic orbit meets it in exactly two points, half a period
 *  apart. So an orbit is started on the set, at the free coordinate u of a line, and followed over j crossings of the
 *  section in either direction: where the mirrored coordinate h_j(u) (its sine, for an angle) changes sign through zero, there is
 *  a symmetric orbit of 2j crossings.
 *  Source: R. DeVogelaere (1958); J. Lamb, J. Roberts, Physica D 112 (1998). */
#ifndef JLT_DYNAMICS_SYMMETRIC_H
#define JLT_DYNAMICS_SYMMETRIC_H

#include "dynamics/periodic.h"
#include "kernel_abi.h"

typedef struct {
    double base[JLT_CHART_DIM_MAX]; /* a point of the line; its mirrored coordinate must be 0, or half a period of an angle, which
                                       is not checked */
    unsigned free;                  /* the coordinate that varies along the line */
    double low, high;
    size_t samples;                 /* >= 2, evenly spread over [low, high]; the space between two is halved, up to 7 times, where a
                                       zero may be missed */
} jlt_symmetric_line;

typedef struct {
    /* Called for every orbit found; a status other than JLT_OK ends the search with it. */
    jlt_status (*found)(void *context, const jlt_periodic *orbit);
    /* Called now and then, by the caller's thread: `done` of `all` are done; what: first "samples", among them those that are
     * added, then "zeros" of the h_j. NULL: not called. */
    void (*progress)(void *context, const char *what, size_t done, size_t all);
    void *context;
} jlt_symmetric_sink;

/** Search for the orbits of up to period_max returns. kernels: of the flow's field, for samples in lanes (NULL: they go one at a
 *  time), on `threads` threads. Two zeros of h_j between neighbouring samples are not seen: samples are added where an h_j changes
 *  by more than a quarter from one to the next, where orbits begin or cease to return j times, and next to the least |h_j| if a
 *  parabola through it may reach zero. Each orbit is refined by jlt_periodic_find and starts at its point nearest to the fixed set.
 *  Samples without a state are skipped.
 *  Errors: UNSUPPORTED, the chart is not reversible, or does not mirror exactly one coordinate other than `free`; ARG, samples,
 *  free or an empty interval; NO_CONVERGENCE, interrupted; NOMEM; the sink's.
 *  Cost: period_max crossings (half as many where the flow's direction is JLT_BOTH) of every sample, those added among them: up to
 *  some 4 million numbers h_j; and some 12 j more for each zero of an h_j. */
JLT_CHECKED jlt_status jlt_symmetric_search(jlt_map *map, const jlt_symmetric_line *line, size_t period_max,
                                            const jlt_kernel_batch *kernels, unsigned threads, const jlt_symmetric_sink *sink);

#endif
