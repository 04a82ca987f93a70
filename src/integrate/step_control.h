/** Pieces of step-size control that all methods share, without libm in the loop. */
#ifndef JLT_INTEGRATE_STEP_CONTROL_H
#define JLT_INTEGRATE_STEP_CONTROL_H

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#define JLT_BITS_OF_ONE INT64_C(0x3ff0000000000000)

/** Binary logarithm of a > 0 within 0.09: the bits of a double are a piecewise linear one. a is clipped to [1e-300, 1e300]; NaN
 *  gives the value at 1e300. */
static inline double jlt_rough_log2(double a)
{
    int64_t bits;

    if (!(a < 1e300)) a = 1e300;
    if (a < 1e-300) a = 1e-300;
    memcpy(&bits, &a, sizeof bits);
    return (double)(bits - JLT_BITS_OF_ONE) * 0x1p-52;
}

/** 2^l, at most 6.2 percent too large and never too small, |l| < 1000; the inverse of jlt_rough_log2. */
static inline double jlt_rough_exp2(double l)
{
    const int64_t bits = JLT_BITS_OF_ONE + (int64_t)(l * 0x1p52);
    double a;
    memcpy(&a, &bits, sizeof a);
    return a;
}

/** a^(-r), at most 6.2 (1 + r) percent too large and never too small, 0 < r <= 1, for a as of jlt_rough_log2. */
static inline double jlt_inverse_root(double a, double r)
{
    return jlt_rough_exp2(-r * jlt_rough_log2(a));
}

/** Comparison alone, where fmax and fmin would be calls into the mathematical library. A NaN in a gives b. */
static inline double jlt_larger(double a, double b)
{
    return a > b ? a : b;
}

static inline double jlt_smaller(double a, double b)
{
    return a < b ? a : b;
}

/** The product of two vectors, shape (count,): of a gradient and a slope, the rate of the quantity along it. */
static inline double jlt_along(const double *gradient, const double *slope, unsigned count)
{
    double sum = 0;
    for (unsigned i = 0; i < count; i++) sum += gradient[i] * slope[i];
    return sum;
}

/** The unit of time in which a first step is chosen. speed: the largest rate relative to its state's size, 0 at rest. The unit is
 *  1, but 1/speed for a motion so slow that an ordinary first step would change nothing. */
static inline double jlt_first_unit(double speed)
{
    return speed > 0 && speed < 1e-5 ? 1 / jlt_larger(speed, 1e-290) : 1;
}

/** Whether a step h from tau is so short that one a few times shorter would not change tau. */
static inline int jlt_step_is_short(double tau, double h)
{
    return !(fabs(h) > 64 * DBL_EPSILON * fabs(tau));
}

/** Whether a step h is too short to change tau by more than rounding, or below 1e-290. */
static inline int jlt_step_vanishes(double tau, double h)
{
    return !(fabs(h) > 4 * DBL_EPSILON * fabs(tau)) || !(fabs(h) > 1e-290);
}

#endif
