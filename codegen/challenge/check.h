/** Checks a claim at one point, by balls around three kinds of values: those that must be zero; those that must be positive; and
 *  witnesses, of which one must be nonzero at one of the points that are tried, or the claim says nothing. */
#ifndef TTC_CHECK_H
#define TTC_CHECK_H

#include "challenge/random_point.h"
#include "prove/image.h"
#include "prove/prove.h"

typedef enum {
    TTC_HOLDS,     /* each ball that must be zero contains it, with radius 2^-64 at most, and each other one is positive */
    TTC_VIOLATED,  /* a ball excludes what it must be */
    TTC_NOT_TOLD,  /* some ball is too wide; more bits may decide */
    TTC_UNDEFINED  /* something has no value here */
} ttc_check_outcome;

typedef struct {
    const ttc_model *model, *target; /* target: the table that the claim leads to */
    const ttc_claim *claim;          /* NULL for a derived claim */
    uint32_t index;                  /* of a derived claim's record, see ttc_subject */
    bool has_smooth_density;         /* as the proof says */
    ttc_probe *probe, *target_probe;
    ttc_random random;               /* for lambda, and points of the target */
    bool is_at_target;               /* the target probe is at a point of its own, not at an image */
    ttc_check_outcome outcome;
    bool wants_witness, has_witness;
    char what[512];                  /* the first violation */
} ttc_check;

typedef void (*ttc_checker)(ttc_check *check);

void ttc_check_zero(ttc_check *check, const arb_t value, const char *what, const char *name);
void ttc_check_positive(ttc_check *check, const arb_t value, const char *what, const char *name);

/* At some point, one of the values passed here must exclude zero. */
void ttc_check_witness(ttc_check *check, const arb_t value);

/* Nothing is zero at the probe that a record divides by, see ttc_domain_divides_by_zero. */
void ttc_check_divides(ttc_check *check, ttc_probe *probe, const ttc_model *model, ttc_divisor_role role, uint32_t owner,
                       size_t use_count, const char *what, const char *name);

void ttc_check_undefined(ttc_check *check);
void ttc_check_violate(ttc_check *check, const char *what, const char *name);

/* The value and derivatives of an expression, as from ttc_probe_at. Returns NULL if there are none: the point is undefined. */
arb_srcptr ttc_check_at(ttc_check *check, ttc_id id);

/* The values of what bindings set, shape (count,), for _arb_vec_clear. Returns NULL if one has none: the point is undefined. */
arb_ptr ttc_check_bindings(ttc_check *check, const ttc_bindings *map);

/* d(expression)/dt = gradient . f. Returns false if it has no value: the point is undefined. */
bool ttc_check_rate(ttc_check *check, arb_t out, ttc_id id);

/* The Jacobian of the field, shape (n, n). Returns false if it has no value: the point is undefined. */
bool ttc_check_jacobian(ttc_check *check, arb_ptr out);

/* a - b is zero; if one of them is NULL, the point is undefined. */
void ttc_check_same(ttc_check *check, arb_srcptr a, arb_srcptr b, const char *what, const char *name);

/** Set the target probe to the image of the current point: states and parameters. Returns false if there is none. */
bool ttc_check_set_image(ttc_check *check, const ttc_image *image);


/* What both tables observe, hold valid or claim as an integral without conditions under one name has one value at a probe of the
 * model and at the target probe, if it has a value at both. */
void ttc_check_observations(ttc_check *check, ttc_probe *probe);

/* Move the target probe to a random point of its domain. Returns false if none is found. */
bool ttc_check_draw_target(ttc_check *check);

/* At a probe of the model, the way leads to the target's i-th state as the target probe has it; for an angle, to the same
 * direction. where_angles: angles may have no value. */
void ttc_check_return(ttc_check *check, ttc_probe *probe, const ttc_image *image, size_t state, bool where_angles);

void ttc_check_integral(ttc_check *check);
void ttc_check_invariant(ttc_check *check);
void ttc_check_rate_claim(ttc_check *check);
void ttc_check_measure(ttc_check *check);
void ttc_check_reversor(ttc_check *check);
void ttc_check_symmetry(ttc_check *check);
void ttc_check_period(ttc_check *check);
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
void ttc_check_observed(ttc_check *check); /* the divisors of observe, valid and tier */

#endif
