/** Lifts a null vector at one set of parameters to a polynomial over Q(parameters). */
#ifndef TTC_SOLUTION_H
#define TTC_SOLUTION_H

#include "discover/null_space.h"

/** Vectors of the null space with few nonzero entries, fewest first: rows of reduced echelon forms after permutations of the
 *  columns. out: initialized here, shape (number found, count); each row is 1 at its last nonzero entry. */
void ttc_solution_sparse(nmod_mat_t out, const nmod_mat_t null, uint64_t *source);

typedef struct {
    ttc_ratio polynomial; /* with whole coefficients in Z[parameters], without common factor */
    ttc_ratio cofactor;   /* P'/P, if a cofactor was asked for */
} ttc_solution_exact;

/** The solution with the monomials j for which vector[j] != 0, as a polynomial. vector: shape (sector->count,).
 *  cofactor: if not 0, P' = cofactor P is solved, and this is the cofactor at the current parameters, on which it depends.
 *  Returns false if the dependence on parameters was not found, as where several cofactors belong to these monomials. Clear out in
 *  any case. */
bool ttc_solution_lift(ttc_solution_exact *out, const ttc_flow *flow, const ttc_ansatz_sector *sector, const ulong *vector,
                       const ttc_modular_ratio *twist, ulong cofactor, uint64_t *source);
void ttc_solution_clear(ttc_solution_exact *solution, const ttc_flow *flow);

/** Nonzero elements of the field that may be the cofactor of a polynomial of the sector at these parameters: eigenvalues of P ->
 *  P', interpolated in the sector. out: shape (sector->count,); *count: their number. Returns false if they were not computed, so
 *  that nothing is known. Cost: about count^3 operations. */
bool ttc_solution_cofactors(ulong *out, size_t *count, const ttc_flow *flow, const ttc_ansatz_sector *sector, ulong *parameters,
                            uint64_t *source);

#endif
