/* Calls every kernel of one descriptor a few times, scalar or by one instruction set, for counting instructions from outside:
 * kernel_calls scalar|baseline|avx2. Exit status 77: the processor has not got it. */
#include <string.h>

#include "kernel_abi.h"

enum { CALLS = 10, STATES = 5, LANES_MAX = 4, SLOPES = 4 };

extern const jlt_descriptor jlt_kernels_spherical_top_level_general_in_regular;

static _Alignas(64) double x[STATES * 2 * LANES_MAX], k[(SLOPES + 1) * STATES * 2 * LANES_MAX], z[STATES * 2 * LANES_MAX],
    h[2 * LANES_MAX], out[64 * LANES_MAX];
static double block[256];
static _Alignas(64) double spread[256 * 2 * LANES_MAX]; /* the same in every lane of both vectors */

static void call_scalar(const jlt_descriptor *d)
{
    const jlt_kernel *kernels[] = { &d->rhs,        &d->jacobian,        &d->rhs_jacobian,
                                    &d->divergence, &d->integral_values, &d->integral_gradients };
    for (size_t i = 0; i < sizeof kernels / sizeof *kernels; i++) kernels[i]->call(x, block, out);
}

static void call_lanes(const jlt_kernel_batch *b)
{
    const jlt_kernel_lanes kernels[] = { b->rhs,        b->jacobian,        b->rhs_jacobian,
                                         b->divergence, b->integral_values, b->integral_gradients };
    const jlt_stage_sum sums[SLOPES] = { { 1, { 0 }, { 0.1 } },
                                         { 2, { 0, 1 }, { 0.1, 0.1 } },
                                         { 3, { 0, 1, 2 }, { 0.1, 0.1, 0.1 } },
                                         { 4, { 0, 1, 2, 3 }, { 0.1, 0.1, 0.1, 0.1 } } };
    for (size_t i = 0; i < sizeof kernels / sizeof *kernels; i++) kernels[i](x, spread, out, b->lanes);
    b->stages(x, k, sums, SLOPES, h, spread, z);
}

int main(int argc, char **argv)
{
    static const double point[STATES] = { -0.6, 0.4, 0.1, -0.2, 0.8 }, params[] = { 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51, -0.56 };
    const jlt_descriptor *d = &jlt_kernels_spherical_top_level_general_in_regular;
    const char *which = argc > 1 ? argv[1] : "";
    const jlt_kernel_batch *lanes = NULL;

    if (d->prepared_count > sizeof block / sizeof *block || d->state_count != STATES) return 1;
    d->prepare(params, block);
    for (size_t i = 0; i < JLT_ISA_COUNT; i++)
        if (d->batches[i] != NULL && strcmp(d->batches[i]->isa, which) == 0) lanes = d->batches[i];
    const size_t row = lanes == NULL ? 1 : lanes->lanes;
    if (row > LANES_MAX || (lanes == NULL && strcmp(which, "scalar") != 0)) return 2;
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (strcmp(which, "avx2") == 0 && !(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))) return 77;
#endif
    for (size_t i = 0; i < STATES; i++)
        for (size_t lane = 0; lane < row; lane++) x[i * row + lane] = point[i];
    for (size_t i = 0; i < 2 * (size_t)d->prepared_count * row; i++) spread[i] = block[i / row % d->prepared_count];
    for (int i = 0; i < CALLS; i++) {
        if (lanes == NULL) call_scalar(d);
        else call_lanes(lanes);
    }
    return 0;
}
