/** All descriptors, those of a model together, the general field of each first. Edited in codegen/runtime/; ttc writes copies. */
#ifndef JLT_REGISTRY_H
#define JLT_REGISTRY_H

#include "kernel_abi.h"

extern const jlt_descriptor *const jlt_registry[];
extern const unsigned jlt_registry_count;
extern const unsigned jlt_registry_entry_size; /* of a descriptor and of batched kernels, by which versions are told apart */

#endif
