/** Evaluates exact polynomials and ratios at points of a prime field.
 *
 *  Memory comes from FLINT, here and in all of discover/: when it is out the program ends, see base/exhaustion.h. */
#ifndef TTC_MODULAR_H
#define TTC_MODULAR_H

#include "algebra/ratio.h"

#include <stdint.h>

#include <flint/nmod_vec.h>
#if __has_include(<flint/nmod.h>) /* FLINT 3 */
#include <flint/nmod.h>
#endif

/* The largest prime below 2^62. */
#define TTC_PRIME ((ulong)4611686018427387847)

/* Terms one after the other, each with its coefficient and powers. */
typedef struct {
    size_t count;
    ulong *coefficients;
    size_t *ends;         /* by term: end of its powers in the arrays below */
    uint32_t *variables;
    uint32_t *exponents;
} ttc_modular_polynomial;

typedef struct {
    ttc_modular_polynomial numerator, denominator;
} ttc_modular_ratio;

/* *out, zeroed or set before, becomes the image of a ratio; for ttc_modular_ratio_clear. */
void ttc_modular_ratio_set(ttc_modular_ratio *out, const ttc_ring *ring, const ttc_ratio *a, nmod_t mod);
void ttc_modular_ratio_clear(ttc_modular_ratio *a);

/** values: shape (variable_count,), of the ring's variables. Returns false, *out unchanged, if the denominator is zero there. */
bool ttc_modular_ratio_value(ulong *out, const ttc_modular_ratio *a, const ulong *values, nmod_t mod);

/* A nonzero element of the field. source: the generator's state, at first any number. The same on every machine. */
ulong ttc_modular_draw(uint64_t *source, nmod_t mod);

/* The rational number with numerator and denominator below 2^30 that a residue stands for. Returns false if there is none. */
bool ttc_modular_rational(fmpq_t out, ulong residue, nmod_t mod);

#endif
