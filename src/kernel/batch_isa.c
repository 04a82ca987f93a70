#include "kernel/batch_isa.h"

#include <stdlib.h>
#include <string.h>

#include "core/memory.h"

static bool runs(unsigned lanes)
{
    if (lanes == 2) return true;
#if defined(JLT_HAVE_X86)
    __builtin_cpu_init();
    if (lanes == 4) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (lanes == 8)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
#endif
    return false;
}

static unsigned bound(void)
{
    const char *wanted = getenv("JELLETT_LANES");

    return wanted != NULL && strcmp(wanted, "2") == 0 ? 2 : wanted != NULL && strcmp(wanted, "4") == 0 ? 4 : 8;
}

bool jlt_batch_isa_runs(const jlt_kernel_batch *kernels) { return kernels != NULL && runs(kernels->lanes); }

unsigned jlt_batch_isa_lanes(void)
{
    unsigned lanes = bound();

    while (!runs(lanes)) lanes /= 2;
    return lanes;
}

const jlt_kernel_batch *jlt_batch_isa_best(const jlt_descriptor *descriptor, unsigned lanes)
{
    if (lanes == 0) lanes = bound();
    for (int i = JLT_ISA_COUNT - 1; i >= 0; i--) {
        const jlt_kernel_batch *kernels = descriptor->batches[i];
        if (jlt_batch_isa_runs(kernels) && kernels->lanes <= lanes) return kernels;
    }
    return NULL;
}

double *jlt_batch_isa_spread(const jlt_kernel_batch *kernels, const double *p)
{
    double *block = jlt_memory_array((size_t)kernels->prepared * kernels->lanes, sizeof *block);

    for (size_t i = 0; block != NULL && i < kernels->prepared; i++)
        for (unsigned lane = 0; lane < kernels->lanes; lane++) block[i * kernels->lanes + lane] = p[i];
    return block;
}
