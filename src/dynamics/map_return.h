/** The start and the end of one return with derivative, which jlt_map and jlt_map_batch share; either integrates in between. A
 *  varied state is the state, then dim tangent vectors one after another (derivatives by the start's coordinates, these counted in
 *  units of 2^chart->unit), then the integral of the divergence. */
#ifndef JLT_DYNAMICS_MAP_RETURN_H
#define JLT_DYNAMICS_MAP_RETURN_H

#include "dynamics/section.h"

/** Make the varied state with which the orbit from q, shape (dim,), starts, and the density of flux there.
 *  Errors: as the chart's lift; DOMAIN, the state is at rest. */
JLT_CHECKED jlt_status jlt_map_return_start(double *varied, double *flux, const jlt_flow *flow, const double *q,
                                            int time_direction);

typedef struct {
    double f[JLT_CHART_STATES_MAX]; /* the field at the return */
    double determinant;             /* of DP */
    double flux_determinant;        /* |det DP| by flux and divergence, the identity in map.h */
    double size;                    /* the product of DP's row lengths, to which rounding errors of both are relative */
} jlt_map_return;

/** Compute the return whose varied orbit ends in `varied`; flux: the density at its start. Out: q, shape (dim,), the image; slope,
 *  shape (dim, dim), DP in coordinates counted in units of 2^chart->unit. Errors: NONFINITE, also of the flux; NO_CONVERGENCE, the
 *  image is on another branch of a chart that solves for states. */
JLT_CHECKED jlt_status jlt_map_return_end(jlt_map_return *out, double *q, double *slope, const jlt_flow *flow, const double *varied,
                                          double flux);

/** Sizes on the way of a return, for the bound of its errors. The least ones possible: {tolerance, 1, 1, 0}. */
typedef struct {
    double error;    /* of all steps, relative to the size of each value: one tolerance for each step */
    double growth;   /* ratio of the largest to the smallest tangent vector on the way */
    double swing;    /* largest |integral of the divergence| on the way, at least 1 */
    double gradient; /* sum over the states of |d f_c/dx_i| times the size of x_i, at the return */
} jlt_map_return_steps;

/** Bound the difference of |determinant| and flux_determinant, over `size`, that these errors cause, to first order; slope: DP as
 *  jlt_map_return_end gives it. */
double jlt_map_return_bound(const jlt_map_return *self, const jlt_map_return_steps *steps, const jlt_flow *flow,
                            const double *varied, const double *slope);

/** Convert such a DP, in place, to the coordinates' own units. */
void jlt_map_return_restore(double *slope, const jlt_chart *chart);

#endif
