/** One validated step of a flow with its variational equations.
 *
 *  The state's rough enclosure Y and remainder c_K(Y) h^K are those of rough.h. For the derivative, V' = Df V, V(0) = 1: with A
 *  the matrix of bounds of |Df(Y)|, |V - 1| <= e^(A h) - 1 holds entry by entry, since the Picard series of V is majorized by that
 *  of e^(A h). So |V| <= e^(A h), and the remainder is at most W_K e^(A h) h^K: W_K bounds the Taylor coefficient of order K over
 *  Y, and is computed from bounds of the coefficients of Df(Y).
 *
 *  The integral of the divergence is one more state. The conditions of the model are bounded from below over the whole step, piece
 *  by piece, and those of its domain are proved to be positive. */
#ifndef JLT_VALIDATED_STEP_H
#define JLT_VALIDATED_STEP_H

#include "validated/rough.h"
#include "validated/set.h"

#include <stdbool.h>

/** The accuracy that gives results of so many decimal digits. */
jlt_rough_accuracy jlt_step_accuracy_for(unsigned digits);

typedef struct jlt_step jlt_step;

/** `told` is called after each step with the number of steps so far; for several proofs, that of all. */
typedef struct {
    void (*told)(void *context, size_t steps);
    void *context;
    size_t steps;
} jlt_step_watch;

/** Out: *step, NULL on failure; destroy it with jlt_step_destroy. In: of, borrowed; params, shape (of->params,), copied; watch,
 *  borrowed, may be NULL. Errors: as jlt_jets_create. */
JLT_CHECKED jlt_status jlt_step_create(jlt_step **step, const jlt_formulas *of, arb_srcptr params, jlt_rough_accuracy accuracy,
                                       jlt_step_watch *watch);
void jlt_step_destroy(jlt_step *step); /* legal on NULL */
JLT_OWNED_TYPE(jlt_step)

/** Move the set by one step. In/out: h, exact and positive, on input the largest length, on output the length of the step;
 *  expansion, to which the integral of the divergence is added; least, shape (of->valid_count,), lower bounds of the conditions so
 *  far, NaN for a condition without a value.
 *  Errors: NO_PROGRESS, no step that was tried can be validated; DOMAIN, the set, which is moved nevertheless, may leave the
 *  table's domain. */
JLT_CHECKED jlt_status jlt_step_advance(jlt_step *self, jlt_set *set, arf_t h, arb_t expansion, arf_struct *least);

/** Evaluate the field, its derivative, divergence and conditions over a box x, shape (dim,), with the program `variation`. */
void jlt_step_evaluate(jlt_step *self, arb_srcptr x);

/** Output `index` (formulas.h) over the box last evaluated; borrowed until the next evaluation. */
arb_srcptr jlt_step_output(const jlt_step *self, unsigned index);

/* Whether the box last evaluated is proved to lie in the table's domain. */
bool jlt_step_holds(const jlt_step *self);

/* Lower `least`, shape (valid_count,), to the lower bounds of the conditions over the box last evaluated. */
void jlt_step_conditions(const jlt_step *self, arf_struct *least);

/* Lower `least`, shape (count,), to those of `other` that are below it, or NaN. */
void jlt_step_lower(arf_struct *least, const arf_struct *other, unsigned count);

const jlt_formulas *jlt_step_formulas(const jlt_step *self);
slong jlt_step_bits(const jlt_step *self);

#endif
