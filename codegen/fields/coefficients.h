/** Coefficients of an expression that is a polynomial in one symbol. */
#ifndef TTC_COEFFICIENTS_H
#define TTC_COEFFICIENTS_H

#include "expression/graph.h"

/** Compute the coefficients, shape (degree + 1,), from that of symbol^degree down to the constant term.
 *  Returns false if the expression is not a polynomial in the symbol, has a higher degree, or memory is out. */
bool ttc_polynomial_coefficients(ttc_graph *graph, ttc_id *coefficients, size_t degree, ttc_id expression, uint32_t symbol);

#endif
