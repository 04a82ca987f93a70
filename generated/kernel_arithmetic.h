/** Fused operations of generated kernels. Edited in codegen/runtime/; ttc writes copies.
 *
 *  Where the target has a fused multiply-add (FP_FAST_FMA), it is used and rounds once; elsewhere a product and a
 *  sum round twice, and the slow library function is never called. Either way the order of operations is as written:
 *  compile with -ffp-contract=off, so that nothing else is fused. */
#ifndef JLT_KERNEL_ARITHMETIC_H
#define JLT_KERNEL_ARITHMETIC_H

#include <math.h>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "kernels need IEEE arithmetic: compile them without fast-math options"
#endif

#ifdef FP_FAST_FMA
#define JLT_FMA(a, b, c) fma((a), (b), (c))
#define JLT_FMS(a, b, c) fma((a), (b), -(c))
#define JLT_FNMA(a, b, c) fma(-(a), (b), (c))
#else
#define JLT_FMA(a, b, c) ((a) * (b) + (c))
#define JLT_FMS(a, b, c) ((a) * (b) - (c))
#define JLT_FNMA(a, b, c) ((c) - (a) * (b))
#endif

#endif
