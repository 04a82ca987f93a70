/** Exact linear relations over the rationals between angles, or between exponents; and the addition theorems. */
#ifndef TTC_ANGLE_H
#define TTC_ANGLE_H

#include "algebra/ratio.h"

enum { TTC_ANGLE_LIMIT = 128, TTC_ANGLE_MULTIPLE_LIMIT = 64 };

typedef enum {
    TTC_ANGLE_WHOLE,    /* a linear combination of the basis with integer weights */
    TTC_ANGLE_FRACTION, /* a linear combination with rational weights, not all integers */
    TTC_ANGLE_FREE      /* linearly independent of the basis, so that its cosine and sine are independent too */
} ttc_angle_relation;

/** Find the relation of `angle` to `basis`, shape (count,), which is linearly independent over the rationals.
 *  Out: multiples, shape (count,), the weights if WHOLE. The ring fails if one is above TTC_ANGLE_MULTIPLE_LIMIT in size.
 *  quarters: NULL; or the first angle of the basis is a quarter turn: if its weight has roots (ttc_angle_has_roots), the weight
 *  goes here, may be a fraction, and its multiple is 0. */
ttc_angle_relation ttc_angle_relate(ttc_ring *ring, long *multiples, fmpq *quarters, const ttc_ratio *angle, const ttc_ratio *basis,
                                    size_t count);

/** Find rational weights, shape (count,), of `angle` as a linear combination of the basis. Returns false if there are none. */
bool ttc_angle_weigh(ttc_ring *ring, fmpq *weights, const ttc_ratio *angle, const ttc_ratio *basis, size_t count);

/** Choose a basis over the rationals among the angles such that, where possible, the others are integer combinations of it. It is
 *  built in the order given; if that leaves an angle that is a fraction, it is built again with that angle right after the fixed
 *  ones, once for each angle. The first `fixed` angles, which must be independent, are always chosen. has_turn: the first one is a
 *  quarter turn, as for ttc_angle_relate.
 *  Out: chosen, shape (count,): indices into angles, as many as returned. count is at most TTC_ANGLE_LIMIT. */
size_t ttc_angle_choose(ttc_ring *ring, size_t *chosen, const ttc_ratio *angles, size_t count, size_t fixed, bool has_turn);

/** (cosine + i sine) *= (c + i s)^multiple, for the cosine and sine c, s of one angle. */
void ttc_angle_turn(ttc_ring *ring, ttc_ratio *cosine, ttc_ratio *sine, const ttc_ratio *c, const ttc_ratio *s, long multiple);

/* Returns true if cosine and sine of so many quarter turns are known by square roots: of k pi/n where n divides 240. */
bool ttc_angle_has_roots(const fmpq_t quarters);

/* (cosine + i sine) *= i^quarters, for an angle that has roots. */
void ttc_angle_turn_exactly(ttc_ring *ring, ttc_ratio *cosine, ttc_ratio *sine, const fmpq_t quarters);

#endif
