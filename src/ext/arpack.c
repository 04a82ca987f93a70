#include "ext/arpack.h"

#include "core/guard.h"

#include <arpack/arpack.h>

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RESTARTS = 300 };

typedef struct {
    double *residual, *basis, *workd, *workl, *workev;
    a_int *select;
} workspace;

static void clear(workspace *w)
{
    free(w->residual);
    free(w->basis);
    free(w->workd);
    free(w->workl);
    free(w->workev);
    free(w->select);
}

static jlt_status allocate(workspace *w, size_t n, size_t space, size_t lworkl)
{
    w->residual = calloc(n, sizeof *w->residual);
    w->basis = calloc(n * space, sizeof *w->basis);
    w->workd = calloc(3 * n, sizeof *w->workd);
    w->workl = calloc(lworkl, sizeof *w->workl);
    w->workev = calloc(3 * space, sizeof *w->workev);
    w->select = calloc(space, sizeof *w->select);
    return w->residual == NULL || w->basis == NULL || w->workd == NULL || w->workl == NULL || w->workev == NULL || w->select == NULL
               ? JLT_ERR_NOMEM
               : JLT_OK;
}

jlt_status jlt_arpack_leading(double *re, double *im, size_t *found, double *vectors, const jlt_arpack_matrix *matrix,
                              const jlt_arpack_options *options)
{
    const size_t n = matrix->n, space = options->space, wanted = options->wanted;
    a_int ido = 0, info = 1, iparam[11] = { 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0 }, ipntr[14] = { 0 };
    workspace w = { 0 };
    jlt_status st;

    if (n < 3 || n > INT_MAX || wanted < 1 || wanted > n - 2 || space < wanted + 2 || space > n || space > 4096 ||
        options->restarts > INT_MAX)
        return JLT_ERR_ARG;
    const a_int size = (a_int)n, ncv = (a_int)space, nev = (a_int)wanted, lworkl = 3 * ncv * ncv + 6 * ncv;
    iparam[2] = (a_int)options->restarts;
    if ((st = allocate(&w, n, space, (size_t)lworkl)) != JLT_OK) goto done;
    memcpy(w.residual, options->start, n * sizeof *w.residual);
    for (;;) {
        dnaupd_c(&ido, "I", size, "LM", nev, options->tolerance, w.residual, ncv, w.basis, size, iparam, ipntr, w.workd, w.workl,
                 lworkl,
                 &info);
        if (ido != -1 && ido != 1) break;
        if (matrix->apply(matrix->context, w.workd + ipntr[1] - 1, w.workd + ipntr[0] - 1) != 0) {
            st = JLT_ERR_NO_CONVERGENCE;
            goto done;
        }
    }
    st = JLT_ERR_NO_CONVERGENCE;
    if (info != 0) goto done;
    dneupd_c(vectors != NULL, "A", w.select, re, im, vectors, size, 0.0, 0.0, w.workev, "I", size, "LM", nev, options->tolerance,
             w.residual, ncv,
             w.basis, size, iparam, ipntr, w.workd, w.workl, lworkl, &info);
    if (info != 0) goto done;
    *found = (size_t)iparam[4];
    st = JLT_OK;
    for (size_t i = 0; i < *found; i++)
        if (!isfinite(re[i]) || !isfinite(im[i])) st = JLT_ERR_NONFINITE;
done:
    clear(&w);
    return st;
}

typedef struct {
    const double *a;
    size_t n;
} dense;

static int multiply(void *context, double *out, const double *x)
{
    const dense *m = context;

    for (size_t i = 0; i < m->n; i++) {
        out[i] = 0.0;
        for (size_t j = 0; j < m->n; j++) out[i] += m->a[i * m->n + j] * x[j];
    }
    return 0;
}

jlt_status jlt_arpack_largest(double *re, double *im, size_t *found, const double *a, size_t n, size_t wanted)
{
    dense m = { a, n };
    double *start;
    jlt_status st;

    if (n < 3 || n > 4096 || wanted < 1 || wanted > n - 2) return JLT_ERR_ARG;
    if (!jlt_guard_finite(a, n * n)) return JLT_ERR_NONFINITE;
    if ((start = calloc(n, sizeof *start)) == NULL) return JLT_ERR_NOMEM;
    /* A fixed start makes the answer repeatable; irrational steps keep it out of invariant subspaces. */
    for (size_t i = 0; i < n; i++) start[i] = 1.0 + 0.41421356237309503 * (double)i - 0.07 * (double)(i * i);
    st = jlt_arpack_leading(re, im, found, NULL, &(jlt_arpack_matrix){ n, multiply, &m },
                            &(jlt_arpack_options){ .wanted = wanted, .space = n, .restarts = RESTARTS, .start = start });
    free(start);
    return st;
}
