/** A question to the solver in its own terms: conditions on the variables of a ring as formulas of Z3, its model as a point. */
#ifndef TTC_SOLVER_QUESTION_H
#define TTC_SOLVER_QUESTION_H

#include <z3.h>

#include "algebra/witness.h"

typedef struct {
    Z3_context z3;
    Z3_solver solver;
    Z3_sort real;
    Z3_ast *variables; /* by ring variable; NULL: not in use */
    size_t variable_count, terms;
    ttc_witness *point;
    bool too_large; /* to be asked */
} ttc_question;

/** State the conditions, and what they use: roots, angles, signs, and, if with_functions, bounds of functions (solver.h). */
void ttc_question_state(ttc_question *q, const ttc_conditions *conditions, bool with_functions);

/** Set the point to the model that the solver has found. Returns false if a value is none that can be read. */
bool ttc_question_read_point(ttc_question *q);

#endif
