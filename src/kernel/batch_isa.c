#include "kernel/batch_isa.h"

#include <stdlib.h>
#include <string.h>

bool jlt_batch_isa_runs(const jlt_kernel_batch *kernels)
{
    if (strcmp(kernels->isa, "baseline") == 0) return true;
#if defined(JLT_HAVE_X86)
    __builtin_cpu_init();
    if (strcmp(kernels->isa, "avx2") == 0) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (strcmp(kernels->isa, "avx512") == 0)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
#endif
    return false;
}

const jlt_kernel_batch *jlt_batch_isa_best(const jlt_descriptor *descriptor, unsigned lanes)
{
    const char *wanted = getenv("JELLETT_LANES");

    if (lanes == 0 && wanted != NULL) lanes = strcmp(wanted, "2") == 0 ? 2 : strcmp(wanted, "4") == 0 ? 4 : 0;
    for (int i = JLT_ISA_COUNT - 1; i >= 0; i--) {
        const jlt_kernel_batch *kernels = descriptor->batches[i];
        if (kernels != NULL && (lanes == 0 || kernels->lanes <= lanes) && jlt_batch_isa_runs(kernels)) return kernels;
    }
    return NULL;
}
