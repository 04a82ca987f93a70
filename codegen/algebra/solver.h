/** The solver for nonlinear real arithmetic, Z3 (L. de Moura, N. Bjorner, TACAS 2008; D. Jovanovic, L. de Moura, Solving
 *  Non-linear Arithmetic, IJCAR 2012). The only place that calls it. */
#ifndef TTC_SOLVER_H
#define TTC_SOLVER_H

#include "algebra/witness.h"

typedef enum { TTC_SOLVER_POINT, TTC_SOLVER_NO_POINT, TTC_SOLVER_SILENT } ttc_solver_answer;

/** Ask for a point that meets the conditions. On POINT its coordinates, or rational numbers within 2^-100 of them, are in
 *  `point`, to be checked by the caller; variables that no condition speaks of keep their values.
 *  Cost: bounded in the solver's own units of work. */
ttc_solver_answer ttc_solver_ask(ttc_witness *point, const ttc_conditions *conditions);

#endif
