/** Taylor coefficients in balls of a straight-line program along the solution of its differential equation.
 *
 *  The recurrences are those of the emitted jets (R. E. Moore, Interval Analysis, 1966; A. Griewank, A. Walther, Evaluating
 *  Derivatives, 2nd ed., 2008, ch. 13); here each coefficient is a ball that encloses it for every start in the given balls.
 *
 *  A start may be a polynomial in two variables u and v: coefficients in time then are polynomials as well, up to a given degree,
 *  so that the result is a series in t, u and v, which contains derivatives by the start up to that order. */
#ifndef JLT_VALIDATED_JETS_H
#define JLT_VALIDATED_JETS_H

#include "ext/scoped.h"
#include "validated/formulas.h"

typedef struct jlt_jets jlt_jets;

/** The number of coefficients of a polynomial of this degree in u and v. That of u^i v^j has the index (i + j)(i + j + 1)/2 + j. */
unsigned jlt_jets_terms(unsigned degree);

/** Out: *jets, NULL on failure; destroy it with jlt_jets_destroy. In: program, one of `of`, borrowed; if order > 0, its first
 *  outputs must be the rates of the states. degree: of the polynomials, 0 for plain balls. Errors: NOMEM; UNSUPPORTED, a fused
 *  operation, which programs contain only after the compiler's last passes. */
JLT_CHECKED jlt_status jlt_jets_create(jlt_jets **jets, const jlt_formulas *of, const ttc_program *program, unsigned order,
                                       unsigned degree);
void jlt_jets_destroy(jlt_jets *jets); /* legal on NULL */
JLT_OWNED_TYPE(jlt_jets)

/** Compute the coefficients at x, shape (dim, terms), with params, shape (params,): of states up to `order`, of outputs below it;
 *  if order is 0, the values of the outputs. A coefficient without a finite enclosure, and all that depend on it, are not finite.
 *  Cost: order^2/2 products for each product of the program, 35 times as many with degree 3. Nothing is allocated. */
void jlt_jets_run(jlt_jets *self, arb_srcptr x, arb_srcptr params, slong bits);

/** Time series from the last run, lowest order first; with polynomials, the series of one coefficient after another, at a distance
 *  of order + 1. A state's series has order + 1 entries, an output's max(order, 1). */
arb_srcptr jlt_jets_state(const jlt_jets *self, unsigned i);
arb_srcptr jlt_jets_output(const jlt_jets *self, unsigned i);

/** The number of an output's coefficients that may differ from 0: 0, 1 (a constant), or all. */
unsigned jlt_jets_output_length(const jlt_jets *self, unsigned i);

#endif
