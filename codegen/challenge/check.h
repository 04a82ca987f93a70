/** What a claim says at one point, as balls: those that must hold zero, those that must be positive, and those of which one
 *  must differ from zero at some point. */
#ifndef TTC_CHECK_H
#define TTC_CHECK_H

#include "challenge/random_point.h"
#include "prove/image.h"
#include "prove/prove.h"

typedef enum {
    TTC_HOLDS,     /* each ball is zero to within 2^-64 of its terms, or positive */
    TTC_VIOLATED,  /* a ball excludes what it must be */
    TTC_NOT_TOLD,  /* more bits may tell */
    TTC_UNDEFINED  /* something has no value here */
} ttc_check_outcome;

typedef struct {
    const ttc_model *model, *target; /* target: the table that the claim leads to */
    const ttc_claim *claim;          /* NULL for derived ones */
    uint32_t index;                  /* of what a derived one is about */
    ttc_probe *probe, *target_probe;
    ttc_random random;               /* for lambda */
    ttc_check_outcome outcome;
    bool wants_witness, has_witness;
    char what[512];                  /* the first violation */
} ttc_check;

typedef void (*ttc_checker)(ttc_check *check);

void ttc_check_zero(ttc_check *check, const arb_t value, const char *what, const char *name);
void ttc_check_positive(ttc_check *check, const arb_t value, const char *what, const char *name);

/* One ball, at some point, must exclude zero. */
void ttc_check_witness(ttc_check *check, const arb_t value);

void ttc_check_undefined(ttc_check *check);
void ttc_check_violate(ttc_check *check, const char *what, const char *name);

/* The value and derivatives of an expression, NULL after ttc_check_undefined. */
arb_srcptr ttc_check_at(ttc_check *check, ttc_id id);

/* d(expression)/dt = gradient . f; false after ttc_check_undefined. */
bool ttc_check_rate(ttc_check *check, arb_t out, ttc_id id);

/* The Jacobian of the field, shape (n, n); false after ttc_check_undefined. */
bool ttc_check_jacobian(ttc_check *check, arb_ptr out);

/* a - b is zero; a value that is missing leaves the point untold. */
void ttc_check_same(ttc_check *check, arb_srcptr a, arb_srcptr b, const char *what, const char *name);

/** The target probe at the image of the point in hand: states and parameters. False: it has none. */
bool ttc_check_set_image(ttc_check *check, const ttc_image *image);

/* What leads to the target's i-th state from a probe of the model: sine and cosine of an angle over one positive number, or the
 * state and 1; false: undefined. */
bool ttc_check_way_to(ttc_check *check, ttc_probe *probe, const ttc_image *image, size_t state, arb_t sine, arb_t cosine);

void ttc_check_integral(ttc_check *check);
void ttc_check_invariant(ttc_check *check);
void ttc_check_rate_claim(ttc_check *check);
void ttc_check_measure(ttc_check *check);
void ttc_check_reversor(ttc_check *check);
void ttc_check_symmetry(ttc_check *check);
void ttc_check_equal(ttc_check *check);
void ttc_check_positive_claim(ttc_check *check);
void ttc_check_equilibria(ttc_check *check);
void ttc_check_trace(ttc_check *check);
void ttc_check_charpoly(ttc_check *check);
void ttc_check_matrix(ttc_check *check);
void ttc_check_left_null(ttc_check *check);
void ttc_check_obstructs(ttc_check *check);
void ttc_check_reduction(ttc_check *check); /* and embeddings */
void ttc_check_section(ttc_check *check);
void ttc_check_way(ttc_check *check); /* reductions by a table, and lifts */
void ttc_check_pole(ttc_check *check);
void ttc_check_root(ttc_check *check); /* and logarithms */
void ttc_check_variant(ttc_check *check);
void ttc_check_time(ttc_check *check);
void ttc_check_elimination(ttc_check *check);
void ttc_check_observed(ttc_check *check); /* what observe, valid and tier divide by */

#endif
