/** Proofs that polynomial conditions have no point, by identities that eliminate variables, without a solver. */
#ifndef TTC_ELIMINATION_H
#define TTC_ELIMINATION_H

#include "algebra/conditions.h"

/** Returns true if the last condition that says more than that something is not zero contradicts the others. Rules show what a
 *  polynomial f is, until signs of factors do:
 *  - a v^2 + b v + c is positive if a and 4 a c - b^2 are, as the minors of a quadratic form that is positive definite (Sylvester);
 *  - where a condition says so of g, m f = k g + rest, with factors m > 0 and k >= 0 by which the highest powers of a variable in f
 *    and in g cancel: f is positive if the rest is. Where k has any sign, both cases are shown, each by a condition of its own.
 *  Cost: bounded by a number of polynomials, most of them small. False says nothing. */
bool ttc_elimination_excludes(const ttc_conditions *conditions);

#endif
