/* Kernels of Lorenz's system without the library: the field, its Jacobian and a Taylor step. See tools/docs/kernels.md. */
#include "kernel_abi.h"
#include <stdio.h>

extern const jlt_descriptor jlt_kernels_lorenz_general;

int main(void)
{
    const jlt_descriptor *d = &jlt_kernels_lorenz_general;
    const double params[] = { 10, 28, 8. / 3 }, x[] = { 1, 2, 20 }, h = 0.01;
    double prepared[16], f[3], jacobian[9], series[21 * 3], sum[3] = { 0 };

    if (d->prepared_count > 16 || d->param_count != 3 || d->state_count != 3) return 1;
    d->prepare(params, prepared); /* once for each set of parameters */
    d->rhs.call(x, prepared, f);
    d->jacobian.call(x, prepared, jacobian);
    d->jet(x, prepared, 20, series);
    for (int k = 20; k >= 0; k--)
        for (int i = 0; i < 3; i++) sum[i] = sum[i] * h + series[3 * k + i];
    for (int i = 0; i < 3; i++)
        printf("d%s/dt = %.15g; its row of the Jacobian %g %g %g; at t = %g %s = %.15g\n", d->states[i].name, f[i],
               jacobian[3 * i], jacobian[3 * i + 1], jacobian[3 * i + 2], h, d->states[i].name, sum[i]);
    return 0;
}
