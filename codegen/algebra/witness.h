/** A real point of a ring, given by rational values of its free variables, and what is true there.
 *
 *  Roots, cosines and sines follow from the free variables. What is said of a point is certain: it is decided exactly, in
 *  rational numbers, where all that enters is rational, and else by balls that exclude zero. */
#ifndef TTC_WITNESS_H
#define TTC_WITNESS_H

#include "algebra/conditions.h"

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

typedef struct {
    ttc_valuation *valuation; /* borrowed */
    ttc_ring *ring;
    fmpq *values;      /* by variable; of free variables only */
    unsigned negative; /* bit i: generator i, which may have either sign, is negative */
    struct ttc_witness_balls *balls; /* values of all variables at the precision in use */
} ttc_witness;

typedef enum { TTC_HOLDS, TTC_FAILS, TTC_UNCLEAR } ttc_truth;

bool ttc_witness_init(ttc_witness *point, ttc_valuation *valuation); /* false: memory is out; clear it all the same */
void ttc_witness_clear(ttc_witness *point);

/* A variable that the point gives a value: no root, no function of others. */
bool ttc_witness_is_free(const ttc_witness *point, slong variable);

/* To be called after `values` or `negative` were changed: forgets what was computed from them. */
void ttc_witness_changed(ttc_witness *point);

/* FAILS if one condition fails, HOLDS if all hold, UNCLEAR otherwise. */
ttc_truth ttc_witness_meets_all(ttc_witness *point, const ttc_conditions *conditions);

/* Whether sines whose sign was chosen have that of their angle. */
ttc_truth ttc_witness_sines(ttc_witness *point);

/* Enclose a ratio; not finite where its denominator may be zero. */
void ttc_witness_enclose(arb_t out, ttc_witness *point, const ttc_ratio *ratio, slong precision);

/* The value of a variable; false where it is irrational. */
bool ttc_witness_coordinate(fmpq_t out, ttc_witness *point, slong variable);

/** The point as "NAME = VALUE, ..." over parameters, levels and states, for free(): rational numbers as they are, others as
 *  expressions in roots, which follow as "root1 = sqrt(2)". NULL when memory is out. */
char *ttc_witness_text(ttc_witness *point);

#endif
