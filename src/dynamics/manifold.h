/** Grows a branch of a manifold as a polygon; arc length and curvature set the spacing.
 *
 *  Every point is computed from the seed itself (jlt_branch), so nothing is interpolated and errors do not pile up. The branch
 *  grows by fundamental domains. Between points further apart than `finest` one is added halfway in sigma, in all places at once,
 *  until their distance is under `spacing` and the polygon turns there by less than `turn`.
 *  Source: D. Hobson, J. Comput. Phys. 104 (1993); B. Krauskopf, H. Osinga, J. Comput. Phys. 146 (1998), the criteria. */
#ifndef JLT_DYNAMICS_MANIFOLD_H
#define JLT_DYNAMICS_MANIFOLD_H

#include "dynamics/branch.h"

#define JLT_MANIFOLD_FINEST 1e-4 /* distance of neighbouring points (jlt_chart_distance) */

enum { JLT_MANIFOLD_RETURNS_A_POINT = 100 }; /* on average, at most; where multipliers are about 1.5, points take some ten */

typedef enum {
    JLT_MANIFOLD_LENGTH, /* the length asked for is reached */
    JLT_MANIFOLD_POINTS, /* points_max is reached */
    JLT_MANIFOLD_RETURNS, /* JLT_MANIFOLD_RETURNS_A_POINT*points_max returns were made, as where multipliers are near the unit
                             circle */
    JLT_MANIFOLD_BLURRED, /* points whose sigma differs by less than 1e-9 lie apart: errors have grown to what the spacing is, as
                             where the branch follows that of another saddle */
    JLT_MANIFOLD_SETTLED, /* a stretch of whole fundamental domains is at most ten tolerances long, and a thousandth of the longest:
                             the branch leads to a periodic orbit, and errors hide the rest */
    JLT_MANIFOLD_POLE,   /* the branch runs into orbits that end, do not return, or grow without bound in finite time (DOMAIN,
                            EMPTY, BUDGET, NO_PROGRESS, NONFINITE of jlt_branch_point) */
    JLT_MANIFOLD_INTERRUPT
} jlt_manifold_end;

typedef struct {
    double spacing;    /* in scaled coordinates (jlt_chart_distance), as all lengths here; default 0.01 */
    double turn;       /* in radians, default 0.2 */
    double finest;     /* default JLT_MANIFOLD_FINEST; below spacing */
    double length_max; /* of arc; default 5 */
    size_t points_max; /* default 20000 */
} jlt_manifold_options;

/** A polygon, which owns its arrays: two coordinates, sigma and arc length of each point. All zero, it is empty. */
typedef struct {
    double *points; /* shape (count, 2) */
    double *sigma;  /* shape (count,), increasing */
    double *length; /* shape (count,), from the first point */
    size_t count;
    jlt_manifold_end end;
} jlt_manifold;

void jlt_manifold_clear(jlt_manifold *self); /* frees; legal on a zeroed polygon */

/** Grow polygons along branches, side by side; out, shape (count,), and branches as jlt_branch_curve takes them. A polygon does not
 *  depend on the other branches. options NULL: all defaults; a member that is 0: its default. Errors, with out untouched: ARG,
 *  spacing is not above finest, or another option; NOMEM; as jlt_branch_point but for what ends a branch. */
JLT_CHECKED jlt_status jlt_manifold_grow(jlt_manifold *out, const jlt_branch *const *branches, size_t count,
                                         const jlt_manifold_options *options);

/** The mirror image of a curve: of an unstable branch of a saddle that is its own mirror image, this is a stable one, at the
 *  same parameters. out must be empty. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_manifold_reflect(jlt_manifold *out, const jlt_manifold *curve, const jlt_chart *chart);

#endif
