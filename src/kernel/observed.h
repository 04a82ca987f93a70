/** Evaluates the quantities that a table declares by `observe`, and the conditions under which its model holds, by `valid`.
 *
 *  The caller passes states of any field of the model, in the units of its problem (kernel/units.h). They are converted to the
 *  table's units here; results are in the table's units. */
#ifndef JLT_KERNEL_OBSERVED_H
#define JLT_KERNEL_OBSERVED_H

#include "kernel/instance.h"

enum { JLT_OBSERVED_CONDITIONS_MAX = 256, JLT_OBSERVED_STATES_MAX = 256 }; /* bounds of a table, lifted roots included */

typedef struct jlt_observed jlt_observed;

/** Bind quantities and conditions to parameters. Out: *observed, NULL on failure; destroy it with jlt_observed_destroy. In: of, the
 *  descriptor of the states to be passed in, without an eliminated state; params, shape (param_count,), in the table's units;
 *  units, those of the states. Errors: as jlt_instance_create; UNSUPPORTED, too many states or conditions. */
JLT_CHECKED jlt_status jlt_observed_create(jlt_observed **observed, const jlt_descriptor *of, const double *params,
                                           const jlt_units *units);
void jlt_observed_destroy(jlt_observed *observed); /* legal on NULL */
JLT_OWNED_TYPE(jlt_observed)

/** The number of observed quantities, and their names, units and meanings, shape (count,). */
unsigned jlt_observed_count(const jlt_observed *observed);
const jlt_quantity *jlt_observed_quantities(const jlt_observed *observed);

/** Evaluate the observed quantities, values, shape (count,), at x, shape (states,); infinite or NaN for a quantity without a
 *  finite value there. Cost: one kernel; nothing is allocated. */
void jlt_observed_values(const jlt_observed *observed, double *values, const double *x);

/** The least value of the `valid` conditions at x, shape (states,): the model holds where it is positive. NaN if one has no value
 *  and the others are positive; INFINITY if there are no conditions. Out: *condition, unless NULL: the index of that condition;
 *  unchanged for INFINITY. */
double jlt_observed_least(const jlt_observed *observed, unsigned *condition, const double *x);

/** One condition, index < jlt_observed_conditions(): what events (integrate/event.h) have as context. */
typedef struct {
    const jlt_observed *observed;
    unsigned index;
} jlt_observed_one;

/** The value of a condition, a jlt_observed_one, at x, shape (states,). */
double jlt_observed_condition_value(void *condition, const double *x);

/** The same at 8 states at once, out (8,), x (states, 8) in memory aligned for vectors: by kernels on vectors where there are such
 *  and units need no conversion. */
void jlt_observed_condition_values(void *condition, double *out, const double *x);

/** The conditions on vectors, for callers whose states are in lanes: kernels with `valid_values`, which take states in the table's
 *  units and give values of shape (conditions,) in each lane. Returns NULL if there are no conditions, or the table has no kernels
 *  with exactly `lanes` lanes that run on this processor.
 *  Out: *p, shape (prepared,), the prepared values, to be spread over the lanes (jlt_batch_isa_spread); *exponents, shape
 *  (states,): multiply state i by 2^exponents[i] before the call; NULL: pass states as they are. */
const jlt_kernel_batch *jlt_observed_lanes(const jlt_observed *observed, const double **p, const int **exponents, unsigned lanes);

/** The number of conditions (0 for NULL), and the name of the condition with an index. JLT_OBSERVED_ANY stands for all of them
 *  together: its name is that of the only condition, or "valid" if there are several. */
enum { JLT_OBSERVED_ANY = JLT_OBSERVED_CONDITIONS_MAX };
unsigned jlt_observed_conditions(const jlt_observed *observed);
const char *jlt_observed_condition(const jlt_observed *observed, unsigned condition);

#endif
