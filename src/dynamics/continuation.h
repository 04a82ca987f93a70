/** Continuation of a periodic orbit in one parameter or level, by pseudo-arclength, with its bifurcations.
 *
 *  Unknowns are u = (q, value/scale) in P^period(q; value) = q; the next point is sought at a fixed projection on the tangent
 *  (Keller), so that folds are passed. DP comes from the variational equations, dP/dvalue from central differences: it serves to
 *  predict the next point only, and every point found satisfies the equation to rounding. From one step to the next the tangent
 *  turns by at most 0.3 rad, so that no fold is jumped over, and branches of symmetric orbits stay symmetric. The trace of
 *  DP^period differs from its linear extrapolation by at most half of itself, or 1 if that is more, so that no multiplier passes
 *  the unit circle unseen.
 *  Bifurcations are sign changes of test functions, two within a step where parabolas through their values lead to the other sign,
 *  located by the secant method on the arclength, or left in the bracket that was reached where steps cease to converge:
 *      fold                the tangent's component along the parameter
 *      period doubling     det(DP^period + I)
 *      branch point        the determinant of the bordered Jacobian (the orbit loses its symmetry, or meets another family)
 *      torus               det(DP^period) - 1, if |trace| < 2 - 1e-9 at its zero; where the orbit is not symmetric, and d = 2
 *  Source: H. B. Keller (1977); W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, SIAM 2000. */
#ifndef JLT_DYNAMICS_CONTINUATION_H
#define JLT_DYNAMICS_CONTINUATION_H

#include "dynamics/periodic.h"

/** The maps of a family: map_at gives the map for a parameter value; it stays valid until the next call. map_near does the same for
 *  a value that differs from the last one of map_at by less than 1e-5 of the option `scale`; NULL: map_at serves. */
typedef struct {
    jlt_status (*map_at)(void *context, jlt_map **map, double value);
    void *context;
    jlt_status (*map_near)(void *context, jlt_map **map, double value);
} jlt_family;

typedef enum {
    JLT_BIFURCATION_NONE,
    JLT_BIFURCATION_FOLD,
    JLT_BIFURCATION_DOUBLING,
    JLT_BIFURCATION_BRANCH,
    JLT_BIFURCATION_TORUS
} jlt_bifurcation;

const char *jlt_continuation_bifurcation_name(jlt_bifurcation kind);

typedef struct {
    double value;
    double arc; /* arclength along the branch, in u */
    jlt_periodic orbit;
    jlt_bifurcation kind; /* NONE: an ordinary point */
    double low, /* of a bifurcation: the smaller of the values at the nearest points found on both sides of it */
        high;   /* the larger of these */
    double tangent[JLT_CHART_DIM_MAX + 1]; /* unit, in u, in the direction of travel */
} jlt_continuation_point;

typedef struct {
    double scale;              /* of the parameter; default 1 */
    double step,               /* the first step of arclength; default 0.01 */
        step_min,              /* the shortest; default 1e-6 */
        step_max;              /* the longest; default 0.05 */
    double low,                /* the run ends where value falls below this, */
        high;                  /* or rises above this; both 0: there are no ends */
    size_t points_max;         /* default 500 */
    const volatile sig_atomic_t *interrupt;
} jlt_continuation_options;

typedef enum {
    JLT_CONTINUATION_RANGE,  /* value reached an end of [low, high], which is the last point */
    JLT_CONTINUATION_POINTS, /* points_max are found */
    JLT_CONTINUATION_STUCK,  /* no step above step_min converged: a pole, an empty level, tangency with the section */
    JLT_CONTINUATION_INTERRUPT,
    JLT_CONTINUATION_CLOSED, /* back at the orbit it began with */
    JLT_CONTINUATION_HALVED  /* the orbit became one of half its period, at a period doubling, which is the last point */
} jlt_continuation_end;

/** Called for every point and every bifurcation in order; a status other than JLT_OK ends the run with it. */
typedef jlt_status (*jlt_continuation_sink)(void *context, const jlt_continuation_point *point);

/** Follow the orbit from `start` (value and orbit are read; a nonzero tangent gives the direction, otherwise the parameter
 *  first goes up for direction +1 and down for -1). options NULL: all defaults. Errors: ARG, another direction, a negative or NaN
 *  option, a step or scale that is not finite, low above high, or a start outside of them; NOMEM, the sink's, those of map_at and
 *  of the map at the start.
 *  Cost: about 4 evaluations of P^period with derivative a point. */
JLT_CHECKED jlt_status jlt_continuation_run(jlt_continuation_end *end, const jlt_family *family,
                                            const jlt_continuation_point *start, int direction,
                                            const jlt_continuation_options *options, jlt_continuation_sink sink,
                                            void *context);

/** Find the first point of the other branch at a located branch point or period doubling, on the given side (+1, -1) at the
 *  distance `offset` > 0 in u, which is halved, up to eleven times, until Newton's method converges to an orbit between the
 *  options' low and high, at a period doubling one that lies in the direction in which the other branch begins. Its tangent points
 *  away.
 *  Errors: ARG, another kind of point, side or offset, or a section of other than two coordinates; NO_CONVERGENCE; those of the
 *  map. */
JLT_CHECKED jlt_status jlt_continuation_switch(jlt_continuation_point *out, const jlt_family *family,
                                               const jlt_continuation_point *at, int side, double offset,
                                               const jlt_continuation_options *options);

#endif
