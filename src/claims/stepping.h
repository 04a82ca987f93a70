/** Compares the kernels by which integrators follow orbits with enclosures of what they compute. */
#ifndef JLT_CLAIMS_STEPPING_H
#define JLT_CLAIMS_STEPPING_H

#include "claims/sample.h"

/** Compare, in each time of the variant's field with all its states: the field, its jet of order 1, and a Runge-Kutta stage on
 *  vectors, where the step is 0, so that the stage is the field; in the table's own time, also a stage of the variational
 *  equations, which is the Jacobian's columns and its trace. In: own, the field of the variant in the table's own time; s, a sample
 *  of the domain with its enclosures. A field whose numbers are out of range at the sample is left out. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_stepping_compare(jlt_verify_family *f, const jlt_sample *s, jlt_oracle *oracle,
                                            const jlt_descriptor *own);

#endif
