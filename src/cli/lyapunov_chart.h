/** What `jellett lyapunov` is asked for, and its chart of finite-time exponents over a section. */
#ifndef JLT_CLI_LYAPUNOV_CHART_H
#define JLT_CLI_LYAPUNOV_CHART_H

#include "cli/motion_map.h"
#include "dynamics/map_batch.h"

typedef struct {
    jlt_motion_options motion;
    size_t returns, skip, threads;
} jlt_lyapunov_chart_options;

/** Follow q, shape (dim,), for `skip` returns, to the point that exponents are measured from. Errors: as jlt_map_point, and
 *  NO_CONVERGENCE, that point is on another branch of a chart that solves for states. */
JLT_CHECKED jlt_status jlt_lyapunov_chart_skip(jlt_map *map, double *q, size_t skip);

/** The maps of many starts: in lanes, unless a method was asked for; sets the options' threads where none were. Errors: as
 *  jlt_map_batch_create. */
JLT_CHECKED jlt_status jlt_lyapunov_chart_maps(jlt_map_batch **out, jlt_lyapunov_chart_options *o, const jlt_system *system,
                                               bool has_method);

/** The rows of a grid of starts; and the picture. Say what is wrong. */
jlt_exit jlt_lyapunov_chart_write(jlt_motion_map *picture, jlt_map *map, jlt_map_batch *maps, jlt_lyapunov_chart_options *o,
                                  const jlt_grid_axis *axes);
jlt_exit jlt_lyapunov_chart_draw(const jlt_lyapunov_chart_options *o, const jlt_system *system, jlt_motion_map *map);

#endif
