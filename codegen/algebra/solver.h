/** The solver for nonlinear real arithmetic, Z3 (L. de Moura, N. Bjorner, TACAS 2008; D. Jovanovic, L. de Moura, Solving
 *  Non-linear Arithmetic, IJCAR 2012). Only solver.c, solver_question.c and qepcad.c call Z3. */
#ifndef TTC_SOLVER_H
#define TTC_SOLVER_H

#include "algebra/witness.h"

typedef enum { TTC_SOLVER_POINT, TTC_SOLVER_NO_POINT, TTC_SOLVER_SILENT } ttc_solver_answer;

/** Ask for a point that meets the conditions. On POINT, `point` has its coordinates, or rational approximations of irrational
 *  ones, which the caller must verify; variables that no condition uses keep their values. NO_POINT: Z3 and QEPCAD find that
 *  there is none. Exponentials and logarithms may have any value with their sign, cosines and sines any with c^2 + s^2 = 1, and
 *  functions of numbers the values that agree with theirs to fifty digits; with_functions: but only within the bounds that their
 *  arguments a give, 1 + a <= exp(a) <= 1/(1 - a), the latter where a < 1,
 *  cos(a) >= 1 - a^2/2 and |sin(a)| <= |a|, strictly if a is not zero. Cost: bounded by Z3's own units of work, which take seconds;
 *  for NO_POINT also some 6 s, in which the conditions that QEPCAD gets are chosen, and up to 6 s of QEPCAD. */
ttc_solver_answer ttc_solver_ask(ttc_witness *point, const ttc_conditions *conditions, bool with_functions);

/* Returns true if this question, without functions, was asked before, and the answer, NO_POINT, is remembered. */
bool ttc_solver_has_excluded(ttc_witness *point, const ttc_conditions *conditions);

#endif
