#include "ext/arpack.h"

#include <arpack/arpack.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RESTARTS = 300 };

static void multiply(double *out, const double *a, const double *x, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        out[i] = 0.0;
        for (size_t j = 0; j < n; j++) out[i] += a[i * n + j] * x[j];
    }
}

jlt_status jlt_arpack_largest(double *re, double *im, size_t *found, const double *a, size_t n, size_t wanted)
{
    const a_int size = (a_int)n, ncv = (a_int)n, nev = (a_int)wanted, lworkl = 3 * ncv * ncv + 6 * ncv;
    a_int ido = 0, info = 1, iparam[11] = { 1, 0, RESTARTS, 1, 0, 0, 1, 0, 0, 0, 0 }, ipntr[14] = { 0 };
    a_int *select = NULL;
    double *residual = NULL, *basis = NULL, *workd = NULL, *workl = NULL, *workev = NULL;
    jlt_status st = JLT_ERR_NOMEM;

    if (n < 3 || n > 4096 || wanted < 1 || wanted > n - 2) return JLT_ERR_ARG;
    for (size_t i = 0; i < n * n; i++)
        if (!isfinite(a[i])) return JLT_ERR_NONFINITE;
    residual = calloc(n, sizeof *residual);
    basis = calloc(n * n, sizeof *basis);
    workd = calloc(3 * n, sizeof *workd);
    workl = calloc((size_t)lworkl, sizeof *workl);
    workev = calloc(3 * n, sizeof *workev);
    select = calloc(n, sizeof *select);
    if (residual == NULL || basis == NULL || workd == NULL || workl == NULL || workev == NULL || select == NULL) goto done;
    /* A fixed start makes the answer repeatable; irrational steps keep it out of invariant subspaces. */
    for (size_t i = 0; i < n; i++) residual[i] = 1.0 + 0.41421356237309503 * (double)i - 0.07 * (double)(i * i);

    for (;;) {
        dnaupd_c(&ido, "I", size, "LM", nev, 0.0, residual, ncv, basis, size, iparam, ipntr, workd, workl, lworkl, &info);
        if (ido != -1 && ido != 1) break;
        multiply(workd + ipntr[1] - 1, a, workd + ipntr[0] - 1, n);
    }
    st = JLT_ERR_NO_CONVERGENCE;
    if (info != 0) goto done;
    dneupd_c(0, "A", select, re, im, NULL, size, 0.0, 0.0, workev, "I", size, "LM", nev, 0.0, residual, ncv, basis, size,
             iparam, ipntr, workd, workl, lworkl, &info);
    if (info != 0) goto done;
    *found = (size_t)iparam[4];
    st = JLT_OK;
    for (size_t i = 0; i < *found; i++)
        if (!isfinite(re[i]) || !isfinite(im[i])) st = JLT_ERR_NONFINITE;
done:
    free(select);
    free(workev);
    free(workl);
    free(workd);
    free(basis);
    free(residual);
    return st;
}
