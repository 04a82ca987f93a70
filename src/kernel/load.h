/** Kernels that were compiled after this program: a shared object as ttc build makes it. */
#ifndef JLT_KERNEL_LOAD_H
#define JLT_KERNEL_LOAD_H

#include "core/status.h"
#include "kernel_abi.h"

/** Load the object and give the general field of its first model, from which its family is reached. Objects stay loaded until the
 *  program ends, since descriptors point into them.
 *  path: absolute, or with a slash. What it holds runs as this program does: take it from whom you trust.
 *  Errors: IO, it cannot be loaded; UNSUPPORTED, it is of another version. */
JLT_CHECKED jlt_status jlt_load(const jlt_descriptor **model, const char *path);

#endif
