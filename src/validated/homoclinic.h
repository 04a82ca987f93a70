/** Proofs of transverse homoclinic orbits of a symmetric saddle.
 *
 *  The saddle is a cycle of one leg with coordinates q = (q_1, q_2) on the levels, through q*. A frame of two directions gives
 *  coordinates (u, s) by q = q* + u e_u + s e_s. N is the set |u| <= reach, |s| <= slope*reach. If DP over N maps the cone |s| <=
 *  slope |u| into its interior and expands |u|, then N contains a piece of the unstable manifold that is the graph of a function s
 *  = g(u) with g(0) = 0 and |g'| <= slope: the tangent of a short piece of the manifold lies in the cone, as the cone's invariant
 *  direction does; its images under P remain curves through q* with tangents in the cone, and grow in u until they leave N.
 *
 *  The unknowns are points x_0, x_1, ... of the section, x_0 on that graph, each mapped to the next. From the last one the orbit
 *  goes on to a point p where it meets the section, whose state is 0 there, in either direction, and where the other state that
 *  the reversor R flips is 0 as well. So p = Rp lies on the unstable manifold and on its image, the stable one. Krawczyk's
 *  operator (krawczyk.h), with g in slope*u*[-1, 1] and g' in slope*[-1, 1], proves that there is exactly one such orbit, and that
 *  the equations are independent: the manifold crosses the set of symmetric points. The same matrix gives the manifold's tangent
 *  at p, with rate 1 of the flipped state. If another of its components is not 0, the tangent differs from its image under R: the
 *  manifolds cross transversally.
 *
 *  Source: S. Smale 1965; J. Moser, Stable and Random Motions, 1973; R. L. Devaney, Trans. AMS 218, 1976. */
#ifndef JLT_VALIDATED_HOMOCLINIC_H
#define JLT_VALIDATED_HOMOCLINIC_H

#include "validated/cycle.h"

typedef struct {
    const jlt_cycle_question *question; /* with two coordinates on the levels and no free parameters */
    const signed char *signs;           /* signs of the reversor, (states,) */
    arb_srcptr saddle_box, saddle_instant; /* as for jlt_cycle_prove with one leg */
    const unsigned *kept;               /* (2,) */
    arb_ptr frame;                      /* (2, 2), row-major: its columns are e_u and e_s */
    arb_ptr reach, slope;               /* > 0 */
    unsigned legs;                      /* 1 .. JLT_CYCLE_LEGS_MAX */
    int landing;                        /* direction in which the last leg crosses the section */
    arb_ptr box, instants;              /* (legs, states - 1); (legs,) */
} jlt_homoclinic_question;

typedef enum {
    JLT_HOMOCLINIC_PROVED,
    JLT_HOMOCLINIC_NO_SADDLE,   /* no saddle is proved to be there */
    JLT_HOMOCLINIC_ASYMMETRIC,  /* saddle or section are not proved to be their own mirror images under a reversor that flips one
                                 * of the two coordinates; or the frame is singular */
    JLT_HOMOCLINIC_NO_CONE,     /* the cone is not mapped into its interior, or its directions do not grow */
    JLT_HOMOCLINIC_UNSHOWN,     /* Krawczyk's operator leaves the boxes */
    JLT_HOMOCLINIC_OPEN,        /* the legs may not meet, or the orbit may begin outside N or at the saddle */
    JLT_HOMOCLINIC_STILL,       /* a leg is not proved to take positive time */
    JLT_HOMOCLINIC_TANGENT,     /* the manifolds may be tangent */
    JLT_HOMOCLINIC_CONTRADICTED /* enclosures of the same orbit are disjoint: an error of this program */
} jlt_homoclinic_verdict;

typedef struct {
    jlt_homoclinic_verdict verdict;
    unsigned legs, unknowns, states;
    jlt_cycle_result saddle;
    arb_ptr solution;  /* (legs, unknowns) */
    arb_t start;       /* u of x_0 */
    arb_ptr point, tangent; /* (states,): p; the manifold's tangent there */
    arf_struct least[JLT_ARRIVAL_VALIDS_MAX]; /* lower bounds of the model's conditions from x_0 to p */
} jlt_homoclinic_result;

void jlt_homoclinic_result_init(jlt_homoclinic_result *result, const jlt_cycle *of, unsigned legs); /* release with _clear */
void jlt_homoclinic_result_clear(jlt_homoclinic_result *result);

/** Prove the orbit. Out: *result, initialized by jlt_homoclinic_result_init for the number of legs. In: of, created from the same
 *  cycle question. Errors: as jlt_cycle_prove; ARG, not two coordinates, or free parameters. */
JLT_CHECKED jlt_status jlt_homoclinic_prove(jlt_cycle *of, jlt_homoclinic_result *result, const jlt_homoclinic_question *question);

/** Choose frame, reach, slope, box and instants of `question` so that the proof can succeed; nothing is rigorous here. In/out: box
 *  and instants, guesses that are refined by Newton's method; the boxes get radii. In: legs, landing, and all members before
 *  frame. Errors: as jlt_cycle_prove, jlt_cycle_refine; NO_CONVERGENCE: no saddle, no cone, or no such orbit near the guess;
 *  UNSUPPORTED: section, levels or saddle are not proved to be their own mirror images under the reversor. */
JLT_CHECKED jlt_status jlt_homoclinic_make(jlt_cycle *of, jlt_homoclinic_question *question);

#endif
