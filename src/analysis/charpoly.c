#include "analysis/charpoly.h"

#include <complex.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { SIZE = JLT_CHARPOLY_SIZE_MAX };

int jlt_charpoly_exponent(const double *a, size_t count)
{
    double largest = 0.0;
    int exponent = 0;

    for (size_t i = 0; i < count; i++) largest = fmax(largest, fabs(a[i]));
    if (largest > 0.0) (void)frexp(largest, &exponent);
    return exponent;
}

/* product = left * right + diagonal * E */
static void step(double *product, const double *left, const double *right, double diagonal, size_t n)
{
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            double sum = i == j ? diagonal : 0.0;
            for (size_t k = 0; k < n; k++) sum += left[i * n + k] * right[k * n + j];
            product[i * n + j] = sum;
        }
}

/* trace(left * right) */
static double trace_of_product(const double *left, const double *right, size_t n)
{
    double sum = 0.0;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) sum += left[i * n + k] * right[k * n + i];
    return sum;
}

/* M_1 = E, c_k = sign tr(A M_k)/k, M_(k+1) = A M_k + c_k E. sign = -1 gives the characteristic polynomial; +1 adds all terms. */
static void recur(double *coefficients, const double *a, size_t n, double sign)
{
    double m[SIZE * SIZE], next[SIZE * SIZE];

    memset(m, 0, n * n * sizeof *m);
    for (size_t i = 0; i < n; i++) m[i * n + i] = 1.0;
    coefficients[0] = 1.0;
    for (size_t k = 1; k <= n; k++) {
        coefficients[k] = 0.0 + sign * trace_of_product(a, m, n) / (double)k;
        step(next, a, m, coefficients[k], n);
        memcpy(m, next, n * n * sizeof *m);
    }
}

/* values[k] *= 2^(k*exponent), k = 1 .. n. Returns false if a nonzero value leaves the normal range. */
static bool unscale(double *values, size_t n, int exponent)
{
    for (size_t k = 1; k <= n; k++) {
        if (values[k] == 0.0) continue;
        values[k] = ldexp(values[k], (int)k * exponent);
        if (!isnormal(values[k])) return false;
    }
    return true;
}

jlt_status jlt_charpoly_faddeev_leverrier(double *coefficients, double *scale, const double *a, const double *majorant,
                                          size_t n)
{
    double scaled[SIZE * SIZE], bound[SIZE * SIZE], result[SIZE + 1], sizes[SIZE + 1];
    int exponent;

    if (n == 0 || n > SIZE) return JLT_ERR_ARG;
    for (size_t i = 0; i < n * n; i++)
        if (!isfinite(a[i]) || (majorant != NULL && !isfinite(majorant[i]))) return JLT_ERR_NONFINITE;
    exponent = jlt_charpoly_exponent(a, n * n);
    for (size_t i = 0; i < n * n; i++) {
        scaled[i] = ldexp(a[i], -exponent);
        bound[i] = ldexp(majorant == NULL ? fabs(a[i]) : fmax(majorant[i], fabs(a[i])), -exponent);
    }
    recur(result, scaled, n, -1.0);
    if (!unscale(result, n, exponent)) return JLT_ERR_NONFINITE;
    if (scale != NULL) {
        recur(sizes, bound, n, 1.0);
        for (size_t k = 1; k <= n; k++) sizes[k] = ldexp(sizes[k], (int)k * exponent);
        memcpy(scale, sizes, (n + 1) * sizeof *scale);
    }
    memcpy(coefficients, result, (n + 1) * sizeof *coefficients);
    return JLT_OK;
}

jlt_status jlt_charpoly_from_roots(double *coefficients, double *scale, const double *re, const double *im, size_t n)
{
    double complex c[SIZE + 1] = { 1.0 };
    double sizes[SIZE + 1] = { 1.0 };
    double largest[2 * SIZE] = { 0 };
    int exponent;

    if (n > SIZE) return JLT_ERR_ARG;
    for (size_t i = 0; i < n; i++) {
        largest[2 * i] = re[i];
        largest[2 * i + 1] = im[i];
        if (!isfinite(re[i]) || !isfinite(im[i])) return JLT_ERR_NONFINITE;
    }
    exponent = jlt_charpoly_exponent(largest, 2 * n);
    for (size_t i = 0; i < n; i++) {
        const double complex root = ldexp(re[i], -exponent) + I * ldexp(im[i], -exponent);
        c[i + 1] = 0.0;
        sizes[i + 1] = 0.0;
        for (size_t k = i + 1; k > 0; k--) {
            c[k] -= root * c[k - 1];
            sizes[k] += cabs(root) * sizes[k - 1];
        }
    }
    for (size_t k = 0; k <= n; k++) {
        sizes[k] = ldexp(sizes[k], (int)k * exponent);
        if (!isfinite(sizes[k])) return JLT_ERR_NONFINITE;
    }
    for (size_t k = 0; k <= n; k++) coefficients[k] = ldexp(creal(c[k]), (int)k * exponent);
    if (scale != NULL) memcpy(scale, sizes, (n + 1) * sizeof *scale);
    return JLT_OK;
}

double jlt_charpoly_adjugate(double *adjugate, const double *a, size_t n, double re, double im)
{
    /* adj(z E - A) = sum of M_k z^(n-k), k = 1 .. n, by Horner's scheme. */
    double m[SIZE * SIZE], next[SIZE * SIZE], coefficient, sum = 0.0;
    double complex result[SIZE * SIZE];
    const double complex z = re + I * im;

    memset(m, 0, sizeof m);
    for (size_t i = 0; i < n; i++) m[i * n + i] = 1.0;
    for (size_t i = 0; i < n * n; i++) result[i] = 0.0;
    for (size_t k = 1; k <= n; k++) {
        for (size_t i = 0; i < n * n; i++) result[i] = result[i] * z + m[i];
        coefficient = -trace_of_product(a, m, n) / (double)k;
        step(next, a, m, coefficient, n);
        memcpy(m, next, n * n * sizeof *m);
    }
    for (size_t i = 0; i < n * n; i++) {
        if (adjugate != NULL) {
            adjugate[i] = creal(result[i]);
            adjugate[n * n + i] = cimag(result[i]);
        }
        sum += creal(result[i]) * creal(result[i]) + cimag(result[i]) * cimag(result[i]);
    }
    return sqrt(sum);
}
