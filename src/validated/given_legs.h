/** Legs of an orbit as certificates have them: see given.h. */
#ifndef JLT_VALIDATED_GIVEN_LEGS_H
#define JLT_VALIDATED_GIVEN_LEGS_H

#include "validated/cycle.h"
#include "validated/refuse.h"

#include <jansson.h>

typedef struct {
    unsigned count;        /* 0 before they are read or made */
    arb_ptr box, instants; /* (count, states - 1); (count,), exact */
    int *turns;            /* periods that states have grown by where each leg ends, (count, states); NULL: none */
    arb_ptr grown;         /* what they have grown by, of the same shape, or NULL */
} jlt_given_legs;

/** Read them from an array. Ends with jlt_given_legs_clear in any case. False: it is not of this form; problem says why. */
bool jlt_given_legs_read(jlt_given_legs *self, const jlt_cycle_question *question, const json_t *legs,
                         char problem[JLT_GIVEN_PROBLEM_MAX]);
void jlt_given_legs_clear(jlt_given_legs *self, const jlt_cycle_question *question);

/** Set up boxes of radius 0 and instants from points of the section, x, shape (count, states), and times, T, shape (count,). Ends
 *  with jlt_given_legs_clear. */
void jlt_given_legs_guess(jlt_given_legs *self, const jlt_cycle_question *question, unsigned count, const double *x,
                          const double *T);

/** Legs as in given.h; a new reference. radius: of all boxes, as text; NULL: their own, of three digits and no less. */
json_t *jlt_given_legs_write(const jlt_given_legs *self, const jlt_cycle_question *question, const char *radius);

/** Whether points, shape (legs, states - 1), surely lie in the boxes of an array of legs, each as it is written, unrounded. */
bool jlt_given_legs_hold(const json_t *legs, const jlt_cycle_question *question, arb_srcptr y);

/** A number's middle as a decimal; a new reference. */
json_t *jlt_given_legs_decimal(const arb_t value, unsigned digits);

#endif
