/** Proofs of periodic orbits: existence and uniqueness in a box on a section, period, and multipliers on the levels of integrals.
 *
 *  The orbit is cut where it crosses the section, into legs that are enclosed one by one (multiple shooting), so that errors grow
 *  over one leg only. The unknowns y of a point on the section are the states without the section's. With P the arrival on the
 *  section, F the integrals, c their levels, and y = (q, w) with as many w as levels, the equations of all legs i are
 *      P_q(y_i) = q_(i+1),      F(y_i) = c,
 *  where the last leg ends at the first point. Krawczyk's operator (krawczyk.h) proves that they have exactly one solution. There
 *  F(q_(i+1), P_w(y_i)) = F(y_i) = c = F(y_(i+1)): if dF/dw is invertible over the hull of both points, then P_w(y_i) =
 *  w_(i+1), so that the legs meet.
 *
 *  On the levels dw = -F_w^-1 F_q dq, which gives the derivative D of the map in q, leg by leg. Its determinant is also
 *      det D = exp(integral of div f over the orbit),
 *  since the flux of volume through the section is the same at both ends. The divergence is free of the dependency problem of
 *  interval matrices, so this enclosure is far tighter. Both must overlap.
 *
 *  An orbit of a forced system, or around an angle, may close only up to periods of states, by which these have grown at the end
 *  of each leg: points that differ by periods are the same point for the table, and are identified here. The proof gives exactly
 *  one solution for the given numbers of periods of each leg. Orbits with other numbers solve other equations, which may have a
 *  solution in the same boxes.
 *
 *  Parameters that are intervals become states of rate 0: the result then holds for each of their values. */
#ifndef JLT_VALIDATED_CYCLE_H
#define JLT_VALIDATED_CYCLE_H

#include "validated/arrival.h"
#include "validated/krawczyk.h"

enum { JLT_CYCLE_STATES_MAX = 32, JLT_CYCLE_LEGS_MAX = 128 };

typedef struct {
    const jlt_descriptor *descriptor; /* a general field in its own time */
    arb_srcptr params;                /* (params,) */
    unsigned free_count, free[JLT_FORMULAS_FREE_MAX]; /* indices of the parameters that are intervals */
    unsigned column;
    arb_srcptr section;               /* the value of state `column` on the section */
    int direction;                    /* sign of that state's rate at crossings */
    unsigned level_count;
    const char *const *levels;        /* (level_count,), names of integrals */
    arb_srcptr level_values;
    arb_srcptr turns;                 /* (legs, states): multiples of periods that states have grown by at the end of each leg,
                                       * where they are subtracted; the levels do not change by them. NULL: none */
    unsigned digits;                  /* decimal digits of accuracy */
    jlt_step_watch *watch;            /* is called after the steps of proofs; NULL: nobody */
} jlt_cycle_question;

typedef enum {
    JLT_CYCLE_PROVED,
    JLT_CYCLE_UNSHOWN,  /* Krawczyk's operator leaves the box: there is no orbit, or too little precision */
    JLT_CYCLE_OPEN,     /* the integrals do not determine the states that are left out */
    JLT_CYCLE_STILL,    /* a leg is not proved to take positive time: it may end where it begins, or before */
    JLT_CYCLE_CONTRADICTED /* the two determinants exclude each other: an error of this program */
} jlt_cycle_verdict;

typedef struct {
    jlt_cycle_verdict verdict;
    unsigned legs, unknowns, multipliers; /* unknowns: number of states minus 1; multipliers: number of coordinates on the levels */
    arb_ptr solution;               /* (legs, unknowns): encloses the zero */
    arb_t period, trace, determinant, matrix_determinant; /* determinant: from the divergence; matrix_determinant: from D */
    acb_struct multiplier[2];       /* both if there are two, the first if there is one, else 0 */
    arf_struct least[JLT_ARRIVAL_VALIDS_MAX]; /* lower bounds of the model's conditions along the orbit */
    bool sink;                      /* all multipliers are proved to lie inside the unit circle */
    bool saddle;                    /* proved: two real multipliers, one inside and one outside the unit circle */
} jlt_cycle_result;

typedef struct jlt_cycle jlt_cycle;

/** Out: *cycle, NULL on failure; destroy it with jlt_cycle_destroy. The question is borrowed. Errors: ARG, more than
 *  JLT_CYCLE_STATES_MAX states, or the levels leave no coordinate; as jlt_formulas_create, jlt_step_create; NOMEM. */
JLT_CHECKED jlt_status jlt_cycle_create(jlt_cycle **cycle, const jlt_cycle_question *question);
void jlt_cycle_destroy(jlt_cycle *cycle); /* legal on NULL */
JLT_OWNED_TYPE(jlt_cycle)

/** Choose coordinates on the levels: kept, shape (states - 1 - level_count,), ascending indices of states, such that the other
 *  states follow best from the integrals near the point y, shape (states - 1,). Errors: DOMAIN, the gradients are dependent. */
JLT_CHECKED jlt_status jlt_cycle_choose(jlt_cycle *self, unsigned *kept, arb_srcptr y);

/** Improve a guess by Newton's method at the midpoints; nothing is rigorous here. In/out: y, shape (legs, states - 1), and
 *  instants, shape (legs,), exact, when each leg is near the section again. Errors: as jlt_arrival_compute; NO_CONVERGENCE. */
JLT_CHECKED jlt_status jlt_cycle_refine(jlt_cycle *self, arb_ptr y, arb_ptr instants, unsigned legs, const unsigned *kept);

/** Estimate, to first order, how far from y the orbits lie for all values of parameters and levels: |M G(y)| of krawczyk.h. Out:
 *  reach, shape (legs, states - 1), exact. In: y, of the same shape, exact, near the orbit for the midpoints of parameters and
 *  levels; instants, kept, as above. Errors: as jlt_arrival_compute; NO_CONVERGENCE, the derivative is not invertible. */
JLT_CHECKED jlt_status jlt_cycle_reach(jlt_cycle *self, arb_ptr reach, arb_srcptr y, arb_srcptr instants, unsigned legs,
                                       const unsigned *kept);

void jlt_cycle_result_init(jlt_cycle_result *result, const jlt_cycle *of, unsigned legs); /* release with jlt_cycle_result_clear */
void jlt_cycle_result_clear(jlt_cycle_result *result);

/** Prove the orbit. Out: *result, initialized by jlt_cycle_result_init for the number of legs; if the verdict is UNSHOWN, OPEN or
 *  STILL, only the verdict is meaningful. In: box, shape (legs, states - 1); instants, shape (legs,), > 0, exact; kept, as above.
 *  Errors: as jlt_arrival_compute. Cost: a few arrivals of each leg. */
JLT_CHECKED jlt_status jlt_cycle_prove(jlt_cycle *self, jlt_cycle_result *result, arb_srcptr box, arb_srcptr instants,
                                       const unsigned *kept);

#endif
