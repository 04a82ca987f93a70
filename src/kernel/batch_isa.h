/** Which of a descriptor's batched kernels this processor can run. */
#ifndef JLT_KERNEL_BATCH_ISA_H
#define JLT_KERNEL_BATCH_ISA_H

#include <stdbool.h>

#include "kernel_abi.h"

/** Whether the processor and the operating system support the instruction set of these kernels. */
bool jlt_batch_isa_runs(const jlt_kernel_batch *kernels);

/** Lanes of the widest instruction set that runs here, no more than JELLETT_LANES allows: 2, 4 or 8. */
unsigned jlt_batch_isa_lanes(void);

/** The widest batched kernels of a descriptor that run here with at most `lanes` lanes. lanes 0: the environment variable
 *  JELLETT_LANES (2, 4 or 8) gives the bound; where it is not set there is none. NULL: the descriptor has no such kernels,
 *  which cannot be for a built-in descriptor and lanes >= 2; one that was compiled for lanes has those of jlt_batch_isa_lanes. */
const jlt_kernel_batch *jlt_batch_isa_best(const jlt_descriptor *descriptor, unsigned lanes);

/** What these kernels take for p where all lanes have the prepared values p, shape (kernels->prepared,): shape (prepared, lanes),
 *  for the caller to free(). NULL: memory is out. */
double *jlt_batch_isa_spread(const jlt_kernel_batch *kernels, const double *p);

#endif
