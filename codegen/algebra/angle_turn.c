/* Cosines and sines of sums of angles, and of rational multiples of pi by square roots: of pi/3 and pi/5, and of pi/2 halved. */
#include "algebra/angle.h"

#include <flint/ulong_extras.h>
#include <stdlib.h>

enum { HALVINGS_MAX = 4 /* of pi; each takes a root within a root */ };

void ttc_angle_turn(ttc_ring *ring, ttc_ratio *cosine, ttc_ratio *sine, const ttc_ratio *c, const ttc_ratio *s, long multiple)
{
    ttc_ratio turn, real, imaginary;
    ttc_ratio_init(ring, &turn);
    ttc_ratio_init(ring, &real);
    ttc_ratio_init(ring, &imaginary);
    if (multiple > 0) ttc_ratio_set(ring, &turn, s);
    else ttc_ratio_scale(ring, &turn, s, ring->minus_one);
    for (long k = labs(multiple); k > 0 && ring->status == TTC_RING_OK; k--) {
        ttc_ratio_multiply(ring, &imaginary, cosine, &turn);
        ttc_ratio_add_product(ring, &imaginary, sine, c);
        ttc_ratio_multiply(ring, &real, sine, &turn);
        ttc_ratio_multiply(ring, cosine, cosine, c);
        ttc_ratio_subtract(ring, cosine, cosine, &real);
        ttc_ratio_set(ring, sine, &imaginary);
    }
    ttc_ratio_clear(ring, &imaginary);
    ttc_ratio_clear(ring, &real);
    ttc_ratio_clear(ring, &turn);
}

/* The denominator n of an angle of k pi/n, given in quarter turns, as 2^halvings thirds fifths. Returns false if it is none. */
static bool split(ulong *halvings, ulong *thirds, ulong *fifths, const fmpq_t quarters)
{
    fmpz_t n, rest;
    bool is_split = false;
    fmpz_init_set(n, fmpq_denref(quarters));
    fmpz_init(rest);
    if (fmpz_is_odd(fmpq_numref(quarters))) fmpz_mul_2exp(n, n, 1);
    *halvings = fmpz_val2(n);
    *thirds = fmpz_divisible_si(n, 3) ? 3 : 1;
    *fifths = fmpz_divisible_si(n, 5) ? 5 : 1;
    fmpz_set_ui(rest, (1ul << HALVINGS_MAX) * 15);
    is_split = fmpz_divisible(rest, n);
    fmpz_clear(rest);
    fmpz_clear(n);
    return is_split;
}

bool ttc_angle_has_roots(const fmpq_t quarters)
{
    ulong halvings, thirds, fifths;
    return split(&halvings, &thirds, &fifths, quarters);
}

/* out = sqrt((a + b x)/n), the positive root of a number. */
static void root_of(ttc_ring *ring, ttc_ratio *out, slong a, slong b, const ttc_ratio *x, ulong n)
{
    const unsigned choices = ring->choice_count;
    ttc_ratio radicand;
    fmpq_t factor;
    fmpq_init(factor);
    ttc_ratio_init(ring, &radicand);
    ttc_ratio_set_integer(ring, &radicand, a);
    fmpq_set_si(factor, b, 1);
    if (b != 0) {
        ttc_ratio term;
        ttc_ratio_init(ring, &term);
        ttc_ratio_scale(ring, &term, x, factor);
        ttc_ratio_add(ring, &radicand, &radicand, &term);
        ttc_ratio_clear(ring, &term);
    }
    fmpq_set_si(factor, 1, n);
    ttc_ratio_scale(ring, &radicand, &radicand, factor);
    ttc_ring_root(ring, out, &radicand, -1, true);
    if (ring->choice_count != choices) ttc_ring_fail(ring, TTC_RING_ANGLE_FRACTION); /* the root's sign is not evident */
    ttc_ratio_clear(ring, &radicand);
    fmpq_clear(factor);
}

