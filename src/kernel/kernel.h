/** Checked evaluation of generated kernels.
 *
 *  A kernel itself reports nothing. Here its arguments must be finite, and an overflow, a lost underflow, a division by
 *  zero or an invalid operation anywhere inside it is an error, also where the result looks harmless. Step loops that need
 *  speed call kernels directly and test what they get. */
#ifndef JLT_KERNEL_KERNEL_H
#define JLT_KERNEL_KERNEL_H

#include "core/status.h"
#include "kernel_abi.h"

/* The most outputs of a kernel that is evaluated here; with more it is refused as UNSUPPORTED. */
enum { JLT_KERNEL_OUTPUTS_MAX = 4096 };

/** Evaluate one kernel.
 *  Out: out, shape (kernel->outputs,), untouched on failure.
 *  In:  x, shape (count,); prepared, as `prepare` filled it.
 *  Errors: UNSUPPORTED (no such kernel), NONFINITE (an argument or the result is not finite; overflow or underflow on the
 *          way), DOMAIN (a pole: division by zero, root of a negative number).
 *  Cost: the kernel, and about 0.2 us for the floating-point environment. */
JLT_CHECKED jlt_status jlt_kernel_eval(double *out, const jlt_kernel *kernel, const double *x, size_t count,
                                       const double *prepared);

/** The same for kernels on unprepared parameters, such as those of a family of equilibria.
 *  Out: out, shape (outputs,). In: x, shape (count,), NULL where the kernel does not read it; params, shape (param_count,).
 *  Errors: as jlt_kernel_eval. */
JLT_CHECKED jlt_status jlt_kernel_eval_function(double *out, jlt_kernel_function function, size_t outputs,
                                                const double *x, size_t count, const double *params, size_t param_count);

/** Compute what kernels need that depends on parameters alone.
 *  Out: prepared, shape (descriptor->prepared_count,), untouched on failure. In: params, shape (param_count,).
 *  Errors: UNSUPPORTED (no such kernel), NONFINITE (a parameter or result; overflow or underflow on the way), DOMAIN (division by
 *          zero, root of a negative number). */
JLT_CHECKED jlt_status jlt_kernel_prepare_params(double *prepared, const jlt_descriptor *descriptor, const double *params);

#endif
