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

/** The most special variant of a descriptor's model that serves these parameters: its substitutions leave them unchanged, and it
 *  has the most integrals, then the fewest operations. NULL when there is none in this time with this elimination.
 *  In: params, shape (params,) of the model. */
const jlt_descriptor *jlt_descriptor_choose(const jlt_descriptor *of, const char *time, const char *elimination,
                                            const double *params);

/** A claim of the model, by kind and name; NULL when its table makes none. */
const jlt_claim *jlt_descriptor_claim(const jlt_descriptor *of, const char *kind, const char *name);

/** The claims that kernels of a model rest on without a proof, all its descriptors taken together: "KIND NAME, ...", cut to
 *  `size` bytes. False, and "", when everything is proved. */
bool jlt_descriptor_unproved(char *claims, size_t size, const jlt_descriptor *of);

/* Position of a name; false when there is none. */
bool jlt_descriptor_state(const jlt_descriptor *descriptor, const char *name, size_t *index);
bool jlt_descriptor_param(const jlt_descriptor *descriptor, const char *name, size_t *index);

/** Check values against the table's domain: NONFINITE for NaN and infinities, DOMAIN outside (low, high), or [low, high)
 *  for a parameter that may vanish; *index then tells which. */
JLT_CHECKED jlt_status jlt_descriptor_check_state(const jlt_descriptor *descriptor, const double *x, size_t *index);
JLT_CHECKED jlt_status jlt_descriptor_check_params(const jlt_descriptor *descriptor, const double *params, size_t *index);

#endif
