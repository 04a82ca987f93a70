#include "ext/eigen.h"

#include "core/guard.h"
#include "core/memory.h"
#include "ext/gsl.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_poly.h>

#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static jlt_status status_of(int gsl)
{
    if (gsl == GSL_SUCCESS) return JLT_OK;
    if (gsl == GSL_ENOMEM) return JLT_ERR_NOMEM;
    return gsl == GSL_EMAXITER || gsl == GSL_EFAILED ? JLT_ERR_NO_CONVERGENCE : JLT_ERR_NONFINITE;
}

static void swap(double *a, double *b)
{
    const double held = *a;

    *a = *b;
    *b = held;
}

void jlt_eigen_sort(double *re, double *im, double *error, size_t n)
{
    for (size_t i = 1; i < n; i++)
        for (size_t j = i; j > 0; j--) {
            if (re[j - 1] < re[j] || (!(re[j - 1] > re[j]) && im[j - 1] <= im[j])) break;
            swap(&re[j - 1], &re[j]);
            swap(&im[j - 1], &im[j]);
            if (error != NULL) swap(&error[j - 1], &error[j]);
        }
}

/* LAPACK has no header for C. The last two arguments are the lengths of the two words. */
extern void dgeev_(const char *left, const char *right, const int *n, double *a, const int *lda, double *re, double *im,
                   double *left_vectors, const int *ldvl, double *right_vectors, const int *ldvr, double *work, const int *lwork,
                   int *info, size_t left_length, size_t right_length);

jlt_status jlt_eigen_values(double *re, double *im, const double *a, size_t n)
{
    if (n == 0) return JLT_OK;
    if (n > INT_MAX / 3) return JLT_ERR_ARG;
    if (!jlt_guard_finite(a, n * n)) return JLT_ERR_NONFINITE;
    const int size = (int)n, length = 3 * size, one = 1;
    JLT_FREED double *held = malloc(n * n * sizeof *held), *work = malloc(3 * n * sizeof *work);
    double no_vectors = 0.0;
    int info;

    if (held == NULL || work == NULL) return JLT_ERR_NOMEM;
    memcpy(held, a, n * n * sizeof *a); /* LAPACK reads the transpose, whose eigenvalues are the same */
    dgeev_("N", "N", &size, held, &size, re, im, &no_vectors, &one, &no_vectors, &one, work, &length, &info, 1, 1);
    if (info != 0) return JLT_ERR_NO_CONVERGENCE;
    jlt_eigen_sort(re, im, NULL, n);
    return jlt_guard_finite(re, n) && jlt_guard_finite(im, n) ? JLT_OK : JLT_ERR_NONFINITE;
}

jlt_status jlt_eigen_balance(double *size, const double *a, size_t n)
{
    jlt_status st = JLT_OK;

    if (!jlt_guard_finite(a, n * n)) return JLT_ERR_NONFINITE;
    jlt_gsl_quiet();
    gsl_matrix *work = gsl_matrix_alloc(n, n);
    if (work == NULL) return JLT_ERR_NOMEM;
    memcpy(work->data, a, n * n * sizeof *a);
    gsl_vector_view sizes = gsl_vector_view_array(size, n);
    st = status_of(gsl_linalg_balance_matrix(work, &sizes.vector));
    gsl_matrix_free(work);
    return st;
}

jlt_status jlt_eigen_polynomial_roots(double *re, double *im, const double *coefficients, size_t n)
{
    jlt_status st = JLT_ERR_NOMEM;
    gsl_poly_complex_workspace *space = NULL;
    JLT_FREED double *ascending = NULL, *roots = NULL;

    if (n == 0) return JLT_OK;
    if (!jlt_guard_finite(coefficients, n + 1)) return JLT_ERR_NONFINITE;
    jlt_gsl_quiet();
    space = gsl_poly_complex_workspace_alloc(n + 1);
    ascending = calloc(n + 1, sizeof *ascending);
    roots = calloc(2 * n, sizeof *roots);
    if (space == NULL || ascending == NULL || roots == NULL) goto done;
    for (size_t i = 0; i <= n; i++) ascending[i] = coefficients[n - i];
    JLT_TRY(status_of(gsl_poly_complex_solve(ascending, n + 1, space, roots)));
    for (size_t i = 0; i < n; i++) {
        re[i] = roots[2 * i];
        im[i] = roots[2 * i + 1];
    }
    jlt_eigen_sort(re, im, NULL, n);
    if (!jlt_guard_finite(re, n) || !jlt_guard_finite(im, n)) st = JLT_ERR_NONFINITE;
done:
    gsl_poly_complex_workspace_free(space);
    return st;
}

