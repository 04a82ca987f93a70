/** The conditions of a table's domain, from its records `domain` and what its equations divide by, at given values. Those that
 *  follow from intervals, signs and lifted roots are not among them: jlt_descriptor_check_state and jlt_descriptor_check_params
 *  stand for these. */
#ifndef JLT_KERNEL_REGION_H
#define JLT_KERNEL_REGION_H

#include <stdbool.h>

#include "core/status.h"
#include "kernel_abi.h"

/** Out: *region, the first that does not hold, with its value, which may be NaN; NULL when all hold. In: params, shape
 *  (param_count,); x, shape (state_count,), all in the table's units; x NULL: conditions on parameters alone. Errors: DOMAIN,
 *  one does not hold; NOMEM. */
JLT_CHECKED jlt_status jlt_region_check(const jlt_region **region, double *value, const jlt_descriptor *descriptor,
                                        const double *params, const double *x);

enum {
    JLT_REGION_CONDITIONS_MAX = 512, /* 256 records and the ends of 128 intervals */
    JLT_REGION_STATES_MAX = 256      /* as in a table, with lifted roots */
};

/** Whether such conditions hold, shape (count,), at x in the units that the prepared values p are for. values: their kernel;
 *  not called when count is 0. */
bool jlt_region_holds(unsigned count, jlt_kernel_function values, const double *p, const double *x);

/** Intervals of all states at given parameters: low and high, shape (state_count,). They are the table's, narrowed by every
 *  condition of the domain that bounds one state linearly, such as an end of an interval that is an expression of parameters. In:
 *  prepared, the values prepared from these parameters; NULL: conditions are left out. They are also left out for tables with more
 *  than 64 states or conditions. Cost: one evaluation of the conditions and two of their gradients. */
void jlt_region_intervals(double *low, double *high, const jlt_descriptor *descriptor, const double *prepared);

#endif
