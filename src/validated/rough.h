/** Rough enclosures of solutions over a step, and the choice of its length.
 *
 *  With c_i the Taylor coefficients over the set X, let Z = sum_(i<K) [0,h]^i c_i(X) + [0,h]^K c_K(Y). If Z lies in the interior
 *  of Y, solutions from X exist on all of [0,h] and stay in Z, since by Taylor's theorem none can reach the boundary of Y first
 *  (G. F. Corliss, R. Rihm, Validating an a priori enclosure using high-order Taylor series, 1996; K = 1 is Picard iteration with
 *  inflation). c_K(Y) h^K is then Lagrange's remainder.
 *
 *  If starts are polynomials (jets.h), sets and enclosures contain their coefficients: these solve a differential equation of
 *  their own, whose Taylor coefficients are those of the polynomials. */
#ifndef JLT_VALIDATED_ROUGH_H
#define JLT_VALIDATED_ROUGH_H

#include "validated/jets.h"

#include <stdbool.h>

/* Precision of everything that only enters remainders: these are below the tolerance, so few digits of them matter. */
enum { JLT_ROUGH_REST_BITS = 64 };

typedef struct {
    unsigned order; /* >= 4 */
    slong bits;
    slong tolerance; /* remainders of a step should be about 2^-tolerance */
} jlt_rough_accuracy;

typedef struct {
    const jlt_formulas *of;
    arb_srcptr params;
    jlt_rough_accuracy accuracy;
    unsigned terms;         /* number of coefficients of a polynomial */
    jlt_jets *hull, *rough; /* jets over the set X, to be run by the caller; jets over y */
    arb_ptr y;              /* (dim, terms): the rough enclosure */
    double caution;         /* steps are this factor times what the coefficients suggest */
} jlt_rough;

/** Initialize. In: program, of `of`; params, shape (of->params,), borrowed; degree, of the polynomials. The caller must call
 *  jlt_rough_clear, even on failure. Errors: as jlt_jets_create. */
JLT_CHECKED jlt_status jlt_rough_init(jlt_rough *self, const jlt_formulas *of, const ttc_program *program, arb_srcptr params,
                                      jlt_rough_accuracy accuracy, unsigned degree);
void jlt_rough_clear(jlt_rough *self); /* legal when zeroed */

/** Shorten h to `caution` times the step at which the last two Taylor coefficients over the set, in `hull`, reach the tolerance. */
void jlt_rough_choose(const jlt_rough *self, arf_t h);

/** Shorten h until the step has a rough enclosure, and remainders not far above the tolerance; adapts `caution` for the next step.
 *  further: log2 of other remainders over the tolerated ones, once the step is enclosed; NULL: none. Returns false if no length is
 *  short enough. */
typedef double (*jlt_rough_excess)(void *context, const arf_t h);
bool jlt_rough_validate(jlt_rough *self, arf_t h, jlt_rough_excess further, void *context);

/** The time series, lowest order first, of coefficient i of `jets`, counted over the polynomials of all states. */
arb_srcptr jlt_rough_series(const jlt_rough *self, const jlt_jets *jets, unsigned i);

/** out = sum_(i<count) t^i a_i + t^count last. */
void jlt_rough_sum(arb_t out, arb_srcptr a, unsigned count, const arb_t last, const arb_t t, slong bits);

#endif
