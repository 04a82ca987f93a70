/** A model's equations of motion as ratios, exact and at points of a prime field.
 *
 *  Quantities are what the monomials of an ansatz are made of: every state, root and function of the table that changes along the
 *  motion. They are variables and generators of the ring of the plain valuation under conditions on parameters, in which relations
 *  between functions are known. A point gives each quantity a nonzero value, such that the square of each root is its radicand:
 *  this is a homomorphism of the ring into the field, defined where no denominator that occurs vanishes. */
#ifndef TTC_FLOW_H
#define TTC_FLOW_H

#include "algebra/valuation.h"
#include "discover/modular.h"

typedef struct {
    const ttc_model *model;
    ttc_valuation *valuation;
    ttc_ring *ring;
    nmod_t mod;          /* of the largest prime, at most TTC_PRIME, for which points were found */
    size_t count;        /* quantities, roots last */
    slong *variables;    /* by quantity: its variable in the ring */
    int *degrees;        /* by quantity: 1; for a root, half the degree of its radicand, rounded up, if that is more */
    bool *is_root;       /* by quantity: a root, whose square is known, so that it has exponent 0 or 1 in an ansatz */
    bool is_graded;      /* every radicand is a polynomial in the quantities */
    ttc_ratio *slopes;   /* by variable of the ring, roots included: its rate */
    ttc_modular_ratio *rates; /* by quantity: the image of its rate */
    ttc_ratio divergence;
    size_t parameter_count;
    slong *parameters;   /* variables that are constant along the motion, not bound, and no roots */
    ttc_modular_ratio *squares; /* by generator of the ring: the image of its square */
} ttc_flow;

/** Make the flow of a model. conditions: parameters that are set first; may be NULL. Returns NULL, and *why, if the equations of
 *  motion are no ratios under them, or no points were found. */
ttc_flow *ttc_flow_create(const ttc_model *model, const ttc_bindings *conditions, const char **why);
void ttc_flow_destroy(ttc_flow *flow); /* legal on NULL */

/** Change to the largest prime field, of order at most `prime`, in which there are points: roots of numbers are in some fields
 *  only. Returns false if none was found. Values drawn before, and modular images of other ratios, are then invalid, see
 *  ttc_knowns_reduce. */
bool ttc_flow_take_prime(ttc_flow *flow, ulong prime);

/** Draw values of the parameters, and of their roots, into values, shape (ring->variable_count,). zero: the variable of a parameter
 *  that is set to 0; -1: none. Returns false if roots were not found, which in a field that was taken happens with `zero` alone. */
bool ttc_flow_draw_parameters(const ttc_flow *flow, ulong *values, slong zero, uint64_t *source);

/** Draw a point. In/out: values, shape (variable_count,), has the parameters and receives the quantities. Out: logarithmic rates
 *  x'/x by quantity, shape (count,). Returns false if no point was found: in each attempt a radicand is zero or no square mod p, or
 *  a denominator is zero. */
bool ttc_flow_draw(const ttc_flow *flow, ulong *values, ulong *logarithmic, uint64_t *source);

/* Whether a ratio contains a quantity. */
bool ttc_flow_moves(const ttc_flow *flow, const ttc_ratio *a);
/* The degree of a polynomial of the ring in the quantities. */
int ttc_flow_degree(const ttc_flow *flow, const fmpz_mpoly_t a);

/* out = d log(a)/dt, exact. a is not zero. */
void ttc_flow_logarithmic_rate(const ttc_flow *flow, ttc_ratio *out, const ttc_ratio *a);

#endif
