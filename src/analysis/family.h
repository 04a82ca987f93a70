/** Families of equilibria that a table claims: the one on which a state lies, and states that follow from one. */
#ifndef JLT_ANALYSIS_FAMILY_H
#define JLT_ANALYSIS_FAMILY_H

#include <stdbool.h>

#include "kernel_abi.h"

/** Fill point, shape (state_count,), with the point of a family that has the free states of x, shape (state_count,).
 *  Returns false if there is none, or the parameters do not satisfy the family's condition. */
bool jlt_family_point(double *point, const jlt_equilibria *family, const jlt_descriptor *general, const double *params,
                      const double *x);

/** The family on which x lies, up to periods of its states that are proved; of several, the one with the most formulas; NULL if
 *  there is none. */
const jlt_equilibria *jlt_family_of(const jlt_descriptor *general, const double *params, const double *x);

/** Set out, shape (state_count,), to x less the whole periods by which x differs from the family on which it lies. */
void jlt_family_turn_back(double *out, const jlt_equilibria *family, const jlt_descriptor *general, const double *params,
                          const double *x);

/** The first family of which the table's claim is refuted; NULL if there is none. */
const jlt_equilibria *jlt_family_refuted(const jlt_descriptor *general);

/** Fill the states that were not given from a family of equilibria: one that the given states fit; of several, the first of those
 *  that fix the fewest of these, so that a sweep stays on a family; if they fit none, the first whose condition the parameters
 *  satisfy. If there is none, fill them with zeros. No refuted family is taken.
 *  In/out: x, shape (state_count,). In: given, shape (state_count,), 1 where x is kept; general, a general field. */
void jlt_family_complete(double *x, const unsigned char *given, const jlt_descriptor *general, const double *params);

#endif
