/** The solver for nonlinear real arithmetic, Z3 (L. de Moura, N. Bjorner, TACAS 2008; D. Jovanovic, L. de Moura, Solving
 *  Non-linear Arithmetic, IJCAR 2012). Only solver.c calls Z3. */
#ifndef TTC_SOLVER_H
#define TTC_SOLVER_H

#include "algebra/witness.h"

typedef enum { TTC_SOLVER_POINT, TTC_SOLVER_NO_POINT, TTC_SOLVER_SILENT } ttc_solver_answer;

/** Ask for a point that meets the conditions. On POINT, `point` has its coordinates, or rational approximations of irrational
 *  ones, which the caller must verify; variables that no condition uses keep their values. NO_POINT: the solver states that there
 *  is none. Cost: bounded in the solver's own units of work. */
ttc_solver_answer ttc_solver_ask(ttc_witness *point, const ttc_conditions *conditions);

#endif
