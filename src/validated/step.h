/** One validated step of a flow with its variational equations.
 *
 *  The state's rough enclosure Y and remainder c_K(Y) h^K are those of rough.h. Of the derivative V' = Df V, V(0) = 1: with A the
 *  matrix of bounds of |Df(Y)|, |V - 1| <= e^(A h) - 1 entry by entry, as Picard's series of V is majorized by that of e^(A h).
 *  This is its rough enclosure W, and V_K(Y) W h^K its remainder.
 *
 *  The integral of the divergence is one more state. Conditions of the model are bounded from below over the whole step, in pieces,
 *  and those of its domain shown to be positive. */
#ifndef JLT_VALIDATED_STEP_H
#define JLT_VALIDATED_STEP_H

#include "validated/rough.h"
#include "validated/set.h"

#include <stdbool.h>

/** The accuracy for so many decimal digits of the result. */
jlt_rough_accuracy jlt_step_accuracy_for(unsigned digits);

typedef struct jlt_step jlt_step;

/** Out: *step, NULL on failure; destroy with jlt_step_destroy. In: of, borrowed; params, shape (of->params,), copied. Errors: as
 *  jlt_jets_create. */
JLT_CHECKED jlt_status jlt_step_create(jlt_step **step, const jlt_formulas *of, arb_srcptr params, jlt_rough_accuracy accuracy);
void jlt_step_destroy(jlt_step *step); /* legal on NULL */

/** Move the set by *h at most. In and out: *h, an exact positive number, the step's length; expansion, to which the integral of the
 *  divergence is added; least, shape (of->valid_count,), lower bounds of the conditions so far, NaN where one has no value.
 *  Errors: NO_PROGRESS, no step that was tried can be validated; DOMAIN, the set, which is moved all the same, may leave the
 *  table's domain. */
JLT_CHECKED jlt_status jlt_step_advance(jlt_step *self, jlt_set *set, arf_t h, arb_t expansion, arf_struct *least);

/** Evaluate field, its derivative, divergence and conditions over a box x, shape (dim,), by the program `variation`. */
void jlt_step_evaluate(jlt_step *self, arb_srcptr x);

/** Output `index` (formulas.h) over the box last evaluated, borrowed until the next evaluation. */
arb_srcptr jlt_step_output(const jlt_step *self, unsigned index);

/* Whether the box last evaluated lies in the table's domain. */
bool jlt_step_holds(const jlt_step *self);

/* Lower `least`, shape (valid_count,), to the conditions' bounds over the box last evaluated. */
void jlt_step_conditions(const jlt_step *self, arf_struct *least);

const jlt_formulas *jlt_step_formulas(const jlt_step *self);
slong jlt_step_bits(const jlt_step *self);

#endif
