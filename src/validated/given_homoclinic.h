/** What a certificate about a homoclinic orbit starts from, besides what given.h has of its saddle, which is the only leg there:
 *
 *      "homoclinic": {
 *        "frame": [[NUMBER, NUMBER], [NUMBER, NUMBER]],        its columns are directions, in the coordinates
 *        "reach": NUMBER, "slope": NUMBER,                     see homoclinic.h
 *        "landing": 1 or -1,                                   direction in which the last leg meets the section
 *        "reversor": [NAME, ...],                              the states that it flips; absent: the table's first one is meant
 *        "legs": [as in given.h, without turns] } */
#ifndef JLT_VALIDATED_GIVEN_HOMOCLINIC_H
#define JLT_VALIDATED_GIVEN_HOMOCLINIC_H

#include "validated/given.h"
#include "validated/homoclinic.h"

typedef struct {
    jlt_homoclinic_question question; /* points into this object and into the given one, which must not move */
    jlt_given_legs legs;
    arb_t reach, slope;
    arb_ptr frame;
} jlt_given_homoclinic;

/** Read it, where `of` is read already, with its leg. Ends with jlt_given_homoclinic_clear in any case. False: it is not of this
 *  form; problem says why. */
bool jlt_given_homoclinic_read(jlt_given_homoclinic *self, const jlt_given *of, const json_t *given,
                               char problem[JLT_GIVEN_PROBLEM_MAX]);
void jlt_given_homoclinic_clear(jlt_given_homoclinic *self);

/** Make it, and set "homoclinic" of `given`, by this proved reversor, from guesses: x, shape (legs, states), points of the section
 *  from one near the saddle to the last before the symmetric point, and T, shape (legs,), times from each to the next; landing, as
 *  above. Errors: as jlt_homoclinic_make; ARG, more than JLT_CYCLE_LEGS_MAX legs, or the saddle has more than one. */
JLT_CHECKED jlt_status jlt_given_homoclinic_make(const jlt_given *of, json_t *given, const jlt_reversor *reversor, unsigned legs,
                                                 const double *x, const double *T, int landing);

#endif
