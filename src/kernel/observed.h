/** Quantities that a table asks to be watched along orbits (`observe`), and conditions under which its model holds (`valid`).
 *
 *  The caller has states of some field of the model, in units of a problem (kernel/units.h). They are converted to the
 *  table's units here; values come out in the table's units. */
#ifndef JLT_KERNEL_OBSERVED_H
#define JLT_KERNEL_OBSERVED_H

#include <stdbool.h>

#include "kernel/instance.h"

enum { JLT_OBSERVED_CONDITIONS_MAX = 256, JLT_OBSERVED_STATES_MAX = 256 }; /* as in a table, with lifted roots */

typedef struct jlt_observed jlt_observed;

/** Bind the observed quantities and conditions to parameters. Out: *observed, NULL on failure; destroy with jlt_observed_destroy.
 *  In: of, the descriptor whose states will be passed in, without an eliminated state; params, shape (param_count,), in the
 *  table's units; units, those of the states. Errors: as jlt_instance_create. */
JLT_CHECKED jlt_status jlt_observed_create(jlt_observed **observed, const jlt_descriptor *of, const double *params,
                                           const jlt_units *units);
void jlt_observed_destroy(jlt_observed *observed); /* legal on NULL */

/** How many quantities are observed, and their names, units and meanings, shape (count,). */
unsigned jlt_observed_count(const jlt_observed *observed);
const jlt_quantity *jlt_observed_quantities(const jlt_observed *observed);

/** Their values, shape (count,), at x, shape (states,); NaN for one that has no finite value there. Cost: one kernel; nothing
 *  is allocated. */
void jlt_observed_values(const jlt_observed *observed, double *values, const double *x);

/** The least of the values that the `valid` conditions have at x, shape (states,): the model holds where it is positive. NaN where
 *  none is broken and one has no value, so that nobody knows; INFINITY when there are no conditions. Out: *condition, unless NULL:
 *  the index of the condition that this is the value of; it stays as it is when the result is INFINITY. */
double jlt_observed_least(const jlt_observed *observed, unsigned *condition, const double *x);

/** The value of one of these conditions at x; the index must be below jlt_observed_conditions. */
double jlt_observed_condition_value(const jlt_observed *observed, unsigned condition, const double *x);

/** The conditions on vectors, for callers that have states in lanes: kernels with `valid_values`, of states in the table's units,
 *  whose values have shape (conditions,). Returns NULL when there are no conditions, or the table has no kernels with so many lanes
 *  that the processor runs.
 *  Out: *p, prepared values for them; *exponents, shape (states,): multiply state i by 2^exponents[i] before the call; NULL: take
 *       states as they are. */
const jlt_kernel_batch *jlt_observed_lanes(const jlt_observed *observed, const double **p, const int **exponents, unsigned lanes);

/** How many conditions there are, and the name of one by its index. JLT_OBSERVED_ANY stands for all of them together: its name
 *  is that of the only condition, or "valid" when there are several. */
enum { JLT_OBSERVED_ANY = JLT_OBSERVED_CONDITIONS_MAX };
unsigned jlt_observed_conditions(const jlt_observed *observed);
const char *jlt_observed_condition(const jlt_observed *observed, unsigned condition);

#endif
