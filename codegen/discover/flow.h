/** A model's motion as ratios, exact and at points of a prime field.
 *
 *  Quantities are what an ansatz is made of: every state, root and function of the table that moves. They are the variables and
 *  generators of the ring of the plain valuation under conditions on parameters, so that functions which depend on each other are
 *  known to. A point gives each of them a value other than 0, such that the square of each root is its radicand: it is a
 *  homomorphism of the ring into the field, defined where no denominator that is met vanishes. */
#ifndef TTC_FLOW_H
#define TTC_FLOW_H

#include "algebra/valuation.h"
#include "discover/modular.h"

typedef struct {
    const ttc_model *model;
    ttc_valuation *valuation;
    ttc_ring *ring;
    nmod_t mod;          /* of the largest prime, TTC_PRIME or below, at which points were found */
    size_t count;        /* quantities, roots last */
    slong *variables;    /* by quantity: its variable in the ring */
    int *degrees;        /* by quantity: 1; for a root such that the radicand has at most twice its degree */
    bool *is_root;       /* by quantity: its square is known, so that it has exponent 0 or 1 in an ansatz */
    bool is_graded;      /* every radicand is a polynomial in the quantities */
    ttc_ratio *slopes;   /* by variable of the ring: its rate; of roots as well */
    ttc_modular_ratio *rates; /* by quantity */
    ttc_ratio divergence;
    size_t parameter_count;
    slong *parameters;   /* variables of what neither moves nor is bound, and is no root */
    ttc_modular_ratio *squares; /* by generator of the ring */
} ttc_flow;

/** conditions: parameters set first; may be NULL. NULL, and *why: the motion is no ratio under them, for this reason. */
ttc_flow *ttc_flow_create(const ttc_model *model, const ttc_bindings *conditions, const char **why);
void ttc_flow_destroy(ttc_flow *flow); /* legal on NULL */

/** Take the largest prime field, of `prime` or a prime below, in which there are points: roots of numbers are in some fields only.
 *  False: it was not found. Values drawn before, and modular images of other ratios, are of no use then: see ttc_knowns_reduce. */
bool ttc_flow_take_prime(ttc_flow *flow, ulong prime);

/** Values of parameters, and of roots of them, into values, shape (ring->variable_count,). zero: a parameter's variable to
 *  be 0, or -1. False: roots of them were not found; of one that is not 0 in a field that was taken they are. */
bool ttc_flow_draw_parameters(const ttc_flow *flow, ulong *values, slong zero, uint64_t *source);

/** In/out: values, shape (variable_count,), with those of parameters; quantities are drawn. Out: logarithmic rates by quantity,
 *  shape (count,). False: no point was found, as a root is of no square mod p, or a denominator zero, wherever one looks. */
bool ttc_flow_draw(const ttc_flow *flow, ulong *values, ulong *logarithmic, uint64_t *source);

/* Whether a ratio changes along quantities. */
bool ttc_flow_moves(const ttc_flow *flow, const ttc_ratio *a);
/* The degree of a polynomial of the ring in the quantities. */
int ttc_flow_degree(const ttc_flow *flow, const fmpz_mpoly_t a);

/* out = d log(a)/dt, exact. a is not zero. */
void ttc_flow_logarithmic_rate(const ttc_flow *flow, ttc_ratio *out, const ttc_ratio *a);

#endif
