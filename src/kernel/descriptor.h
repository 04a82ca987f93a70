/** Finding generated kernels by name, and reading what their descriptors say. */
#ifndef JLT_KERNEL_DESCRIPTOR_H
#define JLT_KERNEL_DESCRIPTOR_H

#include "core/status.h"
#include "kernel_abi.h"

#include <stdbool.h>

/* All descriptors built in: jlt_descriptor_at(i), 0 <= i < jlt_descriptor_count(); those of a model stand together, its
 * general field first. */
size_t jlt_descriptor_count(void);
const jlt_descriptor *jlt_descriptor_at(size_t index);

/** The descriptor with exactly these names; NULL stands for "". Returns NULL when there is none. */
const jlt_descriptor *jlt_descriptor_find(const char *model, const char *variant, const char *time,
                                          const char *elimination);

/** Another descriptor of the same model, with exactly these names; NULL stands for "". Returns NULL when there is none. */
const jlt_descriptor *jlt_descriptor_sibling(const jlt_descriptor *of, const char *variant, const char *time,
                                             const char *elimination);

/** The most special variant of a descriptor's model that holds for these parameters. A variant holds when what it substitutes
 *  leaves the parameters as they are; of those that hold, the one with the most integrals is taken, then the one with the
 *  fewest operations. NULL when there is none in this time with this elimination.
 *  In: params, shape (param_count,), of the model, in the table's units. */
const jlt_descriptor *jlt_descriptor_choose(const jlt_descriptor *of, const char *time, const char *elimination,
                                            const double *params);

/** How many operations one call of a kernel takes; a fused multiply-add is one. */
unsigned jlt_descriptor_operations(const jlt_operation_count *count);

/** A claim of the model, by kind and name; NULL when its table makes none. */
const jlt_claim *jlt_descriptor_claim(const jlt_descriptor *of, const char *kind, const char *name);

/** The first claim without a proof that the field itself rests on: of a root or a logarithm, or of its variant, time or
 *  elimination. NULL: none; what is said of the field, as integrals and equilibria are, may lack its proof all the same. */
const jlt_claim *jlt_descriptor_doubted_field(const jlt_descriptor *of);

/** Whether the table has poles and all are proved: a lifted root then keeps its digits, as orbits come to rest where it is zero. */
bool jlt_descriptor_has_poles(const jlt_descriptor *of);

/** The first of a descriptor's integrals that is not proved to be one; NULL: none. */
const jlt_claim *jlt_descriptor_doubted_integral(const jlt_descriptor *of);

/** Whether a field of the model, in some variant, has kernels of the integral of this name. */
bool jlt_descriptor_follows(const jlt_descriptor *of, const char *integral);

/** The claims that kernels of a model rest on without a proof, all its descriptors taken together: "KIND NAME, ...", cut to
 *  `size` bytes. False, and "", when everything is proved. */
bool jlt_descriptor_unproved(char *claims, size_t size, const jlt_descriptor *of);

/** Add the claim of this kind and name to a list of that form, unless it is proved or there already. */
void jlt_descriptor_add_unproved(char *claims, size_t size, const jlt_descriptor *of, const char *kind, const char *name);

/* The index of a state or parameter of this name; false when there is none, *index then stays. */
bool jlt_descriptor_state(const jlt_descriptor *descriptor, const char *name, size_t *index);
bool jlt_descriptor_param(const jlt_descriptor *descriptor, const char *name, size_t *index);

/** Check x, shape (state_count,), or params, shape (param_count,), against the table's domain. *index tells the first that
 *  fails.
 *  Errors: NONFINITE, a NaN or an infinity; DOMAIN, a state outside its open interval, or a parameter that breaks its sign
 *  condition. */
JLT_CHECKED jlt_status jlt_descriptor_check_state(const jlt_descriptor *descriptor, const double *x, size_t *index);
JLT_CHECKED jlt_status jlt_descriptor_check_params(const jlt_descriptor *descriptor, const double *params, size_t *index);

#endif
