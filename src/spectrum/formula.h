/** Evaluates a table's formulas for the spectrum of a family of equilibria at exact values. */
#ifndef JLT_SPECTRUM_FORMULA_H
#define JLT_SPECTRUM_FORMULA_H

#include "analysis/linearization.h"
#include "spectrum/oracle.h"

/** Replace the values in doubles of the table's formulas for trace and characteristic polynomial, of the family result->family, by
 *  those in ball arithmetic, rounded. Symbols have the values set in the oracle; states that the family binds are given by its
 *  expressions where given[i] is 0. Does nothing if there is no family. */
void jlt_formula_enclose(jlt_linearization *result, const jlt_oracle *oracle, const unsigned char *given);

#endif
