/** Rough enclosures of solutions over a step, and its length.
 *
 *  With c_i the Taylor coefficients over the set X, and Z = sum_(i<K) [0,h]^i c_i(X) + [0,h]^K c_K(Y), Z within the interior of
 *  Y shows that solutions from X exist for all of [0,h] and stay in Z, as by Taylor's theorem none can reach the border of Y
 *  first (G. F. Corliss, R. Rihm, Validating an a priori enclosure using high-order Taylor series, 1996; Picard's iteration with
 *  inflation is K = 1). c_K(Y) h^K is then Lagrange's remainder.
 *
 *  Where starts are polynomials (jets.h), their coefficients are what the set and the enclosures hold: they solve an equation of
 *  their own, whose Taylor coefficients are those polynomials'. */
#ifndef JLT_VALIDATED_ROUGH_H
#define JLT_VALIDATED_ROUGH_H

#include "validated/jets.h"

#include <stdbool.h>

/* What only remainders are made of has so many bits: they are below the tolerance, so that their own digits do not matter. */
enum { JLT_ROUGH_REST_BITS = 64 };

typedef struct {
    unsigned order; /* >= 4 */
    slong bits;
    slong tolerance; /* remainders of a step are to be near 2^-tolerance */
} jlt_rough_accuracy;

typedef struct {
    const jlt_formulas *of;
    arb_srcptr params;
    jlt_rough_accuracy accuracy;
    unsigned terms;         /* of polynomials */
    jlt_jets *hull, *rough; /* over the set X, to be run by the caller; over y */
    arb_ptr y;              /* (dim, terms): rough enclosure */
    double caution;         /* by which steps are shorter than coefficients say */
} jlt_rough;

/** Set it up. In: program, of `of`; params, shape (of->params,), borrowed; degree, of polynomials. Ends with jlt_rough_clear, also
 *  on failure. Errors: as jlt_jets_create. */
JLT_CHECKED jlt_status jlt_rough_init(jlt_rough *self, const jlt_formulas *of, const ttc_program *program, arb_srcptr params,
                                      jlt_rough_accuracy accuracy, unsigned degree);
void jlt_rough_clear(jlt_rough *self); /* legal on a zeroed one */

/** Shorten h to the length over which the last two coefficients over the set, `hull`, reach the tolerance; in units of time. */
void jlt_rough_choose(const jlt_rough *self, arf_t h);

/** Make y such that the set spread over [0, h] lies within its interior; false when this h is too long. */
bool jlt_rough_enclose(jlt_rough *self, const arf_t h);

/** log2 of the largest remainder of a state over a step of this length, after jlt_rough_enclose. */
double jlt_rough_remainder(const jlt_rough *self, const arf_t h);

/** sum_(i<count) t^i a_i + t^count last */
void jlt_rough_sum(arb_t out, arb_srcptr a, unsigned count, const arb_t last, const arb_t t, slong bits);

#endif
