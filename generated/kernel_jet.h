/** Coefficients of order k of products, quotients, roots, cosines and sines of power series whose operands are known to
 *  order k, and whose result is known below k. Cost: k + 1 products. Written by ttc; do not edit. */
#ifndef JLT_JET_H
#define JLT_JET_H

#include <math.h>

static inline double jlt_jet_product(const double *a, const double *b, unsigned k)
{
    double sum = a[0] * b[k];
    for (unsigned j = 1; j <= k; j++) sum += a[j] * b[k - j];
    return sum;
}

/* q = a/b; a is coefficient k of the numerator. */
static inline double jlt_jet_quotient(double a, const double *b, const double *q, unsigned k)
{
    for (unsigned j = 1; j <= k; j++) a -= b[j] * q[k - j];
    return a / b[0];
}

/* r = sqrt(a); a is coefficient k of the radicand. */
static inline double jlt_jet_root(double a, const double *r, unsigned k)
{
    if (k == 0) return sqrt(a);
    for (unsigned j = 1; j < k; j++) a -= r[j] * r[k - j];
    return a / (2 * r[0]);
}

/* sum over j of j a_j b_(k-j), over k */
static inline double jlt_jet_slope(const double *a, const double *b, unsigned k)
{
    double sum = 0;
    for (unsigned j = 1; j <= k; j++) sum += j * a[j] * b[k - j];
    return sum / k;
}

/* c = cos(a), s = sin(a) go together: each call makes the partner's coefficient as well. */
static inline double jlt_jet_cosine(const double *a, double *c, double *s, unsigned k)
{
    s[k] = k == 0 ? sin(a[0]) : jlt_jet_slope(a, c, k);
    return k == 0 ? cos(a[0]) : -jlt_jet_slope(a, s, k);
}

static inline double jlt_jet_sine(const double *a, double *s, double *c, unsigned k)
{
    c[k] = k == 0 ? cos(a[0]) : -jlt_jet_slope(a, s, k);
    return k == 0 ? sin(a[0]) : jlt_jet_slope(a, c, k);
}

#endif
