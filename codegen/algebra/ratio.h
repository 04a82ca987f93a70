/** Exact arithmetic in the field Q(variables)(generators), where each generator is a square root.
 *
 *  A ratio is numerator / denominator over Z[variables, generators]: coprime, the denominator free of generators and with
 *  positive leading coefficient, the numerator of degree at most one in each generator. As the generators are kept
 *  independent (no product of some of them is rational), this form is unique, and a ratio is zero exactly when its
 *  numerator is. Nothing is ever rounded or sampled.
 *
 *  Variables that stand for exponentials, logarithms and pi may satisfy unknown relations, see algebra/independence.h.
 *
 *  Errors are sticky: the first failure stays in `status`, and later results are meaningless, so that callers check the
 *  status before they use a result. FLINT ends the program when memory is out. */
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
    TTC_RING_LARGE_EXPRESSION, /* this one and those up to MANY_FACTORS: a limit is passed */
    TTC_RING_TOO_LARGE,
    TTC_RING_MANY_ROOTS,
    TTC_RING_MANY_ANGLES,
    TTC_RING_MANY_FUNCTIONS,
    TTC_RING_LARGE_MULTIPLE,
    TTC_RING_MANY_FACTORS,
    TTC_RING_NO_MEMORY
} ttc_ring_status;

enum {
    TTC_GENERATOR_LIMIT = 32,
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
    bool positive;    /* the positive root, which is never zero; otherwise the root may have either sign or be zero */
} ttc_generator;

typedef struct {
    fmpz_mpoly_ctx_t context;
    size_t variable_count, next_spare; /* variables from next_spare on are not yet in use */
    const char **names;                /* by variable; borrowed */
    void *solver;                      /* owned by solver.c; NULL until it is first used */
    void (*release)(void *solver);     /* frees it */
    const bool *positive;              /* by variable, true if it is never negative; borrowed */
    ttc_generator generators[TTC_GENERATOR_LIMIT];
    size_t generator_count;
    unsigned char *trust;              /* by variable, a ttc_trust: what is known of its independence of the others */
    /* A root whose radicand is a square q^2 in the field is q or -q. If the sign is not evident, bit number choice_count
     * of `choices` determines it, and the count is incremented: a proof must cover every value of these bits. */
    unsigned choices, choice_count;
    bool has_sign_of_quotient; /* a root's sign was evident from a quotient: where its denominator vanishes it may be the other */
    ttc_ring_status status;
    fmpq_t minus_one;
} ttc_ring;

/* names and positive: shape (variable_count,), must outlive the ring. Variables from first_spare on are spare ones, for generators
 * that have no variable of their own. Returns NULL when memory is out. */
ttc_ring *ttc_ring_create(size_t variable_count, size_t first_spare, const char **names, const bool *positive);
void ttc_ring_destroy(ttc_ring *ring); /* legal on NULL */
const ttc_generator *ttc_ring_generator(const ttc_ring *ring, slong variable); /* whose variable it is; NULL: of none */
void ttc_ring_fail(ttc_ring *ring, ttc_ring_status status); /* sets the status unless the ring has failed before */
const char *ttc_ring_status_text(ttc_ring_status status); /* a phrase; never NULL */
/* Returns true for a failure which means that the expression has no value, rather than that it could not be computed. */
bool ttc_ring_has_no_value(ttc_ring_status status);
bool ttc_ring_is_too_large(ttc_ring_status status); /* a limit is passed */

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

/* Returns true if a is zero; also if it is not known whether it is, and the ring then fails with NOT_SETTLED. */
bool ttc_ratio_is_zero(ttc_ring *ring, const ttc_ratio *a);
bool ttc_ratio_equal(const ttc_ring *ring, const ttc_ratio *a, const ttc_ratio *b); /* compares normal forms */
bool ttc_ratio_uses(const ttc_ring *ring, const ttc_ratio *a, slong variable);
/* By the signs of all terms, or as a number: 1 if never negative, -1 if never positive, 0 if neither is evident. */
int ttc_ratio_sign(const ttc_ring *ring, const ttc_ratio *a);
/* The sign of a polynomial in positive roots of numbers alone, by balls; 0 if it uses anything else, or is too close to zero. */
int ttc_ring_sign_of_number(const ttc_ring *ring, const fmpz_mpoly_t polynomial);
/* "x + root[1], root[1] = sqrt(2)": roots that have no name in the table are defined at the end. For free(); NULL when memory is
 * out. */
char *ttc_ratio_text(const ttc_ring *ring, const ttc_ratio *a);

/** Numerator of the norm of a over Q(variables): zero exactly where some conjugate of a is zero. */
void ttc_ratio_norm(ttc_ring *ring, fmpz_mpoly_t norm, const ttc_ratio *a);

/** A square root of `radicand`: the positive one, or one of either sign if positive = false. If the radicand is a square in the
 *  field, which is decided exactly, out is in the field; otherwise `variable`, a spare one if < 0, becomes a generator. */
void ttc_ring_root(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *radicand, slong variable, bool positive);

/** Derivative of a along a direction. slopes, shape (variable_count,): the rate of each variable; those of generators are ignored
 *  and computed from their squares: r' = (r^2)'/(2r). */
void ttc_ratio_derive(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *slopes);

#endif
