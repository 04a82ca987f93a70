/** From a null vector at one set of parameters to a polynomial over Q(parameters). */
#ifndef TTC_SOLUTION_H
#define TTC_SOLUTION_H

#include "discover/null_space.h"

/** Vectors of the null space with few entries that are not 0, fewest first: rows of it in reduced echelon form after permutations
 *  of the columns. out: initialized here, shape (number found, count); each row is 1 at its last entry that is not 0. */
void ttc_solution_sparse(nmod_mat_t out, const nmod_mat_t null, uint64_t *source);

typedef struct {
    ttc_ratio polynomial; /* with whole coefficients in Z[parameters], without common factor */
    ttc_ratio cofactor;   /* P'/P, where that was looked for */
} ttc_solution_exact;

/** The solution whose monomials are those with vector[j] != 0, as a polynomial. vector: shape (sector->count,).
 *  cofactor: not 0 where P' = cofactor P is solved, with a cofactor that depends on parameters and is this number at those in use.
 *  False: the dependence on parameters was not found, as where several cofactors belong to these monomials. out is initialized in
 *  any case, for _clear. */
bool ttc_solution_lift(ttc_solution_exact *out, const ttc_flow *flow, const ttc_ansatz_sector *sector, const ulong *vector,
                       const ttc_modular_ratio *twist, ulong cofactor, uint64_t *source);
void ttc_solution_clear(ttc_solution_exact *solution, const ttc_flow *flow);

/** Numbers of the field, other than 0, that may be the cofactor of a polynomial of the sector, at these parameters: eigenvalues of
 *  the rates, cut off at its degree. out: shape (sector->count,); count: how many. False: no points were found, and nothing
 *  is known of cofactors. Cost: about count^3 operations. */
bool ttc_solution_cofactors(ulong *out, size_t *count, const ttc_flow *flow, const ttc_ansatz_sector *sector, ulong *parameters,
                            uint64_t *source);

#endif
