/** Tells which of a descriptor's batched kernels this processor can run. */
#ifndef JLT_KERNEL_BATCH_ISA_H
#define JLT_KERNEL_BATCH_ISA_H

#include <stdbool.h>

#include "kernel_abi.h"

/** Whether there are kernels, and the processor and the operating system support their instruction set. NULL: there are none. */
bool jlt_batch_isa_runs(const jlt_kernel_batch *kernels);

/** The number of lanes, 2, 4 or 8, of the widest instruction set that runs here and that JELLETT_LANES allows. */
unsigned jlt_batch_isa_lanes(void);

/** The widest batched kernels of a descriptor that run here with at most `lanes` lanes; lanes = 0 takes the bound from the
 *  environment variable JELLETT_LANES (2, 4 or 8; unset: no bound). Returns NULL if there are none. Built-in descriptors always
 *  have kernels of 2 lanes; those of `ttc build` have kernels only with `--lanes`, of one number of lanes. */
const jlt_kernel_batch *jlt_batch_isa_best(const jlt_descriptor *descriptor, unsigned lanes);

/** Replicate the prepared values p, shape (kernels->prepared,), to all lanes: the result, shape (prepared, lanes), is the argument
 *  p of these kernels. The caller frees it with free(). Returns NULL if memory is out. */
double *jlt_batch_isa_spread(const jlt_kernel_batch *kernels, const double *p);

#endif
