/** Exact rational functions: the field Q(variables)(generators), where each generator is a square root.
 *
 *  A ratio is numerator / denominator over Z[variables, generators]: coprime, the denominator free of generators with
 *  positive leading coefficient, the numerator of degree at most one in each generator. As the generators are kept
 *  independent (no product of some of them is rational), this form is unique, and a ratio is zero exactly when its
 *  numerator is. Nothing is ever rounded or sampled.
 *
 *  Variables that stand for exponentials, logarithms and pi may be related where nobody knows, see algebra/independence.h.
 *
 *  Errors are sticky: the first failure stays in `status`, later results mean nothing, and whoever draws a conclusion
 *  asks for it first. FLINT ends the program when memory is out. */
#ifndef TTC_RATIO_H
#define TTC_RATIO_H

#include <stdbool.h>
#include <stddef.h>

#include <flint/fmpq.h>
#include <flint/fmpz_mpoly.h>

typedef enum {
    TTC_RING_OK,
    TTC_RING_DIVISION_BY_ZERO,
    TTC_RING_ROOT_OF_ZERO,     /* roots are positive by declaration */
    TTC_RING_ROOT_OF_NEGATIVE,
    TTC_RING_CIRCULAR,
    TTC_RING_ANGLE_ALONE, /* a state that is an angle, of which a map gives no more than cosine and sine */
    TTC_RING_ANGLE,
    TTC_RING_ANGLE_FRACTION,
    TTC_RING_EXPONENT,
    TTC_RING_EXPONENT_FRACTION,
    TTC_RING_LOGARITHM,
    TTC_RING_LOG_OF_ZERO,
    TTC_RING_LOG_OF_NEGATIVE,
    TTC_RING_PI,
    TTC_RING_NOT_SETTLED,
    TTC_RING_TOO_LARGE,
    TTC_RING_NO_MEMORY
} ttc_ring_status;

enum {
    TTC_GENERATOR_LIMIT = 16,
    TTC_PRODUCT_LIMIT = 1 << 26, /* pairs of terms in one multiplication */
    TTC_DEGREE_LIMIT = 1 << 12,  /* of a polynomial, in all variables together */
    TTC_BITS_LIMIT = 1 << 17     /* of a coefficient */
};

typedef struct {
    fmpz_mpoly_t numerator, denominator;
} ttc_ratio;

typedef struct {
    slong variable;
    ttc_ratio square; /* in variables and earlier generators */
    bool positive;    /* a root: never zero. Otherwise an algebraic function of either sign. */
} ttc_generator;

typedef struct {
    fmpz_mpoly_ctx_t context;
    size_t variable_count, next_spare; /* variables from next_spare on are not yet in use */
    const char **names;                /* borrowed */
    void *solver;                      /* see solver.h; NULL until it is asked, and then: */
    void (*release)(void *solver);
    const bool *positive;              /* by variable; borrowed */
    ttc_generator generators[TTC_GENERATOR_LIMIT];
    size_t generator_count;
    unsigned char *trust;              /* by variable: why it is independent of the others, a ttc_trust */
    /* A root whose radicand turns out to be a square q^2 is q or -q. Where the sign cannot be told, bit number
     * choice_count of `choices` decides, and the count goes up: whoever proves, proves every choice. */
    unsigned choices, choice_count;
    ttc_ring_status status;
    fmpq_t minus_one;
} ttc_ring;

/* names and positive: shape (variable_count,), must outlive the ring; spares follow from first_spare on. */
ttc_ring *ttc_ring_create(size_t variable_count, size_t first_spare, const char **names, const bool *positive);
void ttc_ring_destroy(ttc_ring *ring); /* legal on NULL */
bool ttc_ring_is_generator(const ttc_ring *ring, slong variable); /* whether it is one that was adjoined */
void ttc_ring_fail(ttc_ring *ring, ttc_ring_status status);
const char *ttc_ring_status_text(ttc_ring_status status); /* a phrase; never NULL */
/* A failure that says that what was evaluated has no value, rather than that it could not be computed. */
bool ttc_ring_has_no_value(ttc_ring_status status);

void ttc_ratio_init(ttc_ring *ring, ttc_ratio *a);
void ttc_ratio_clear(ttc_ring *ring, ttc_ratio *a);
void ttc_ratio_set(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a);
void ttc_ratio_set_rational(ttc_ring *ring, ttc_ratio *out, const fmpq_t value);
void ttc_ratio_set_integer(ttc_ring *ring, ttc_ratio *out, slong value);
void ttc_ratio_set_variable(ttc_ring *ring, ttc_ratio *out, slong variable);
void ttc_ratio_set_polynomial(ttc_ring *ring, ttc_ratio *out, const fmpz_mpoly_t polynomial);

/* out may be an operand. */
void ttc_ratio_add(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *b);
void ttc_ratio_subtract(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *b);
void ttc_ratio_multiply(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *b);
void ttc_ratio_divide(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *b);
void ttc_ratio_power(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, long exponent);
void ttc_ratio_scale(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const fmpq_t factor);
void ttc_ratio_add_product(ttc_ring *ring, ttc_ratio *sum, const ttc_ratio *a, const ttc_ratio *b); /* sum += a*b */

/* True for zero, and where it is not settled whether a is zero: the ring has then failed. */
bool ttc_ratio_is_zero(ttc_ring *ring, const ttc_ratio *a);
bool ttc_ratio_equal(const ttc_ring *ring, const ttc_ratio *a, const ttc_ratio *b); /* in form */
bool ttc_ratio_uses(const ttc_ring *ring, const ttc_ratio *a, slong variable);
int ttc_ratio_sign(const ttc_ring *ring, const ttc_ratio *a); /* 1, -1 where evident from the terms; else 0 */
char *ttc_ratio_text(const ttc_ring *ring, const ttc_ratio *a); /* for free(); NULL when memory is out */

/** Numerator of the norm down to Q(variables): zero exactly where some conjugate of a is zero. */
void ttc_ratio_norm(ttc_ring *ring, fmpz_mpoly_t norm, const ttc_ratio *a);

/** A square root of `radicand`, positive or (positive = false) any. Expressed through what the ring has when the radicand is
 *  a square in its field, which is decided exactly, nested roots included; otherwise `variable` (or a spare one when negative)
 *  becomes a generator. */
void ttc_ring_root(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *radicand, slong variable, bool positive);

/** Derivative of a along a direction. slopes: shape (variable_count,), the rate of each variable; those of generators are
 *  ignored, as they follow from their squares: r' = (r^2)'/(2r). */
void ttc_ratio_derive(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *slopes);

#endif
