/** What a table says to look at along orbits (`observe`), and where its model holds (`valid`).
 *
 *  Their kernels are those of the general field with all its states; what is asked are states of one field of the model in the same
 *  time, in units of a problem; they are evaluated, and what is told is, in the table's own. */
#ifndef JLT_KERNEL_OBSERVED_H
#define JLT_KERNEL_OBSERVED_H

#include <stdbool.h>

#include "kernel/instance.h"

enum { JLT_OBSERVED_CONDITIONS_MAX = 256, JLT_OBSERVED_STATES_MAX = 256 }; /* as in a table, with lifted roots */

typedef struct jlt_observed jlt_observed;

/** Out: *observed, NULL on failure, for jlt_observed_destroy. of: a descriptor of the model, without an eliminated state, whose
 *  states will be asked about; params, shape (param_count,) in its table's units. Errors: as jlt_instance_create. */
JLT_CHECKED jlt_status jlt_observed_create(jlt_observed **observed, const jlt_descriptor *of, const double *params,
                                           const jlt_units *units);
void jlt_observed_destroy(jlt_observed *observed); /* legal on NULL */

/** How many quantities are observed, and what they are, shape (count,). */
unsigned jlt_observed_count(const jlt_observed *observed);
const jlt_quantity *jlt_observed_quantities(const jlt_observed *observed);

/** Their values at x (states,), shape (count,); NaN where a pole leaves one open. Cost: that of the kernel, with memory for none. */
void jlt_observed_values(const jlt_observed *observed, double *values, const double *x);

/** The least value that `valid` conditions have at x: the model holds where it is positive. INFINITY: there are none, or none is
 *  known there. *condition, unless NULL, gets the index of the one that has it, or stays. */
double jlt_observed_least(const jlt_observed *observed, unsigned *condition, const double *x);

/** The value of one of these conditions. */
double jlt_observed_condition_value(const jlt_observed *observed, unsigned condition, const double *x);

/** How many there are, and what they are called: one by its index, ANY of several "valid". */
enum { JLT_OBSERVED_ANY = JLT_OBSERVED_CONDITIONS_MAX };
unsigned jlt_observed_conditions(const jlt_observed *observed);
const char *jlt_observed_condition(const jlt_observed *observed, unsigned condition);

#endif