/* c, s: cosine and sine of pi/2^halvings. */
static void halve(ttc_ring *ring, ttc_ratio *c, ttc_ratio *s, ulong halvings)
{
    fmpq_t half;
    fmpq_init(half);
    fmpq_set_si(half, 1, 2);
    ttc_ratio_set_integer(ring, c, halvings == 0 ? -1 : 0);
    ttc_ratio_set_integer(ring, s, halvings == 0 ? 0 : 1);
    for (ulong i = 1; i < halvings && ring->status == TTC_RING_OK; i++) {
        root_of(ring, c, 1, 1, c, 2);
        ttc_ratio_divide(ring, s, s, c);
        ttc_ratio_scale(ring, s, s, half);
    }
    fmpq_clear(half);
}

static void third(ttc_ring *ring, ttc_ratio *c, ttc_ratio *s)
{
    fmpq_t half;
    fmpq_init(half);
    fmpq_set_si(half, 1, 2);
    ttc_ratio_set_rational(ring, c, half);
    root_of(ring, s, 3, 0, NULL, 4);
    fmpq_clear(half);
}

/* cos(pi/5) = (1 + sqrt(5))/4, sin(pi/5)^2 = (5 - sqrt(5))/8 */
static void fifth(ttc_ring *ring, ttc_ratio *c, ttc_ratio *s)
{
    ttc_ratio one, root;
    fmpq_t quarter;
    fmpq_init(quarter);
    fmpq_set_si(quarter, 1, 4);
    ttc_ratio_init(ring, &one);
    ttc_ratio_init(ring, &root);
    root_of(ring, &root, 5, 0, NULL, 1);
    root_of(ring, s, 5, -1, &root, 8);
    ttc_ratio_set_integer(ring, &one, 1);
    ttc_ratio_add(ring, c, &one, &root);
    ttc_ratio_scale(ring, c, c, quarter);
    ttc_ratio_clear(ring, &root);
    ttc_ratio_clear(ring, &one);
    fmpq_clear(quarter);
}

/* The multiple of pi/part in k pi/n, where part and n/part have no common divisor: what is left is a multiple of pi part/n. */
static slong multiple_of(const fmpz_t k, ulong n, ulong part)
{
    return part == 1 ? 0 : (slong)(fmpz_fdiv_ui(k, part) * n_invmod(n / part % part, part) % part);
}

void ttc_angle_turn_exactly(ttc_ring *ring, ttc_ratio *cosine, ttc_ratio *sine, const fmpq_t quarters)
{
    ulong halvings, thirds, fifths;
    ttc_ratio c, s;
    fmpz_t k;
    if (!split(&halvings, &thirds, &fifths, quarters)) {
        ttc_ring_fail(ring, TTC_RING_ANGLE_FRACTION);
        return;
    }
    const ulong odd = thirds * fifths, n = odd << halvings;
    ttc_ratio_init(ring, &c);
    ttc_ratio_init(ring, &s);
    fmpz_init(k); /* the angle is k pi/n */
    fmpz_mul_ui(k, fmpq_numref(quarters), n);
    fmpz_divexact(k, k, fmpq_denref(quarters));
    fmpz_divexact_ui(k, k, 2);
    const slong of_third = multiple_of(k, n, thirds), of_fifth = multiple_of(k, n, fifths);
    fmpz_sub_si(k, k, of_third * (slong)(n / thirds) + of_fifth * (slong)(n / fifths));
    fmpz_divexact_ui(k, k, odd);
    const slong whole = 1l << halvings, rest = (slong)fmpz_fdiv_ui(k, 2ul << halvings);
    if (of_third != 0) third(ring, &c, &s);
    if (of_third != 0) ttc_angle_turn(ring, cosine, sine, &c, &s, of_third);
    if (of_fifth != 0) fifth(ring, &c, &s);
    if (of_fifth != 0) ttc_angle_turn(ring, cosine, sine, &c, &s, of_fifth);
    if (rest != 0) halve(ring, &c, &s, halvings);
    if (rest != 0) ttc_angle_turn(ring, cosine, sine, &c, &s, rest > whole ? rest - 2 * whole : rest);
    fmpz_clear(k);
    ttc_ratio_clear(ring, &s);
    ttc_ratio_clear(ring, &c);
}
