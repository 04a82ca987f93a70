/** Transverse homoclinic orbits of a symmetric saddle, proved.
 *
 *  The saddle is a cycle of one leg with coordinates q = (q_1, q_2) on the levels, through q*. A frame of two directions gives
 *  coordinates q = q* + u e_u + s e_s. N is |u| <= reach, |s| <= slope*reach. Where DP over N takes the cone |s| <= slope |u| into
 *  its interior and makes |u| grow, N holds a piece of the unstable manifold that is the graph of a function s = g(u) with
 *  g(0) = 0 and |g'| <= slope: a short piece of the manifold, whose tangent is in the cone as the cone's invariant direction is,
 *  remains a curve through q* with tangents in the cone under P, and grows in u until it leaves N.
 *
 *  Unknowns are points x_0, x_1, ... of the section, x_0 on that graph, each mapped to the next; from the last one the orbit goes
 *  on to a point p with the section's state 0, crossed the other way or the same, where the other state that the reversor flips is
 *  0 as well. So p = Rp lies on the unstable manifold and on the stable one, its image. Krawczyk's operator (krawczyk.h), with g in
 *  slope*u*[-1, 1] and g' in slope*[-1, 1], shows that there is one such orbit, and that all these equations are independent of
 *  each other: the manifold crosses the line of symmetric points. Its tangent at p, with rate 1 of the flipped state, follows from
 *  the same matrix. Where one of its other components is not 0, it differs from its image: the manifolds cross transversally.
 *
 *  Source: S. Smale 1965; J. Moser, Stable and Random Motions, 1973; R. L. Devaney, Trans. AMS 218, 1976. */
#ifndef JLT_VALIDATED_HOMOCLINIC_H
#define JLT_VALIDATED_HOMOCLINIC_H

#include "validated/cycle.h"

typedef struct {
    const jlt_cycle_question *question; /* two coordinates on the levels; no free parameters */
    const signed char *signs;           /* of the reversor, (states,) */
    arb_srcptr saddle_box, saddle_instant; /* as jlt_cycle_prove has them, of one leg */
    const unsigned *kept;               /* (2,) */
    arb_ptr frame;                      /* (2, 2), row by row: its columns are u and s */
    arb_ptr reach, slope;               /* > 0 */
    unsigned legs;                      /* 1 .. JLT_CYCLE_LEGS_MAX */
    int landing;                        /* direction in which the last leg meets the section */
    arb_ptr box, instants;              /* (legs, states - 1); (legs,) */
} jlt_homoclinic_question;

typedef enum {
    JLT_HOMOCLINIC_PROVED,
    JLT_HOMOCLINIC_NO_SADDLE,   /* none is shown to be there */
    JLT_HOMOCLINIC_ASYMMETRIC,  /* it, or the section, is not shown to be its own mirror image under a reversor that flips one of
                                   the two coordinates; or the frame is singular */
    JLT_HOMOCLINIC_NO_CONE,     /* the cone is not mapped into itself, or its directions do not grow */
    JLT_HOMOCLINIC_UNSHOWN,     /* Krawczyk's operator leaves the boxes */
    JLT_HOMOCLINIC_OPEN,        /* the legs need not meet, or the orbit may begin outside N, or at the saddle */
    JLT_HOMOCLINIC_STILL,       /* a leg is not shown to take time */
    JLT_HOMOCLINIC_TANGENT,     /* the manifolds may be tangent */
    JLT_HOMOCLINIC_CONTRADICTED /* an error of this program */
} jlt_homoclinic_verdict;

typedef struct {
    jlt_homoclinic_verdict verdict;
    unsigned legs, unknowns, states;
    jlt_cycle_result saddle;
    arb_ptr solution;  /* (legs, unknowns) */
    arb_t start;       /* u of x_0 */
    arb_ptr point, tangent; /* (states,): p; the manifold's tangent there */
    arf_struct least[JLT_ARRIVAL_VALIDS_MAX]; /* the model's conditions from x_0 to p, bounds from below */
} jlt_homoclinic_result;

void jlt_homoclinic_result_init(jlt_homoclinic_result *result, const jlt_cycle *of, unsigned legs); /* ends with _clear */
void jlt_homoclinic_result_clear(jlt_homoclinic_result *result);

/** The proof. Out: *result, set up before by jlt_homoclinic_result_init for so many legs. In: of, of the same question. Errors: as
 *  jlt_cycle_prove; ARG, other than two coordinates, or free parameters. */
JLT_CHECKED jlt_status jlt_homoclinic_prove(jlt_cycle *of, jlt_homoclinic_result *result, const jlt_homoclinic_question *question);

/** Choose frame, reach, slope, box and instants of `question`, in which nothing is rigorous, so that the proof can succeed. In/out:
 *  box and instants, guesses that are refined by Newton's method; the boxes get radii. In: legs, landing, and all members before
 *  frame. Errors: as jlt_cycle_prove, jlt_cycle_refine; NO_CONVERGENCE: no saddle, no cone, or no such orbit near the guess;
 *  UNSUPPORTED: section, levels or saddle are not shown to be their own mirror images under the reversor. */
JLT_CHECKED jlt_status jlt_homoclinic_make(jlt_cycle *of, jlt_homoclinic_question *question);

#endif
