/** A real point of a ring, given by rational values of its free variables, and rigorous evaluation of conditions at it.
 *
 *  Roots and functions follow from the free variables. If a zero level binds the cosine of an angle, the angle is known up to whole
 *  turns; it then *tells* the value of one variable in which it is linear. Signs are decided exactly if all values are rational,
 *  else by balls. */
#ifndef TTC_WITNESS_H
#define TTC_WITNESS_H

#include "algebra/conditions.h"

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

enum { TTC_WITNESS_WIDTH = -128 };

typedef struct {
    ttc_valuation *valuation; /* borrowed */
    ttc_ring *ring;
    fmpq *values;      /* by variable; used for free variables only */
    slong wide;        /* the variable that may differ from its value by 2^TTC_WITNESS_WIDTH; -1: none */
    unsigned negative; /* bit i: generator number i is negative, if it may have either sign */
    uint32_t *angles;  /* by variable: the bound cosine whose angle tells its value; 0: none */
    bool has_obscure_angle; /* a bound cosine has an angle that tells no variable: nothing is decided at a point then */
    struct ttc_witness_balls *balls; /* values of all variables at the precision in use */
} ttc_witness;

typedef enum { TTC_HOLDS, TTC_FAILS, TTC_UNCLEAR } ttc_truth;

bool ttc_witness_init(ttc_witness *point, ttc_valuation *valuation); /* false when memory is out; must be cleared even then */
void ttc_witness_clear(ttc_witness *point);

/* Returns true if `values` gives the variable's value: it is no generator, no function, and not told by an angle. */
bool ttc_witness_is_free(const ttc_witness *point, slong variable);

/* Returns true if the variable is a function whose value follows from its argument, or pi. */
bool ttc_witness_is_function(const ttc_witness *point, slong variable);

/* Discard computed values. Call this after changing `values`, `negative` or `wide`. */
void ttc_witness_changed(ttc_witness *point);

/* HOLDS if all conditions and the relations of the ring hold and bound symbols have values, FAILS if one is known to fail, UNCLEAR
 * otherwise. */
ttc_truth ttc_witness_meets_all(ttc_witness *point, const ttc_conditions *conditions);

/* Set `angles` and `has_obscure_angle`. An angle tells a state, parameter or level in which it is linear with a number as slope. */
void ttc_witness_find_angles(ttc_witness *point);

/* HOLDS if each sine whose sign ring->choices selects has, at this point, the sign of the sine of its angle. */
ttc_truth ttc_witness_sines(ttc_witness *point);

/* The angle that tells this variable is slope*variable + rest. */
void ttc_witness_split_angle(fmpq_t slope, ttc_ratio *rest, const ttc_witness *point, slong variable);

/* Add a multiple of a whole turn, 2 pi/|slope|, to the value of a state or parameter that an angle tells, so that it is the first
 * above the lower end of its interval or, if there is no lower end, the last below the upper one. Without such an end the value
 * stays as it is; where this precision cannot tell the number of turns it becomes not finite. */
void ttc_witness_add_turns(arb_t value, const fmpq_t slope, const ttc_model *model, size_t symbol, slong precision);

/* Enclose a ratio in a ball of `precision` bits, which is not finite if the denominator may be zero. */
void ttc_witness_enclose(arb_t out, ttc_witness *point, const ttc_ratio *ratio, slong precision);

/* The value of a variable. Returns false if it is not known to be rational. */
bool ttc_witness_coordinate(fmpq_t out, ttc_witness *point, slong variable);

/** The point as "NAME = VALUE, ..." over parameters, levels and states, for free(): rational numbers exactly, others as
 *  expressions in roots, which follow as "root[1] = sqrt(2)", or by their first digits. NULL when memory is out. */
char *ttc_witness_text(ttc_witness *point);

#endif
