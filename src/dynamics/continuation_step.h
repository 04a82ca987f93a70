/** Internals of the continuation of periodic orbits: the equation, one step along a branch, and the measurement of a point. */
#ifndef JLT_DYNAMICS_CONTINUATION_STEP_H
#define JLT_DYNAMICS_CONTINUATION_STEP_H

#include "dynamics/continuation.h"

enum { JLT_CONTINUATION_U = JLT_CHART_DIM_MAX + 1, JLT_CONTINUATION_TESTS = 4 };

/* One run's constants. */
typedef struct {
    const jlt_family *family;
    jlt_continuation_options options;
    size_t period;
    unsigned d;
    double tolerance; /* of the start's flow */
    double length;    /* of the start; where u is longer, steps may be longer by as much */
    jlt_chart chart; /* a copy of the start's: it says how u is scaled */
    bool held[JLT_CHART_DIM_MAX]; /* coordinates that the reversor fixes along a branch of symmetric orbits: Newton keeps them */
} jlt_continuation_runner;

/* F(u) = P^period(q) - q with its Jacobian (d, d + 1), where u is q, scaled, and the value over options.scale. */
typedef struct {
    double f[JLT_CHART_DIM_MAX], jacobian[JLT_CHART_DIM_MAX * JLT_CONTINUATION_U], slope[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX];
    double scale, /* max(1, largest |entry| of DP^period) */
        noise,    /* bound on the error of F, relative to scale; grows with the length of u over that of the start */
        T;        /* [time] of P^period */
} jlt_continuation_equation;

/* A point of the branch in working form; test: the test functions, in the order of jlt_bifurcation from FOLD, NaN where one
 * does not apply. */
typedef struct {
    double u[JLT_CONTINUATION_U], tangent[JLT_CONTINUATION_U], test[JLT_CONTINUATION_TESTS], arc;
    jlt_continuation_equation at;
    bool symmetric;
} jlt_continuation_place;

/* The options, with defaults in place of zeros. */
jlt_continuation_options jlt_continuation_step_defaults(const jlt_continuation_options *asked);

/* Whether a run may have these options, in this direction. */
bool jlt_continuation_step_allows(const jlt_continuation_options *options, int direction);

/* F and its Jacobian at u, shape (d + 1,). Cost: P^period with derivative once, and without it twice. Errors: as map_at, and as
 * jlt_map_apply. */
JLT_CHECKED jlt_status jlt_continuation_step_evaluate(const jlt_continuation_runner *self, jlt_continuation_equation *out,
                                                      const double *u);

/* Whether a place at the value u, in units of the scale, is at an end of the range, to rounding. */
bool jlt_continuation_step_is_at(double u, double limit);

/* The length of the coordinates at u but for angles, at least 1. */
double jlt_continuation_step_length(const jlt_continuation_runner *self, const double *u);

/* Take d, chart and tolerance from the map at a value. Errors: as map_at. */
JLT_CHECKED jlt_status jlt_continuation_step_open(jlt_continuation_runner *self, double value);

/* Set *out to the place where a run begins. For a symmetric orbit whose first point is its own mirror image, set `held` too: no
 * step then leaves the branch for one that breaks the symmetry. */
JLT_CHECKED jlt_status jlt_continuation_step_begin(jlt_continuation_runner *self, jlt_continuation_place *out,
                                                   const jlt_continuation_point *start, int direction);

/* Step from `from` by arclength `step` along its tangent, and correct. Errors: as correct. */
JLT_CHECKED jlt_status jlt_continuation_step_to(const jlt_continuation_runner *self, jlt_continuation_place *out,
                                                const jlt_continuation_place *from, double step, unsigned *iterations);

/* Whether the tangents at the two places differ by at most `angle`, and each from the chord by at most half of it. If not, the step
 * may have jumped over a fold or to another branch. */
bool jlt_continuation_step_straight(const jlt_continuation_place *from, const jlt_continuation_place *to, double angle,
                                    unsigned d);

/* Measure the orbit at u (jlt_periodic_measure), and fill *out. */
JLT_CHECKED jlt_status jlt_continuation_step_measure(const jlt_continuation_runner *self, jlt_continuation_point *out,
                                                     const double *u, const double *tangent, double arc, jlt_bifurcation kind);

#endif
