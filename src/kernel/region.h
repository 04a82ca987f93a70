/** Checks the conditions of a table's domain at given values: those of its `domain` records, and that no divisor of its equations
 *  is 0. Intervals, signs and lifted roots are left to jlt_descriptor_check_state and jlt_descriptor_check_params. */
#ifndef JLT_KERNEL_REGION_H
#define JLT_KERNEL_REGION_H

#include <stdbool.h>

#include "core/status.h"
#include "kernel_abi.h"

/** Find the first condition that does not hold. Out: *region, that condition, and *value, its value, which may be NaN; *region is
 *  NULL if all hold. In: params, shape (param_count,); x, shape (state_count,), both in the table's units; if x is NULL, only
 *  conditions on parameters alone are checked. Errors: DOMAIN, a condition does not hold; NOMEM. */
JLT_CHECKED jlt_status jlt_region_check(const jlt_region **region, double *value, const jlt_descriptor *descriptor,
                                        const double *params, const double *x);

enum {
    JLT_REGION_CONDITIONS_MAX = 512, /* 256 records and the ends of 128 intervals */
    JLT_REGION_STATES_MAX = 256      /* as in a table, with lifted roots */
};

/** Whether all `count` conditions that the kernel `values` evaluates are positive at x; p are prepared values, in the units of x.
 *  The kernel is not called if count is 0. */
bool jlt_region_holds(unsigned count, jlt_kernel_function values, const double *p, const double *x);

/** The interval of every state at given parameters: low and high, shape (state_count,). These are the table's intervals, narrowed
 *  by every condition of the domain that is linear in one state and contains no other, such as an interval's end that is an
 *  expression of parameters. In: prepared, the values prepared from these parameters. If it is NULL, or the table has more than 64
 *  states or conditions, conditions are ignored. Cost: one evaluation of the conditions and two of their gradients. */
void jlt_region_intervals(double *low, double *high, const jlt_descriptor *descriptor, const double *prepared);

#endif
