/** Reads and makes the input of a certificate about a homoclinic orbit, in addition to given.h, whose only leg is the saddle:
 *
 *      "homoclinic": {
 *        "frame": [[NUMBER, NUMBER], [NUMBER, NUMBER]],        its columns are directions, in the coordinates
 *        "reach": NUMBER, "slope": NUMBER,                     see homoclinic.h
 *        "landing": 1 or -1,                                   direction in which the last leg crosses the section
 *        "reversor": [NAME, ...],                              the states that it flips; absent: the first proved reversor
 *        "legs": [as in given.h, without turns] } */
#ifndef JLT_VALIDATED_GIVEN_HOMOCLINIC_H
#define JLT_VALIDATED_GIVEN_HOMOCLINIC_H

#include "validated/given.h"
#include "validated/homoclinic.h"

typedef struct {
    jlt_homoclinic_question question; /* points into this object and into the jlt_given, which must not be moved */
    jlt_given_legs legs;
    arb_t reach, slope;
    arb_ptr frame;
} jlt_given_homoclinic;

/** Read the input, after `of` with its leg. In any case the caller must call jlt_given_homoclinic_clear. Returns false if the JSON
 *  is not of this form, and describes why in problem. */
bool jlt_given_homoclinic_read(jlt_given_homoclinic *self, const jlt_given *of, const json_t *given,
                               char problem[JLT_GIVEN_PROBLEM_MAX]);
void jlt_given_homoclinic_clear(jlt_given_homoclinic *self);

/** Make "homoclinic" of `given` with this proved reversor from guesses: x, shape (legs, states), points on the section from one
 *  near the saddle to the last before the symmetric point; T, shape (legs,), times from each to the next; landing, as above.
 *  Errors: as jlt_homoclinic_make; ARG, more than JLT_CYCLE_LEGS_MAX legs, or the saddle has more than one. */
JLT_CHECKED jlt_status jlt_given_homoclinic_make(const jlt_given *of, json_t *given, const jlt_reversor *reversor, unsigned legs,
                                                 const double *x, const double *T, int landing);

#endif
