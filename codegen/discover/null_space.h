/** Solves P' + c P = 0, c a given function, for polynomials P in the quantities of a sector: linear algebra over a prime field,
 *  one row for each random point.
 *
 *  Why a rank is a proof. Let row i of the matrix M hold m' + c m at point i, for each monomial m. A polynomial P with
 *  coefficients in Q(parameters), not all zero, that solves P' + c P = 0 makes M singular at all points and parameters: every
 *  minor of full width is zero as a function of them, and so also at points and parameters of the prime field, which are images
 *  under a ring homomorphism defined on all that occurs. A minor of width r that is not zero there thus proves that the solutions
 *  over Q(parameters), or over the complex numbers at parameters that reduce to these, have dimension count - r at most; and so
 *  for all real parameters outside the zeros of one nonzero polynomial. Unlucky points or primes can make the rank smaller, never
 *  larger: the bound holds whatever was drawn. That the dimension is not less is shown by solutions, each proved over
 *  Q(parameters). A field without roots of the table's numbers has no such homomorphism: discover/flow.h takes a prime that has
 *  them. */
#ifndef TTC_NULL_SPACE_H
#define TTC_NULL_SPACE_H

#include "discover/ansatz.h"

#include <flint/nmod_mat.h>

/* c = twist - shift, the twist as a ratio of the ring; NULL stands for 0. */
typedef struct {
    const ttc_modular_ratio *twist;
    ulong shift;
} ttc_twist;

/** Upper bound of the dimension of solutions, from the rank alone; -1 if no points were found.
 *  parameters: shape (ring->variable_count,), with the values of parameters; other entries are overwritten.
 *  Cost: count^3/3 multiplications in the field, 8 count^2 bytes. */
slong ttc_null_space_bound(const ttc_flow *flow, const ttc_ansatz_sector *sector, ttc_twist twist, ulong *parameters,
                           uint64_t *source);

/** The same, and a basis of the null space: null, shape (bound, count), is initialized here, without rows if bound is -1. */
slong ttc_null_space(nmod_mat_t null, const ttc_flow *flow, const ttc_ansatz_sector *sector, ttc_twist twist, ulong *parameters,
                     uint64_t *source);

/** Values of monomials m, and of m' + c m, at random points: both of shape (points, count), initialized by the caller. Returns
 *  false if no points were found. */
bool ttc_null_space_rows(nmod_mat_t values, nmod_mat_t rates, const ttc_flow *flow, const ttc_ansatz_sector *sector,
                         ttc_twist twist, ulong *parameters, uint64_t *source);

/* Values of the monomials of a sector at a point that was drawn: shape (sector->count,). */
void ttc_null_space_values(ulong *out, const ttc_flow *flow, const ttc_ansatz_sector *sector, const ulong *values);

#endif
