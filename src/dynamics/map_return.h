/** One return of a map from the ends of its varied orbit, whichever method went the way between: what jlt_map and jlt_map_batch
 *  share. A varied state is the state, tangent vectors by columns, and the integral of the divergence. */
#ifndef JLT_DYNAMICS_MAP_RETURN_H
#define JLT_DYNAMICS_MAP_RETURN_H

#include "dynamics/section.h"

/** Make the varied state with which the orbit from q, shape (dim,), starts, and the density of flux there.
 *  Errors: as the chart's lift; DOMAIN, it is at rest. */
JLT_CHECKED jlt_status jlt_map_return_start(double *varied, double *flux, const jlt_flow *flow, const double *q);

typedef struct {
    double f[JLT_CHART_STATES_MAX]; /* the field at the return */
    double determinant;             /* of DP */
    double flux_determinant;        /* its size by flux and divergence, by the identity in map.h */
    double size;                    /* the product of DP's row lengths, which rounding errors of both are relative to */
} jlt_map_return;

/** The image q, shape (dim,), and DP, shape (dim, dim), by coordinates in the chart's units of tangent vectors, of the return whose
 *  varied orbit ends in `varied` and had the flux at its start. Errors: NONFINITE, also of the flux; NO_CONVERGENCE, it is on
 *  another branch of a chart that solves for states. */
JLT_CHECKED jlt_status jlt_map_return_end(jlt_map_return *out, double *q, double *slope, const jlt_flow *flow, const double *varied,
                                          double flux);

/** Turn such a DP, in place, into one of coordinates as they stand. */
void jlt_map_return_restore(double *slope, const jlt_chart *chart);

#endif
