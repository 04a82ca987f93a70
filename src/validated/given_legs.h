/** Reads and writes the legs of an orbit in certificates: see given.h. */
#ifndef JLT_VALIDATED_GIVEN_LEGS_H
#define JLT_VALIDATED_GIVEN_LEGS_H

#include "validated/cycle.h"
#include "validated/refuse.h"

#include <jansson.h>

typedef struct {
    unsigned count;        /* 0 before legs are read or made */
    arb_ptr box, instants; /* (count, states - 1); (count,), exact */
    int *turns;            /* (count, states): number of periods that states have grown by at the end of each leg; NULL: none */
    arb_ptr grown;         /* (count, states): the corresponding growth of states; NULL: none */
} jlt_given_legs;

/** Read legs from an array. In any case the caller must call jlt_given_legs_clear. Returns false if it is not of this form, and
 *  describes why in problem. */
bool jlt_given_legs_read(jlt_given_legs *self, const jlt_cycle_question *question, const json_t *legs,
                         char problem[JLT_GIVEN_PROBLEM_MAX]);
void jlt_given_legs_clear(jlt_given_legs *self, const jlt_cycle_question *question);

/** Set boxes of radius 0 and instants from points on the section, x (count, states), and times, T (count,); clear afterwards. */
void jlt_given_legs_guess(jlt_given_legs *self, const jlt_cycle_question *question, unsigned count, const double *x,
                          const double *T);

/** Write legs as in given.h; a new reference. radii: of all boxes, by state; NULL: their own. Radii have three
 *  digits, their own rounded up. */
json_t *jlt_given_legs_write(const jlt_given_legs *self, const jlt_cycle_question *question, const double *radii);

/** Whether points y, shape (legs, states - 1), certainly lie in the boxes of an array of legs, exactly as these are written. */
bool jlt_given_legs_hold(const json_t *legs, const jlt_cycle_question *question, arb_srcptr y);

/** The midpoint of a number as a decimal; a new reference. */
json_t *jlt_given_legs_decimal(const arb_t value, unsigned digits);

#endif
