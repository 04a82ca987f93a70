/** The options of `jellett lyapunov`, and its chart of finite-time Lyapunov exponents over a section. */
#ifndef JLT_CLI_LYAPUNOV_CHART_H
#define JLT_CLI_LYAPUNOV_CHART_H

#include "cli/motion_map.h"
#include "dynamics/map_batch.h"

typedef struct {
    jlt_motion_options motion;
    size_t returns, skip, threads;
    size_t others; /* starts without an exponent that did not end; set by jlt_lyapunov_chart_write */
} jlt_lyapunov_chart_options;

/** Move q, shape (dim,), forward by `skip` returns, to the point from which exponents are measured. Errors: as jlt_map_point;
 *  NO_CONVERGENCE also if that point is on another branch of a chart that solves for states. */
JLT_CHECKED jlt_status jlt_lyapunov_chart_skip(jlt_map *map, double *q, size_t skip);

/** Create the batch of maps for many starts, in lanes unless --method was given (has_method). Sets o->threads if it is 0, and
 *  o->motion.in_lanes. Errors: as jlt_map_batch_create. */
JLT_CHECKED jlt_status jlt_lyapunov_chart_maps(jlt_map_batch **out, jlt_lyapunov_chart_options *o, const jlt_system *system,
                                               bool has_method);

/** Write the rows of a grid of starts; draw the picture. Say what is wrong. */
jlt_exit jlt_lyapunov_chart_write(jlt_motion_map *picture, jlt_map *map, jlt_map_batch *maps, jlt_lyapunov_chart_options *o,
                                  const jlt_grid_axis *axes);
jlt_exit jlt_lyapunov_chart_draw(const jlt_lyapunov_chart_options *o, const jlt_system *system, jlt_motion_map *map);

#endif
