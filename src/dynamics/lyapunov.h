/** Lyapunov exponents of a return map: growth rates of its derivative DP per unit of physical time, by a QR decomposition after
 *  every return (Benettin et al., Meccanica 15, 1980; Dieci, Russell, Van Vleck, SIAM J. Numer. Anal. 34, 1997).
 *
 *  The sum of all exponents is known without DP: it is the mean of ln |det DP|, from flux and divergence (map.h); the last exponent
 *  is that sum minus the others. Section coordinates leave out the direction of the flow and those across the levels, whose
 *  exponents are zero. */
#ifndef JLT_DYNAMICS_LYAPUNOV_H
#define JLT_DYNAMICS_LYAPUNOV_H

#include "dynamics/map_batch.h"
#include "dynamics/saddle.h"

typedef struct {
    size_t returns;
    double t, t_low;  /* [time] of these returns, and the rounding error of t */
    double exponents[JLT_CHART_DIM_MAX]; /* (dim,), per unit of time, largest first in the limit */
    size_t blurred;   /* returns whose DP contracts some direction by more than the tolerance resolves: the exponent of that
                         direction and those after it are NaN from then on */
    jlt_saddle_watch saddle; /* passages by a saddle */
    double sum_check; /* mean divergence along the orbit; it differs from the exponents' sum by log(flux at start/flux at q)/t */
    double q[JLT_CHART_DIM_MAX]; /* (dim,), the last return */
} jlt_lyapunov_state;

/** Called after every return; nonzero ends the run. */
typedef int (*jlt_lyapunov_observer)(void *context, const jlt_lyapunov_state *state);

/** Follow the orbit from q, shape (dim,), for `returns` returns. *out holds the last state, also when an error ends the run.
 *  Errors: those of jlt_map_apply. */
JLT_CHECKED jlt_status jlt_lyapunov_run(jlt_map *map, jlt_lyapunov_state *out, const double *q, size_t returns,
                                        jlt_lyapunov_observer observer, void *context);

/** The same for many orbits side by side, from q, shape (count, dim), orbit i under the flow flow_of[i] of the maps; the first
 *  `skip` returns do not count. Out: out, status, shape (count,), what jlt_lyapunov_run gives for each orbit, by the method of the
 *  maps; they depend neither on the other orbits nor on the number of threads. Orbits under way at an interrupt of the flows get
 *  NO_CONVERGENCE. Errors: NOMEM; ARG, more returns than can be counted; as jlt_map_batch_apply_flows. */
JLT_CHECKED jlt_status jlt_lyapunov_run_each(jlt_map_batch *maps, jlt_lyapunov_state *out, jlt_status *status, const double *q,
                                             const size_t *flow_of, size_t count, size_t skip, size_t returns);

/** Finite-time exponents from q, shape (count, dim): the logarithm of the 2-norm of D(P^returns) per unit of the time that the
 *  returns took. The norm is that of coordinates in units of the problem; another norm changes the exponent by O(1/t). Out:
 *  exponents, shape (count,), NaN where the orbit ends, or where returns contract more than the flow's tolerance resolves; images,
 *  as jlt_map_batch_apply fills them; saddles, shape (count,). Errors: NOMEM; as jlt_map_batch_apply. */
JLT_CHECKED jlt_status jlt_lyapunov_finite_each(jlt_map_batch *maps, double *exponents, const jlt_map_images *images,
                                                jlt_saddle_watch *saddles, const double *q, size_t count, size_t returns);

#endif
