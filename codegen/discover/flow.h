/** A model's equations of motion as ratios, exact and at points of a prime field.
 *
 *  Quantities are what monomials of an ansatz are made of: every state, root and function of the table that changes along the
 *  motion. They are variables and generators of the ring of the plain valuation under conditions on parameters, which knows
 *  relations between functions. A point gives each a nonzero value, such that the square of each root is its radicand: a
 *  homomorphism of the ring into the field, defined where no denominator that occurs vanishes. Below, and wherever points are
 *  drawn, source is the state of the random numbers. */
#ifndef TTC_FLOW_H
#define TTC_FLOW_H

#include "algebra/valuation.h"
#include "discover/modular.h"

typedef struct {
    const ttc_model *model;
    ttc_valuation *valuation;
    ttc_ring *ring;
    nmod_t mod;          /* of the largest prime, at most TTC_PRIME, with points */
    size_t count;        /* quantities, roots last */
    slong *variables;    /* by quantity: its variable in the ring */
    int *degrees;        /* by quantity: 1; for a root at least half the degree of its radicand */
    bool *is_root;       /* by quantity: its square is known, so it has exponent 0 or 1 in an ansatz */
    bool is_graded;      /* every radicand is a polynomial in the quantities */
    ttc_ratio *slopes;   /* by variable of the ring, roots included: its rate */
    ttc_modular_ratio *rates; /* by quantity: the image of its rate */
    ttc_ratio divergence;
    size_t parameter_count;
    slong *parameters;   /* variables that are constant, not bound, and no roots */
    ttc_modular_ratio *squares; /* by generator of the ring: the image of its square */
} ttc_flow;

/** conditions: parameters that are set first; may be NULL. Returns NULL, and *why, if the equations of motion are no ratios under
 *  them, or have no points. */
ttc_flow *ttc_flow_create(const ttc_model *model, const ttc_bindings *conditions, const char **why);
void ttc_flow_destroy(ttc_flow *flow); /* legal on NULL */

/** Take the largest prime field, of `prime` or a prime below, in which there are points: some fields lack roots of numbers.
 *  Returns false if none was found. Values drawn before, and modular images of other ratios, are then invalid: see
 *  ttc_knowns_reduce. */
bool ttc_flow_take_prime(ttc_flow *flow, ulong prime);

/** Draw values of the parameters, and of their roots, into values, shape (ring->variable_count,). zero: the variable of a
 *  parameter that is set to 0, or -1. Returns false if roots were not found; with zero = -1 they are, in a field that was taken. */
bool ttc_flow_draw_parameters(const ttc_flow *flow, ulong *values, slong zero, uint64_t *source);

/** Draw a point. In/out: values, shape (variable_count,), with those of parameters; quantities are drawn. Out: logarithmic rates
 *  by quantity, shape (count,). Returns false if in each attempt a radicand was zero or no square mod p, or a denominator zero. */
bool ttc_flow_draw(const ttc_flow *flow, ulong *values, ulong *logarithmic, uint64_t *source);

/* Whether a ratio contains a quantity. */
bool ttc_flow_moves(const ttc_flow *flow, const ttc_ratio *a);
/* The degree of a polynomial of the ring in the quantities. */
int ttc_flow_degree(const ttc_flow *flow, const fmpz_mpoly_t a);

/* out = d log(a)/dt, exact. a is not zero. */
void ttc_flow_logarithmic_rate(const ttc_flow *flow, ttc_ratio *out, const ttc_ratio *a);

#endif
