/** Loads kernels at run time, from a shared object that `ttc build` has made of a table. */
#ifndef JLT_KERNEL_LOAD_H
#define JLT_KERNEL_LOAD_H

#include "core/status.h"
#include "kernel_abi.h"

/** Load an object. Out: *model, the general field of its first model; model->family lists the others. The object stays loaded
 *  until the program ends, since descriptors point into it.
 *  In: path, which must contain a slash. The object's code runs with the rights of this program: load only what you trust.
 *  Errors: ARG, no slash; IO, it cannot be loaded; UNSUPPORTED, it was built for another version of the kernel ABI. */
JLT_CHECKED jlt_status jlt_load(const jlt_descriptor **model, const char *path);

#endif