typedef struct {
    gsl_matrix *u, *v; /* (rows or columns, whichever is more; columns) and (columns, columns) */
    gsl_vector *s;     /* (columns,), from the largest down */
} decomposition;

static void clear(decomposition *self)
{
    gsl_vector_free(self->s);
    gsl_matrix_free(self->v);
    gsl_matrix_free(self->u);
}

/* Whether the columns of u that are not 0 are orthogonal. */
static bool is_orthogonal(const gsl_matrix *u)
{
    const double allowed = 100 * (double)u->size1 * GSL_DBL_EPSILON;

    for (size_t j = 0; j < u->size2; j++)
        for (size_t k = 0; k < j; k++) {
            double product = 0.0;
            for (size_t i = 0; i < u->size1; i++) product += gsl_matrix_get(u, i, j) * gsl_matrix_get(u, i, k);
            if (fabs(product) > allowed) return false;
        }
    return true;
}

/* Decompose u by rotations of its columns, in place. GSL stops where its bounds of their errors have grown, which can leave columns
 * that are not orthogonal, and, with 24 columns or more, small singular values that are too large by any factor. Such columns are
 * decomposed again. */
static jlt_status rotate(decomposition *self)
{
    enum { TIMES = 50 };
    gsl_matrix *before = NULL, *product = NULL;
    jlt_status st = status_of(gsl_linalg_SV_decomp_jacobi(self->u, self->v, self->s));

    for (int i = 0; st == JLT_OK && !is_orthogonal(self->u); i++) {
        if (product == NULL) {
            before = gsl_matrix_alloc(self->v->size1, self->v->size2);
            product = gsl_matrix_alloc(self->v->size1, self->v->size2);
        }
        if (before == NULL || product == NULL) st = JLT_ERR_NOMEM;
        else if (i == TIMES) st = JLT_ERR_NO_CONVERGENCE;
        if (st != JLT_OK) break;
        gsl_matrix_memcpy(before, self->v);
        gsl_matrix_scale_columns(self->u, self->s);
        st = status_of(gsl_linalg_SV_decomp_jacobi(self->u, self->v, self->s));
        gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1.0, before, self->v, 0.0, product);
        gsl_matrix_memcpy(self->v, product);
    }
    gsl_matrix_free(product);
    gsl_matrix_free(before);
    return st;
}

/* Decompose a, shape (rows, columns), by its singular values. GSL needs rows >= columns: appended zero rows change neither these
 * nor the residual of a system, nor its shortest solution. On failure *out holds nothing. */
static jlt_status decompose(decomposition *out, const double *a, size_t rows, size_t columns)
{
    jlt_status st = JLT_ERR_NOMEM;

    jlt_gsl_quiet();
    *out = (decomposition){ gsl_matrix_calloc(rows > columns ? rows : columns, columns), gsl_matrix_alloc(columns, columns),
                            gsl_vector_alloc(columns) };
    if (out->u == NULL || out->v == NULL || out->s == NULL) goto done;
    memcpy(out->u->data, a, rows * columns * sizeof *a);
    st = rotate(out);
done:
    if (st != JLT_OK) clear(out);
    return st;
}

jlt_status jlt_eigen_least_squares(double *z, const double *a, const double *b, size_t rows, size_t columns, double cutoff)
{
    decomposition of_a;

    if (columns == 0) return JLT_OK;
    if (!jlt_guard_finite(a, rows * columns) || !jlt_guard_finite(b, rows)) return JLT_ERR_NONFINITE;
    JLT_PASS(decompose(&of_a, a, rows, columns));
    for (size_t j = 0; j < columns; j++) z[j] = 0.0;
    for (size_t k = 0; k < columns; k++) {
        const double singular = gsl_vector_get(of_a.s, k);
        double along = 0.0;
        if (!(singular > cutoff * gsl_vector_get(of_a.s, 0))) continue;
        for (size_t i = 0; i < rows; i++) along += gsl_matrix_get(of_a.u, i, k) * b[i];
        for (size_t j = 0; j < columns; j++) z[j] += gsl_matrix_get(of_a.v, j, k) * (along / singular);
    }
    clear(&of_a);
    return jlt_guard_finite(z, columns) ? JLT_OK : JLT_ERR_NONFINITE;
}

jlt_status jlt_eigen_norm(double *norm, const double *a, size_t n)
{
    decomposition of_a;

    if (!jlt_guard_finite(a, n * n)) return JLT_ERR_NONFINITE;
    JLT_PASS(decompose(&of_a, a, n, n));
    *norm = gsl_vector_get(of_a.s, 0);
    clear(&of_a);
    return JLT_OK;
}
