/** Polynomials P in the quantities of a sector with P' + c P = 0, c a given function: linear algebra over a prime field, one row a
 *  random point.
 *
 *  Why a rank proves something. Let M be the matrix whose row i holds m' + c m at point i, for each monomial m. A polynomial P with
 *  coefficients in Q(parameters), not all zero, that solves P' + c P = 0 makes M singular wherever points and parameters lie: every
 *  minor of full width is zero as a function of them, thus also at parameters and points of the prime field, which are images of
 *  a ring homomorphism defined on all that is met. So a minor of width r that is not zero there proves that the solutions over
 *  Q(parameters), or over the complex numbers at parameters that reduce to these, have dimension count - r at most; and the same
 *  for all real parameters beyond the zeros of one polynomial, which is not zero. Bad luck with points or the prime makes
 *  the rank smaller than it is, never larger: the bound is a proof, whatever was drawn. That the dimension is not less is shown by
 *  solutions, each proved over Q(parameters). Where the field lacks a root of one of the table's numbers there is no such
 *  homomorphism: discover/flow.h takes a prime that has them. */
#ifndef TTC_NULL_SPACE_H
#define TTC_NULL_SPACE_H

#include "discover/ansatz.h"

#include <flint/nmod_mat.h>

/* c = twist - shift, the twist as a ratio of the ring; NULL stands for 0. */
typedef struct {
    const ttc_modular_ratio *twist;
    ulong shift;
} ttc_twist;

/** Dimension bound of the solutions, by the rank alone.
 *  parameters: shape (ring->variable_count,), with values of parameters; others are overwritten. -1: no points were found.
 *  Cost: count^3/3 multiplications in the field, 8 count^2 bytes. */
slong ttc_null_space_bound(const ttc_flow *flow, const ttc_ansatz_sector *sector, ttc_twist twist, ulong *parameters,
                           uint64_t *source);

/** The same, and a basis of the null space: null is initialized here, shape (bound, count), also where there is none. */
slong ttc_null_space(nmod_mat_t null, const ttc_flow *flow, const ttc_ansatz_sector *sector, ttc_twist twist, ulong *parameters,
                     uint64_t *source);

/** Values of monomials, and of m' + c m, at `count` points: shape (points, count), both initialized by the caller. False: no
 *  points. */
bool ttc_null_space_rows(nmod_mat_t values, nmod_mat_t rates, const ttc_flow *flow, const ttc_ansatz_sector *sector,
                         ttc_twist twist, ulong *parameters, uint64_t *source);

/* Values of the monomials of a sector at a point that was drawn: shape (sector->count,). */
void ttc_null_space_values(ulong *out, const ttc_flow *flow, const ttc_ansatz_sector *sector, const ulong *values);

#endif
