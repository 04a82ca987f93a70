/** Coefficients of order k of products, quotients, roots and elementary functions of power series whose operands are known to
 *  order k, and whose result is known below k. Cost: k + 1 products. Edited in codegen/runtime/; ttc writes copies.
 *
 *  A coefficient is a double, or, where JLT_LANES is defined, a vector: every lane does what a double does. */
#ifndef JLT_JET_H
#define JLT_JET_H

#include <math.h>

#if defined(JLT_LANES)
#include "lanes.h"
typedef jlt_lanes jlt_coefficient;
#define JLT_JET_ROOT jlt_lanes_root
#define JLT_JET_COSINE jlt_lanes_cosine_each
#define JLT_JET_SINE jlt_lanes_sine_each
#define JLT_JET_EXP jlt_lanes_exp_each
#define JLT_JET_LOG jlt_lanes_log_each
#else
typedef double jlt_coefficient;
#define JLT_JET_ROOT sqrt
#define JLT_JET_COSINE cos
#define JLT_JET_SINE sin
#define JLT_JET_EXP exp
#define JLT_JET_LOG log
#endif

static inline jlt_coefficient jlt_jet_product(const jlt_coefficient *a, const jlt_coefficient *b, unsigned k)
{
    jlt_coefficient sum = a[0] * b[k];
    for (unsigned j = 1; j <= k; j++) sum += a[j] * b[k - j];
    return sum;
}

/* q = a/b; a is coefficient k of the numerator. */
static inline jlt_coefficient jlt_jet_quotient(jlt_coefficient a, const jlt_coefficient *b, const jlt_coefficient *q,
                                               unsigned k)
{
    for (unsigned j = 1; j <= k; j++) a -= b[j] * q[k - j];
    return a / b[0];
}

/* r = sqrt(a); a is coefficient k of the radicand. */
static inline jlt_coefficient jlt_jet_root(jlt_coefficient a, const jlt_coefficient *r, unsigned k)
{
    if (k == 0) return JLT_JET_ROOT(a);
    for (unsigned j = 1; j < k; j++) a -= r[j] * r[k - j];
    return a / (2.0 * r[0]);
}

/* sum over j of j a_j b_(k-j), over k; k >= 1 */
static inline jlt_coefficient jlt_jet_slope(const jlt_coefficient *a, const jlt_coefficient *b, unsigned k)
{
    jlt_coefficient sum = { 0 };
    for (unsigned j = 1; j <= k; j++) sum += (double)j * a[j] * b[k - j];
    return sum / (double)k;
}

/* c = cos(a), s = sin(a) go together: each call makes the partner's coefficient as well. */
static inline jlt_coefficient jlt_jet_cosine(const jlt_coefficient *a, jlt_coefficient *c, jlt_coefficient *s, unsigned k)
{
    s[k] = k == 0 ? JLT_JET_SINE(a[0]) : jlt_jet_slope(a, c, k);
    return k == 0 ? JLT_JET_COSINE(a[0]) : -jlt_jet_slope(a, s, k);
}

static inline jlt_coefficient jlt_jet_sine(const jlt_coefficient *a, jlt_coefficient *s, jlt_coefficient *c, unsigned k)
{
    c[k] = k == 0 ? JLT_JET_COSINE(a[0]) : -jlt_jet_slope(a, s, k);
    return k == 0 ? JLT_JET_SINE(a[0]) : jlt_jet_slope(a, c, k);
}

/* e = exp(a): e' = a' e. */
static inline jlt_coefficient jlt_jet_exp(const jlt_coefficient *a, const jlt_coefficient *e, unsigned k)
{
    return k == 0 ? JLT_JET_EXP(a[0]) : jlt_jet_slope(a, e, k);
}

/* l = log(a): a l' = a'. */
static inline jlt_coefficient jlt_jet_log(const jlt_coefficient *a, const jlt_coefficient *l, unsigned k)
{
    jlt_coefficient sum = { 0 };
    if (k == 0) return JLT_JET_LOG(a[0]);
    for (unsigned j = 1; j < k; j++) sum += (double)j * l[j] * a[k - j];
    return (a[k] - sum / (double)k) / a[0];
}

#endif
