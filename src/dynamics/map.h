/** The return map P of a section and its derivative DP, by the variational equations of the generated Jacobian.
 *
 *  With Y the derivative of the flow applied to the tangent vectors dx/dq of the start, and f the field at the return,
 *
 *      DP = dq/dx (I - f e_c^T / f_c) Y,
 *
 *  c the section's column: the middle factor is the variation of the return time, and e_c^T x = level on the section.
 *
 *  The exact identity that checks it: with F the density of flux in section coordinates (see jlt_chart),
 *
 *      det DP = F(start)/F(end) * exp(integral of the divergence on the levels),
 *
 *  the integral being one more component of the same integration. */
#ifndef JLT_DYNAMICS_MAP_H
#define JLT_DYNAMICS_MAP_H

#include "dynamics/section.h"
#include "dynamics/section_conditions.h"

typedef struct {
    double q[JLT_CHART_DIM_MAX]; /* (dim,), the last return in coordinates of the section */
    double slope[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX]; /* DP, (dim, dim), dq_i/dq_j(start) in row i; of P^count by the chain
                                                            rule */
    double T;                /* [time] that all returns took, negative backwards */
    double determinant;      /* of slope: product over the returns */
    double flux_determinant; /* |det DP| by flux and divergence, accurate also where DP itself has lost it to rounding */
    double expansion;        /* integral of the divergence on the levels, over all returns */
    double defect;           /* of the identity, relative to the product of DP's row lengths (its rounding errors are
                                relative to that); of the return where it is largest relative to `bound` */
    double bound;            /* bound on `defect`: the defect caused by an error of one tolerance per step, to first order */
    double x[JLT_CHART_STATES_MAX]; /* (chart->states,), the state at q */
} jlt_image;

typedef struct jlt_map jlt_map;

/** Create the map of a flow, which is copied; what it points to must live as long. A flow without a method gets the default, gauss,
 *  which evaluates the nodes of a step on vectors. Derivatives also use gauss when the flow's method needs a jet, since the
 *  variational equations have none.
 *  Errors: as jlt_section_create; UNSUPPORTED, the field has no Jacobian. */
JLT_CHECKED jlt_status jlt_map_create(jlt_map **out, const jlt_flow *flow);
void jlt_map_destroy(jlt_map *self); /* NULL is legal */
JLT_OWNED_TYPE(jlt_map)

/* The map's copy of the flow, borrowed. */
const jlt_flow *jlt_map_flow(const jlt_map *self);

/** Watch the conditions of the model, of all returns that jlt_map_apply makes from now on; NULL, as at first: none. */
void jlt_map_watch(jlt_map *self, const jlt_observed *observed);

/* The least values of these conditions since jlt_map_watch. */
jlt_section_least jlt_map_least(const jlt_map *self);

/** P^count(q), shape (dim,), count >= 1 returns forwards (time_direction +1) or backwards (-1), with its derivative. Every
 *  return starts from the chart's point, exactly on the levels.
 *  A return on which tangent vectors grow far above their size at its end is followed twice (passage.h).
 *  The variational equations are neither projected (flow.kept) nor ended by conditions of the model (flow.end_where_invalid).
 *  Errors: ARG, count is 0; EMPTY, no state of the section has these coordinates; DOMAIN, q is no start, or the orbit ended: at
 *  a pole, at rest, or at the edge of its table's domain; BUDGET, a return took more than flow.max_steps or flow.t_max; NONFINITE,
 *  NO_PROGRESS; NO_CONVERGENCE, interrupted, or returned on another branch of a chart that solves for states. *out is then not
 *  touched. */
JLT_CHECKED jlt_status jlt_map_apply(jlt_map *self, jlt_image *out, const double *q, size_t count, int time_direction);

/** P^count(q) without the derivative, five times cheaper, as a jlt_section follows the orbit: fills q, T and x; slope, determinant,
 *  flux_determinant, expansion, defect and bound are NaN. Errors: as jlt_map_apply, but a return on another branch is not one;
 *  DOMAIN also where a condition of the model breaks and flow.end_where_invalid is set. */
JLT_CHECKED jlt_status jlt_map_point(jlt_map *self, jlt_image *out, const double *q, size_t count, int time_direction);

/** Follow a varied state (map_return.h) to the section, forwards or backwards. In/out: varied, shape (states*(1 + dim) + 1,). Out:
 *  *t, the time that this took, in the flow's unit. Errors: as jlt_map_apply. */
JLT_CHECKED jlt_status jlt_map_resume(jlt_map *self, double *varied, double *t, int time_direction);

#endif
