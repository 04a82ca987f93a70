/** Checked evaluation of generated kernels.
 *
 *  A kernel itself reports no errors. These functions require finite arguments, and treat an overflow, an underflow that loses
 *  digits, a division by zero or an invalid operation anywhere inside the kernel as an error, even if the result looks harmless.
 *  Step loops that need speed call kernels directly and test the results. */
#ifndef JLT_KERNEL_KERNEL_H
#define JLT_KERNEL_KERNEL_H

#include "core/status.h"
#include "kernel_abi.h"

/* The most outputs of a kernel that these functions evaluate; a kernel with more is UNSUPPORTED. */
enum { JLT_KERNEL_OUTPUTS_MAX = 4096 };

/** Evaluate one kernel.
 *  Out: out, shape (kernel->outputs,), untouched on failure.
 *  In:  x, shape (count,); prepared, as `prepare` filled it.
 *  Errors: UNSUPPORTED (no such kernel), NONFINITE (an argument or the result is not finite; overflow or underflow on the
 *          way), DOMAIN (a pole: division by zero, root of a negative number).
 *  Cost: the kernel, and about 0.2 us for the floating-point environment. */
JLT_CHECKED jlt_status jlt_kernel_eval(double *out, const jlt_kernel *kernel, const double *x, size_t count,
                                       const double *prepared);

/** Evaluate a kernel that takes unprepared parameters, such as those of a family of equilibria.
 *  Out: out, shape (outputs,), untouched on failure. In: x, shape (count,), NULL if it is not read; params, shape (param_count,).
 *  Errors: as jlt_kernel_eval. */
JLT_CHECKED jlt_status jlt_kernel_eval_function(double *out, jlt_kernel_function function, size_t outputs,
                                                const double *x, size_t count, const double *params, size_t param_count);

/** Compute the prepared values: what kernels need that depends on parameters alone.
 *  Out: prepared, shape (descriptor->prepared_count,), untouched on failure. In: params, shape (param_count,).
 *  Errors: UNSUPPORTED (no such kernel), NONFINITE (a parameter or result; overflow or underflow on the way), DOMAIN (division by
 *          zero, root of a negative number). */
JLT_CHECKED jlt_status jlt_kernel_prepare_params(double *prepared, const jlt_descriptor *descriptor, const double *params);

#endif
