/** Linear relations over the rationals between angles, or exponents, found exactly; and the addition theorems. */
#ifndef TTC_ANGLE_H
#define TTC_ANGLE_H

#include "algebra/ratio.h"

enum { TTC_ANGLE_LIMIT = 128, TTC_ANGLE_MULTIPLE_LIMIT = 64 };

typedef enum {
    TTC_ANGLE_WHOLE,    /* a sum of whole multiples of the basis */
    TTC_ANGLE_FRACTION, /* a sum of rational multiples of the basis, not all whole */
    TTC_ANGLE_FREE      /* linearly independent of the basis, so that its cosine and sine are independent too */
} ttc_angle_relation;

/** How `angle` follows from `basis`, shape (count,), which is linearly independent over the rationals.
 *  Out: multiples, shape (count,), when WHOLE. Multiples over TTC_ANGLE_MULTIPLE_LIMIT are the ring's failure TOO_LARGE. */
ttc_angle_relation ttc_angle_relate(ttc_ring *ring, long *multiples, const ttc_ratio *angle, const ttc_ratio *basis,
                                    size_t count);

/** The same with rational weights, shape (count,); false when there are none. */
bool ttc_angle_weigh(ttc_ring *ring, fmpq *weights, const ttc_ratio *angle, const ttc_ratio *basis, size_t count);

/** Choose a basis: as few of the angles as possible, such that all others are sums of whole multiples of them. Angles are tried in
 *  their order, then again with one put first that is a fraction of others; where there is no such basis, fractions remain.
 *  The first `fixed` ones, which are independent, are always chosen.
 *  Out: chosen, shape (count,): positions, as many as returned. count is at most TTC_ANGLE_LIMIT. */
size_t ttc_angle_choose(ttc_ring *ring, size_t *chosen, const ttc_ratio *angles, size_t count, size_t fixed);

/** (cosine + i sine) *= (c + i s)^multiple, for the cosine and sine c, s of one angle. */
void ttc_angle_turn(ttc_ring *ring, ttc_ratio *cosine, ttc_ratio *sine, const ttc_ratio *c, const ttc_ratio *s, long multiple);

#endif
