/** Finds generated kernels by name, and reads what their descriptors say. */
#ifndef JLT_KERNEL_DESCRIPTOR_H
#define JLT_KERNEL_DESCRIPTOR_H

#include "core/status.h"
#include "kernel_abi.h"

#include <stdbool.h>

/* The most states, parameters, integrals of a table: it has at most as many quantities, and as many claims. */
enum { JLT_DESCRIPTOR_VALUES_MAX = 4096 };

/* The built-in descriptors, 0 <= index < jlt_descriptor_count(); those of one model stand together, its general field first.
 * jlt_descriptor_at returns NULL beyond the last. */
size_t jlt_descriptor_count(void);
const jlt_descriptor *jlt_descriptor_at(size_t index);

/** The descriptor with exactly these names; NULL stands for "". Returns NULL when there is none. */
const jlt_descriptor *jlt_descriptor_find(const char *model, const char *variant, const char *time,
                                          const char *elimination);

/** Another descriptor of the same model, with exactly these names; NULL stands for "". Returns NULL when there is none. */
const jlt_descriptor *jlt_descriptor_sibling(const jlt_descriptor *of, const char *variant, const char *time,
                                             const char *elimination);

/** The most special variant of a descriptor's model that holds for these parameters, in this time and with this elimination; NULL
 *  if there is none. A variant holds if its substitutions leave the parameters unchanged. Of those that hold, the one with the
 *  most integrals is taken; among equals, the one with the fewest operations.
 *  In: params, shape (param_count,), of the model, in the table's units. */
const jlt_descriptor *jlt_descriptor_choose(const jlt_descriptor *of, const char *time, const char *elimination,
                                            const double *params);

/** The number of operations of one call of a kernel; a fused multiply-add counts as one. */
unsigned jlt_descriptor_operations(const jlt_operation_count *count);

/** The claim of the model with this kind and name; NULL if its table makes none. */
const jlt_claim *jlt_descriptor_claim(const jlt_descriptor *of, const char *kind, const char *name);

/** Whether the table makes this claim, and it is proved. */
bool jlt_descriptor_proves(const jlt_descriptor *of, const char *kind, const char *name);

/** The first unproved claim that the field itself rests on: that of a root, a logarithm, or of the field's variant, time or
 *  elimination. Returns NULL if there is none; claims about the field, such as integrals and equilibria, may still be unproved. */
const jlt_claim *jlt_descriptor_doubted_field(const jlt_descriptor *of);

/** Whether the table has poles and all of them are proved: orbits then come to rest where the lifted root is zero, so the root
 *  keeps its digits there. */
bool jlt_descriptor_has_poles(const jlt_descriptor *of);

/** The claim of the first of a descriptor's integrals that is not proved; NULL if all are proved. */
const jlt_claim *jlt_descriptor_doubted_integral(const jlt_descriptor *of);

/** Whether this field has kernels of the integral of this name; the general field has those of all that are claimed without `when`
 *  and `modulo`. */
bool jlt_descriptor_lists(const jlt_descriptor *of, const char *integral);

/** Whether some field of the model, in any variant, has kernels of the integral of this name. */
bool jlt_descriptor_follows(const jlt_descriptor *of, const char *integral);

/** List the unproved claims that kernels of a model rest on, over all its descriptors: "KIND NAME, ...", cut to `size` bytes.
 *  Returns false, with an empty list, if everything is proved. */
bool jlt_descriptor_unproved(char *claims, size_t size, const jlt_descriptor *of);

/** Append the claim of this kind and name to such a list, if the table makes it, and it is neither proved nor listed yet. */
void jlt_descriptor_add_unproved(char *claims, size_t size, const jlt_descriptor *of, const char *kind, const char *name);

/** The end of a pole's interval that is nearest to the state x of a field of the table, in the table's units: +1 the upper, -1 the
 *  lower one, of state number *state; 0: the table names no poles. */
int jlt_descriptor_pole_side(unsigned *state, const jlt_descriptor *of, const double *x);

/** The condition on a parameter's sign, " > 0" and the like; "" if it may have any value. */
const char *jlt_descriptor_condition(const jlt_quantity *param);

/** Whether the parameter may have this finite value. */
bool jlt_descriptor_allows(const jlt_quantity *param, double value);

/* Find the state or parameter of this name. Returns false, and leaves *index, if there is none. */
bool jlt_descriptor_state(const jlt_descriptor *descriptor, const char *name, size_t *index);
bool jlt_descriptor_param(const jlt_descriptor *descriptor, const char *name, size_t *index);

/** Check x, shape (state_count,), or params, shape (param_count,), against the table's domain: finite, states in their open
 *  intervals, parameters of their signs. On failure *index is the first offender.
 *  Errors: ARG, no descriptor; NONFINITE, a NaN or an infinity; DOMAIN, a state outside its interval, or a parameter of the wrong
 *  sign. */
JLT_CHECKED jlt_status jlt_descriptor_check_state(const jlt_descriptor *descriptor, const double *x, size_t *index);
JLT_CHECKED jlt_status jlt_descriptor_check_params(const jlt_descriptor *descriptor, const double *params, size_t *index);

#endif
