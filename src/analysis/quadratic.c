#include "analysis/quadratic.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

typedef struct {
    double re[2], im[2], error[2];
} solution;

/* x*y + z*w with an error of at most two roundings of the larger product. */
static double sum_of_products(double x, double y, double z, double w)
{
    const double product = z * w, rounding = fma(z, w, -product);
    return fma(x, y, product) + rounding;
}

/* Whether a product of nonzero factors is so small that it, or its rounding error, leaves the normal range. */
static bool lost(double x, double y)
{
    return x != 0.0 && y != 0.0 && fabs(x * y) < 0x1p-960;
}

/* Solve for b, scaled so that the largest of |b11|, |b22|, |b12 b21|^(1/2) is of the order of 1, with errors e, scaled alike.
 * Returns false if a product in the determinant underflows and matters. In the discriminant, a product that underflows is added to
 * a number of the order of 1, or changes a root whose `middle` is of that order. */
static bool solve(solution *s, const double *b, const double *e)
{
    const double u = DBL_EPSILON / 2;
    const double middle = b[0] / 2 + b[3] / 2, half = b[0] / 2 - b[3] / 2;
    const double discriminant = sum_of_products(half, half, b[1], b[2]);
    const double middle_error = (e[0] + e[3]) / 2 + u * fabs(middle);
    const double discriminant_error = fabs(half) * (e[0] + e[3]) + fabs(b[2]) * e[1] + fabs(b[1]) * e[2] +
                                      (e[0] + e[3]) * (e[0] + e[3]) / 4 + e[1] * e[2] +
                                      2 * u * (half * half + fabs(b[1] * b[2]));
    const double root = sqrt(fabs(discriminant));
    const double root_error = fmin(discriminant_error / fmax(root, DBL_MIN), sqrt(discriminant_error)) + u * root;

    if (discriminant < 0) {
        for (int i = 0; i < 2; i++) {
            s->re[i] = middle;
            s->im[i] = i == 0 ? -root : root;
            s->error[i] = hypot(middle_error, root_error);
        }
        return true;
    }
    if ((lost(b[0], b[3]) || lost(b[1], b[2])) && fabs(b[0] * b[3]) < 0x1p-900 && fabs(b[1] * b[2]) < 0x1p-900)
        return false;
    const double larger = middle < 0 ? middle - root : middle + root;
    const double larger_error = middle_error + root_error + u * fabs(larger);
    const double determinant = sum_of_products(b[0], b[3], -b[1], b[2]);
    const double determinant_error = fabs(b[3]) * e[0] + fabs(b[0]) * e[3] + fabs(b[2]) * e[1] + fabs(b[1]) * e[2] +
                                     e[0] * e[3] + e[1] * e[2] + 2 * u * fabs(determinant);
    const double smaller = larger == 0.0 ? 0.0 : determinant / larger;
    const double least = fabs(larger) - larger_error;
    double smaller_error = fabs(larger) + fabs(smaller) + larger_error;
    if (least > 0.0)
        smaller_error = (determinant_error + fabs(smaller) * larger_error) / least + 2 * u * fabs(smaller);
    const int first = larger < smaller ? 0 : 1;
    s->re[first] = larger;
    s->error[first] = larger_error;
    s->re[1 - first] = smaller + 0.0;
    s->error[1 - first] = smaller_error;
    s->im[0] = s->im[1] = 0.0;
    return true;
}

/* *value *= 2^exponent. Returns false if a nonzero value leaves the normal range. */
static bool unscale(double *value, int exponent)
{
    const double scaled = *value;

    *value = ldexp(scaled, exponent);
    return scaled == 0.0 || isnormal(*value);
}

jlt_status jlt_quadratic_eigenvalues(double re[2], double im[2], double error[2], const double b[4],
                                     const double b_error[4])
{
    double scaled[4], errors[4];
    solution s;
    int up, down, shift = 0, exponent;

    for (int i = 0; i < 4; i++)
        if (!isfinite(b[i]) || !isfinite(b_error[i])) return JLT_ERR_NONFINITE;
    /* An exact diagonal similarity, by powers of two, balances the off-diagonal entries. */
    const double above = fmax(fabs(b[1]), b_error[1]), below = fmax(fabs(b[2]), b_error[2]);
    if (above > 0.0 && below > 0.0) {
        (void)frexp(above, &up);
        (void)frexp(below, &down);
        shift = (up - down) / 2;
    }
    scaled[0] = b[0], scaled[1] = ldexp(b[1], -shift), scaled[2] = ldexp(b[2], shift), scaled[3] = b[3];
    (void)frexp(fmax(fmax(fabs(scaled[0]), fabs(scaled[3])), fmax(fabs(scaled[1]), fabs(scaled[2]))), &exponent);
    if (above == 0.0 || below == 0.0) { /* triangular: the other off-diagonal entry does not matter */
        scaled[1] = scaled[2] = 0.0;
        (void)frexp(fmax(fabs(scaled[0]), fabs(scaled[3])), &exponent);
    }
    for (int i = 0; i < 4; i++) {
        scaled[i] = ldexp(scaled[i], -exponent);
        errors[i] = ldexp(b_error[i], i == 1 ? -shift - exponent : i == 2 ? shift - exponent : -exponent);
    }
    if (above == 0.0 || below == 0.0) errors[1] = errors[2] = 0.0;
    if (!solve(&s, scaled, errors)) return JLT_ERR_NONFINITE;
    for (int i = 0; i < 2; i++) {
        s.error[i] = ldexp(s.error[i], exponent);
        if (!unscale(&s.re[i], exponent) || !unscale(&s.im[i], exponent) || !isfinite(s.error[i])) return JLT_ERR_NONFINITE;
    }
    memcpy(re, s.re, sizeof s.re);
    memcpy(im, s.im, sizeof s.im);
    memcpy(error, s.error, sizeof s.error);
    return JLT_OK;
}
