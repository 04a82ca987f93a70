/** What a table says of a family of equilibria, at exact values. */
#ifndef JLT_SPECTRUM_FORMULA_H
#define JLT_SPECTRUM_FORMULA_H

#include "analysis/linearization.h"
#include "spectrum/oracle.h"

/** The table's formulas for trace and characteristic polynomial of the family result->family, in place of what doubles make of
 *  them: at the values that the oracle has, but for states that the family binds, where given[i] is 0. */
void jlt_formula_enclose(jlt_linearization *result, const jlt_oracle *oracle, const unsigned char *given);

#endif
