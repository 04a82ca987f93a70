/** Periodic orbits proved: existence and uniqueness in a box on a section, period, and multipliers on the levels of integrals.
 *
 *  The orbit is cut where it crosses the section, into legs that are enclosed one by one (multiple shooting), so that no error
 *  grows for longer than a leg. Unknowns of a point y are the states but the section's. With P the arrival on the section, F
 *  integrals of the motion, c their levels, y = (q, w) with as many w as there are levels, the equations are P_q(y_i) = q_(i+1),
 *  F(y_i) = c for all legs i, the last of which ends where the first begins; Krawczyk's operator (krawczyk.h) shows that there is
 *  one solution. There F(q_(i+1), P_w(y_i)) = F(y_i) = c = F(y_(i+1)): where dF/dw is regular over the hull of both, P_w(y_i) =
 *  w_(i+1), so that the legs meet.
 *
 *  On the levels dw = -F_w^-1 F_q dq, which gives the derivative D of the map in q, leg by leg. Its determinant is also
 *      det D = exp(integral of div f over the orbit),
 *  for the flux of volume through the section is the same at both ends: div has none of the dependencies of a matrix of intervals,
 *  and is far tighter. Both must overlap.
 *
 *  An orbit of a forced system, or around an angle, closes but for periods of states, by which they have grown at the end of each
 *  leg: where points that differ by them are one to the table, so are they here. What is shown is that one solution is there for
 *  the numbers of periods that are given, of each leg. Orbits with other numbers solve other equations, which may have a solution
 *  in the same boxes.
 *
 *  Parameters that are intervals are states of rate 0: what is shown then holds for each of their values. */
#ifndef JLT_VALIDATED_CYCLE_H
#define JLT_VALIDATED_CYCLE_H

#include "validated/arrival.h"
#include "validated/krawczyk.h"

enum { JLT_CYCLE_STATES_MAX = 32, JLT_CYCLE_LEGS_MAX = 128 };

typedef struct {
    const jlt_descriptor *descriptor; /* general field, in its own time */
    arb_srcptr params;                /* (params,) */
    unsigned free_count, free[JLT_FORMULAS_FREE_MAX]; /* those that have more than one value */
    unsigned column;
    arb_srcptr section;               /* the value that state has */
    int direction;                    /* sign of its rate there */
    unsigned level_count;
    const char *const *levels;        /* (level_count,), integrals */
    arb_srcptr level_values;
    arb_srcptr turns;                 /* (legs, states), multiples of periods that states have grown by at the end of each leg, and
                                         that are taken off there; the levels do not see them. NULL: none */
    unsigned digits;                  /* decimals that count */
} jlt_cycle_question;

typedef enum {
    JLT_CYCLE_PROVED,
    JLT_CYCLE_UNSHOWN,  /* Krawczyk's operator leaves the box: no orbit there, or too little precision */
    JLT_CYCLE_OPEN,     /* the integrals do not tell the states left out apart */
    JLT_CYCLE_STILL,    /* a leg is not shown to take time: it may end where it begins, or before */
    JLT_CYCLE_CONTRADICTED /* the two determinants exclude each other: an error of this program */
} jlt_cycle_verdict;

typedef struct {
    jlt_cycle_verdict verdict;
    unsigned legs, unknowns, multipliers; /* unknowns: states but the section's; multipliers: coordinates on the levels */
    arb_ptr solution;               /* (legs, unknowns): encloses the zero */
    arb_t period, trace, determinant, matrix_determinant; /* determinant: by the divergence */
    acb_struct multiplier[2];       /* where there are one or two, else 0 */
    arf_struct least[JLT_ARRIVAL_VALIDS_MAX]; /* the model's conditions along the orbit, bounds from below */
    bool sink;                      /* proved: all multipliers are inside the unit circle; of three or more by a power of D that
                                       shrinks all vectors */
    bool saddle;                    /* proved: two real ones, one inside, one outside */
} jlt_cycle_result;

typedef struct jlt_cycle jlt_cycle;

/** Out: *cycle, NULL on failure; destroy with jlt_cycle_destroy. The question is borrowed. Errors: ARG, more than
 *  JLT_CYCLE_STATES_MAX states, or no coordinate left by the levels; as jlt_formulas_create, jlt_step_create; NOMEM. */
JLT_CHECKED jlt_status jlt_cycle_create(jlt_cycle **cycle, const jlt_cycle_question *question);
void jlt_cycle_destroy(jlt_cycle *cycle); /* legal on NULL */

/** The states that the levels leave: kept, shape (states - 1 - level_count,), indices of states in their order, chosen so that the
 *  others follow from the integrals best at the point y, shape (states - 1,). Errors: DOMAIN, where the integrals' gradients depend
 *  on each other. */
JLT_CHECKED jlt_status jlt_cycle_choose(jlt_cycle *self, unsigned *kept, arb_srcptr y);

/** Newton's method, at middles: a guess, in which nothing is rigorous, made better. In and out: y, shape (legs, states - 1), and
 *  instants, shape (legs,), exact, when each leg is near the section again. Errors: as jlt_arrival_compute; NO_CONVERGENCE. */
JLT_CHECKED jlt_status jlt_cycle_refine(jlt_cycle *self, arb_ptr y, arb_ptr instants, unsigned legs, const unsigned *kept);

/** How far from y the orbit may lie, to first order, for all values of parameters and levels: |M G(y)| of krawczyk.h. Out: reach,
 *  shape (legs, states - 1), exact. In: y, of the same shape, exact, near the orbit at their middles; instants, kept, as above.
 *  Errors: as jlt_arrival_compute; NO_CONVERGENCE, no inverse. */
JLT_CHECKED jlt_status jlt_cycle_reach(jlt_cycle *self, arb_ptr reach, arb_srcptr y, arb_srcptr instants, unsigned legs,
                                       const unsigned *kept);

void jlt_cycle_result_init(jlt_cycle_result *result, const jlt_cycle *of, unsigned legs); /* ends with jlt_cycle_result_clear */
void jlt_cycle_result_clear(jlt_cycle_result *result);

/** The proof. Out: *result, set up before by jlt_cycle_result_init for so many legs; where the verdict is UNSHOWN, OPEN or STILL
 *  the verdict alone is meaningful. In: box, shape (legs, states - 1); instants, shape (legs,), > 0, exact; kept, as above.
 *  Errors: as jlt_arrival_compute. Cost: a few arrivals of each leg. */
JLT_CHECKED jlt_status jlt_cycle_prove(jlt_cycle *self, jlt_cycle_result *result, arb_srcptr box, arb_srcptr instants,
                                       const unsigned *kept);

#endif
