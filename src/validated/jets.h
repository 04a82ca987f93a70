/** Taylor coefficients in balls, order by order, of a straight-line program along the solution of its own equation.
 *
 *  The recurrences are those of the emitted jets (R. E. Moore, Interval Analysis, 1966; A. Griewank, A. Walther, Evaluating
 *  Derivatives, 2nd ed., 2008, ch. 13); here a coefficient is a ball that encloses it for every start in the balls given.
 *
 *  A start may be a polynomial in two variables u and v: coefficients in time are then polynomials as well, to the degree asked
 *  for, which are those of series in t, u and v. So derivatives by the start come along to any order. */
#ifndef JLT_VALIDATED_JETS_H
#define JLT_VALIDATED_JETS_H

#include "validated/balls.h"
#include "validated/formulas.h"

typedef struct jlt_jets jlt_jets;

/** How many coefficients polynomials of this degree have. That of u^i v^j is at (i + j)(i + j + 1)/2 + j. */
unsigned jlt_jets_terms(unsigned degree);

/** Out: *jets, NULL on failure; destroy with jlt_jets_destroy. program, of `of`, is borrowed; its first outputs are rates of the
 *  states where `order` is more than 0. degree: of polynomials, 0 for balls alone. Errors: NOMEM; UNSUPPORTED, a fused operation,
 *  which programs do not have before the compiler's last passes. */
JLT_CHECKED jlt_status jlt_jets_create(jlt_jets **jets, const jlt_formulas *of, const ttc_program *program, unsigned order,
                                       unsigned degree);
void jlt_jets_destroy(jlt_jets *jets); /* legal on NULL */

/** Coefficients at x, shape (dim, terms), with params, shape (params,): of states to `order`, of outputs below it; with order 0
 *  those of outputs alone, to order 0. Where one has no finite enclosure, it and all that hang on it are not finite. Cost:
 *  order^2/2 products for each product of the program, 35 times as many with degree 3. Nothing is allocated. */
void jlt_jets_run(jlt_jets *self, arb_srcptr x, arb_srcptr params, slong bits);

/** Their series, lowest order first, those of the polynomial's coefficients behind each other in steps of order + 1: of state i,
 *  order + 1 long; of output i, `order` long, at least 1. */
arb_srcptr jlt_jets_state(const jlt_jets *self, unsigned i);
arb_srcptr jlt_jets_output(const jlt_jets *self, unsigned i);

/** How many of an output's coefficients are not 0 for every motion: 0, 1, or all of them. */
unsigned jlt_jets_output_length(const jlt_jets *self, unsigned i);

#endif
