/** Which of a descriptor's batched kernels this processor can run. */
#ifndef JLT_KERNEL_BATCH_ISA_H
#define JLT_KERNEL_BATCH_ISA_H

#include <stdbool.h>

#include "kernel_abi.h"

/** Whether the processor, and the operating system, run these kernels. */
bool jlt_batch_isa_runs(const jlt_kernel_batch *kernels);

/** The widest that runs with at most `lanes` lanes; never NULL for a generated descriptor and lanes >= 2. 0: the bound is that of
 *  the environment variable JELLETT_LANES (2, 4 or 8), or none. */
const jlt_kernel_batch *jlt_batch_isa_best(const jlt_descriptor *descriptor, unsigned lanes);

#endif
