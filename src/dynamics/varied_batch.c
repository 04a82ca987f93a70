#include "dynamics/varied_batch.h"

#include <string.h>

const jlt_varied_batch *jlt_varied_batch_find(const jlt_kernel_batch *kernels)
{
#if defined(JLT_HAVE_X86)
    if (strcmp(kernels->isa, "avx512") == 0) return &jlt_varied_batch_avx512;
    if (strcmp(kernels->isa, "avx2") == 0) return &jlt_varied_batch_avx2;
#else
    (void)kernels;
#endif
    return &jlt_varied_batch_baseline;
}
