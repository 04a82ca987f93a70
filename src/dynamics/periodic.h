/** Periodic points of a return map, by Newton's method on all points of the orbit at once (multiple shooting), so that the
 *  residual reaches the rounding level also on strongly unstable orbits. */
#ifndef JLT_DYNAMICS_PERIODIC_H
#define JLT_DYNAMICS_PERIODIC_H

#include "dynamics/map.h"

enum { JLT_PERIODIC_MAX = 64 };

typedef enum {
    JLT_ORBIT_CENTRE,      /* complex multipliers, all of modulus 1 */
    JLT_ORBIT_SADDLE,      /* none of the others; of two multipliers |mu2| < 1 < mu1 */
    JLT_ORBIT_FLIP_SADDLE, /* the same, with mu1 real and < 0 */
    JLT_ORBIT_ATTRACTING,  /* all inside the unit circle */
    JLT_ORBIT_REPELLING,   /* all outside */
    JLT_ORBIT_DEGENERATE   /* a multiplier +-1 within 1e-7, or a double one within the square root of the error of DP, or, where it
                              is 1, of 1e-9; or none is known, nor that all are small */
} jlt_orbit_type;

const char *jlt_periodic_type_name(jlt_orbit_type type);

/** A periodic orbit: plain data, some 67 kB a record. Distances are lengths in scaled coordinates, as of jlt_chart_distance. */
typedef struct {
    size_t period;                                       /* primitive, <= JLT_PERIODIC_MAX */
    double points[(size_t)JLT_PERIODIC_MAX * JLT_CHART_DIM_MAX]; /* (period, dim), in the order of the map */
    double T;                                            /* [time] of the whole orbit */
    double slope[4];         /* D(P^period) at the first point, row-major; on sections of two coordinates alone, else unset */
    double trace;            /* of D(P^period), on any section; of two complex multipliers it is their sum; NaN if none is known */
    double determinant;      /* of D(P^period): exp of the integral of the divergence, for the flux is the same at both ends */
    double determinant_slope; /* the same a second way: the product of det DP over the returns */
    double re[JLT_CHART_DIM_MAX], im[JLT_CHART_DIM_MAX]; /* (dim,): multipliers, largest first; NaN: not known, see trace */
    double residual;         /* largest distance of P(q_i) from q_(i+1) */
    double defect;           /* worst defect of the flux identity, see map.h */
    bool symmetric;          /* its own mirror image under the chart's reversor, within the distance 1e-7 */
    jlt_orbit_type type;
} jlt_periodic;

/** Find an orbit of `period` returns by Newton's method from q, shape (dim,). held: shape (dim,), 1 for each coordinate that
 *  must keep its value, which picks one orbit of a family; or NULL. The equations are solved in the sense of least squares.
 *  Out: *out, with its primitive period, which may divide `period`; untouched on failure. Errors: NO_CONVERGENCE, the residual does
 *  not fall to 1e-10 of the largest |DP|, at most 1e-9, or what is found is no orbit (jlt_periodic_moves); those of jlt_map_apply
 *  at q; ARG, period outside 1 .. JLT_PERIODIC_MAX, or all coordinates are held; NOMEM. */
JLT_CHECKED jlt_status jlt_periodic_find(jlt_map *map, jlt_periodic *out, const double *q, size_t period,
                                         const unsigned char *held);

/** The same from points, shape (period, dim), near all of the orbit's. Errors: as jlt_periodic_find. */
JLT_CHECKED jlt_status jlt_periodic_polish(jlt_map *map, jlt_periodic *out, const double *points, size_t period,
                                           const unsigned char *held);

/** Fill everything else from period and points, which are not improved. Errors: ARG, the period; NOMEM; those of jlt_map_apply and
 *  jlt_linear_eigenvalues. */
JLT_CHECKED jlt_status jlt_periodic_measure(jlt_map *map, jlt_periodic *io);

/** Make point `first` the first one, and measure again. Errors: ARG, there is no such point; as jlt_periodic_measure. */
JLT_CHECKED jlt_status jlt_periodic_rotate(jlt_map *map, jlt_periodic *io, size_t first);

/** The least number of returns after which points, shape (period, dim), repeat. */
size_t jlt_periodic_primitive(const jlt_chart *chart, const double *points, size_t period);

/** The part of an orbit's velocity at q, shape (dim,), that crosses the section. 0 if q has no state, or if the part is so small
 *  that the orbit may lie in the section. */
double jlt_periodic_crossing(const jlt_flow *flow, const double *q);

/** The way |f| T that a motion from q, shape (dim,), goes in a time T [time] at its velocity there, in scaled coordinates; 0 where
 *  jlt_periodic_crossing is 0. */
double jlt_periodic_way(const jlt_flow *flow, const double *q, double T);

/** Whether period, points and T describe a true orbit. False if it lies in the section, which it then leaves and meets again by
 *  rounding alone; or if |f| T is negligible: where the flow is tangent to the section an orbit returns at once, and every such
 *  point looks fixed; or if a point has no state. */
bool jlt_periodic_moves(const jlt_flow *flow, const jlt_periodic *orbit);

/** Make the mirror image, which runs through the mirrored points backwards, from the image of the first. Only its period and points
 *  are valid; jlt_periodic_measure sets the rest. */
void jlt_periodic_mirror(const jlt_chart *chart, jlt_periodic *out, const jlt_periodic *orbit);

/** Whether two orbits are the same: equal period, and the first point of b within `distance` of a point of a. */
bool jlt_periodic_same(const jlt_chart *chart, const jlt_periodic *a, const jlt_periodic *b, double distance);

#endif
