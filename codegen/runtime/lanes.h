/** Vectors of JLT_LANES doubles, for code that is compiled once for each instruction set. Edited in codegen/runtime/; ttc writes
 *  copies.
 *
 *  The includer defines JLT_LANES as 1, 2, 4 or 8 first. Arithmetic is the compilers' own on vector types, lane by lane as in
 *  scalar code; the fused multiply-add and the square root need the instruction set's own names, and functions of the C library
 *  are those on vectors, to other last bits, where there are such. Without FMA in the target a*b + c is rounded twice, as the
 *  scalar kernels do there. */
#ifndef JLT_LANES_H
#define JLT_LANES_H

#include <math.h>
#include <stdint.h>
#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

/* Vectors wider than the target's registers are passed in memory; nothing here is called from elsewhere, so it shows
 * in no interface. */
#pragma GCC diagnostic ignored "-Wpsabi"

typedef double jlt_lanes __attribute__((vector_size(8 * JLT_LANES)));
typedef int64_t jlt_lane_mask __attribute__((vector_size(8 * JLT_LANES))); /* -1 where true, 0 where false */

static inline jlt_lanes jlt_lanes_of(double value) { return value - (jlt_lanes){ 0 }; }

static inline jlt_lanes jlt_lanes_load(const double *from) { return *(const jlt_lanes *)(const void *)from; }

/* The same pointer, which the compiler takes for another one: what is read through it in a loop is read there, where it would
 * otherwise be read before, and wait on the stack. */
static inline const double *jlt_lanes_fresh(const double *from)
{
    __asm__ volatile("" : "+r"(from));
    return from;
}

static inline void jlt_lanes_store(double *to, jlt_lanes value) { *(jlt_lanes *)(void *)to = value; }

static inline jlt_lanes jlt_lanes_fma(jlt_lanes a, jlt_lanes b, jlt_lanes c)
{
#if JLT_LANES == 8 && defined(__AVX512F__)
    return (jlt_lanes)_mm512_fmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
#elif JLT_LANES == 4 && defined(__FMA__)
    return (jlt_lanes)_mm256_fmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
#elif JLT_LANES == 2 && defined(__aarch64__)
    return (jlt_lanes)vfmaq_f64((float64x2_t)c, (float64x2_t)a, (float64x2_t)b);
#else
    return a * b + c;
#endif
}

static inline jlt_lanes jlt_lanes_fms(jlt_lanes a, jlt_lanes b, jlt_lanes c)
{
#if JLT_LANES == 8 && defined(__AVX512F__)
    return (jlt_lanes)_mm512_fmsub_pd((__m512d)a, (__m512d)b, (__m512d)c);
#elif JLT_LANES == 4 && defined(__FMA__)
    return (jlt_lanes)_mm256_fmsub_pd((__m256d)a, (__m256d)b, (__m256d)c);
#elif JLT_LANES == 2 && defined(__aarch64__)
    return (jlt_lanes)vfmaq_f64((float64x2_t)-c, (float64x2_t)a, (float64x2_t)b);
#else
    return a * b - c;
#endif
}

static inline jlt_lanes jlt_lanes_fnma(jlt_lanes a, jlt_lanes b, jlt_lanes c)
{
#if JLT_LANES == 8 && defined(__AVX512F__)
    return (jlt_lanes)_mm512_fnmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
#elif JLT_LANES == 4 && defined(__FMA__)
    return (jlt_lanes)_mm256_fnmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
#elif JLT_LANES == 2 && defined(__aarch64__)
    return (jlt_lanes)vfmsq_f64((float64x2_t)c, (float64x2_t)a, (float64x2_t)b);
#else
    return c - a * b;
#endif
}

#define JLT_FMA(a, b, c) jlt_lanes_fma((a), (b), (c))
#define JLT_FMS(a, b, c) jlt_lanes_fms((a), (b), (c))
#define JLT_FNMA(a, b, c) jlt_lanes_fnma((a), (b), (c))

static inline jlt_lanes jlt_lanes_root(jlt_lanes a)
{
#if JLT_LANES == 8 && defined(__AVX512F__)
    return (jlt_lanes)_mm512_sqrt_pd((__m512d)a);
#elif JLT_LANES == 4 && defined(__AVX__)
    return (jlt_lanes)_mm256_sqrt_pd((__m256d)a);
#elif JLT_LANES == 2 && defined(__SSE2__)
    return (jlt_lanes)_mm_sqrt_pd((__m128d)a);
#elif JLT_LANES == 2 && defined(__aarch64__)
    return (jlt_lanes)vsqrtq_f64((float64x2_t)a);
#else
    for (int lane = 0; lane < JLT_LANES; lane++) a[lane] = sqrt(a[lane]);
    return a;
#endif
}

/* Functions of the C library, lane by lane, jlt_lanes_*_each, and of whole vectors. glibc has the latter for wide vectors of
 * x86-64, in libmvec, which -lm brings: to 4 units in the last place, where those for one number err by less than 1, and up to
 * ten times as fast. Those for eight numbers round otherwise than those for four, of which two are taken: machines with either kind
 * of vectors have the same rows. */
#define JLT_LANES_EACH(name, function)                                                                       \
    static inline jlt_lanes jlt_lanes_##name##_each(jlt_lanes a)                                             \
    {                                                                                                        \
        for (int lane = 0; lane < JLT_LANES; lane++) a[lane] = function(a[lane]);                            \
        return a;                                                                                            \
    }
#if defined(__GLIBC__) && JLT_LANES == 8 && defined(__AVX512F__)
#define JLT_LANES_WHOLE(name, function)                                                                      \
    __m256d _ZGVdN4v_##function(__m256d);                                                                    \
    static inline jlt_lanes jlt_lanes_##name(jlt_lanes a)                                                    \
    {                                                                                                        \
        const __m256d low = _ZGVdN4v_##function(_mm512_castpd512_pd256((__m512d)a));                         \
        const __m256d high = _ZGVdN4v_##function(_mm512_extractf64x4_pd((__m512d)a, 1));                     \
        return (jlt_lanes)_mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);                          \
    }
#elif defined(__GLIBC__) && JLT_LANES == 4 && defined(__AVX2__)
#define JLT_LANES_WHOLE(name, function)                                                                      \
    __m256d _ZGVdN4v_##function(__m256d);                                                                    \
    static inline jlt_lanes jlt_lanes_##name(jlt_lanes a) { return (jlt_lanes)_ZGVdN4v_##function((__m256d)a); }
#else
#define JLT_LANES_WHOLE(name, function)                                                                      \
    static inline jlt_lanes jlt_lanes_##name(jlt_lanes a) { return jlt_lanes_##name##_each(a); }
#endif
#define JLT_LANES_FUNCTION(name, function) JLT_LANES_EACH(name, function) JLT_LANES_WHOLE(name, function)
JLT_LANES_FUNCTION(cosine, cos)
JLT_LANES_FUNCTION(sine, sin)
JLT_LANES_FUNCTION(exp, exp)
JLT_LANES_FUNCTION(log, log)

/* Bit j is set where lane j of the mask is true. */
static inline unsigned jlt_lanes_bits(jlt_lane_mask mask)
{
#if JLT_LANES == 8 && defined(__AVX512DQ__)
    return (unsigned)_mm512_movepi64_mask((__m512i)mask);
#elif JLT_LANES == 4 && defined(__AVX__)
    return (unsigned)_mm256_movemask_pd((__m256d)mask);
#elif JLT_LANES == 2 && defined(__SSE2__)
    return (unsigned)_mm_movemask_pd((__m128d)mask);
#else
    unsigned bits = 0;
    for (int lane = 0; lane < JLT_LANES; lane++) bits |= (unsigned)(mask[lane] & 1) << lane;
    return bits;
#endif
}

static inline jlt_lanes jlt_lanes_select(jlt_lane_mask mask, jlt_lanes yes, jlt_lanes no)
{
    return (jlt_lanes)((mask & (jlt_lane_mask)yes) | (~mask & (jlt_lane_mask)no));
}

/* The larger of a and b in each lane; b where either is NaN. */
static inline jlt_lanes jlt_lanes_larger(jlt_lanes a, jlt_lanes b)
{
#if JLT_LANES == 8 && defined(__AVX512F__)
    return (jlt_lanes)_mm512_max_pd((__m512d)a, (__m512d)b);
#elif JLT_LANES == 4 && defined(__AVX__)
    return (jlt_lanes)_mm256_max_pd((__m256d)a, (__m256d)b);
#elif JLT_LANES == 2 && defined(__SSE2__)
    return (jlt_lanes)_mm_max_pd((__m128d)a, (__m128d)b);
#else
    return jlt_lanes_select(a > b, a, b);
#endif
}

/* The smaller of a and b in each lane; b where either is NaN. */
static inline jlt_lanes jlt_lanes_smaller(jlt_lanes a, jlt_lanes b)
{
#if JLT_LANES == 8 && defined(__AVX512F__)
    return (jlt_lanes)_mm512_min_pd((__m512d)a, (__m512d)b);
#elif JLT_LANES == 4 && defined(__AVX__)
    return (jlt_lanes)_mm256_min_pd((__m256d)a, (__m256d)b);
#elif JLT_LANES == 2 && defined(__SSE2__)
    return (jlt_lanes)_mm_min_pd((__m128d)a, (__m128d)b);
#else
    return jlt_lanes_select(a < b, a, b);
#endif
}

static inline jlt_lanes jlt_lanes_size(jlt_lanes a) { return (jlt_lanes)((jlt_lane_mask)a & INT64_MAX); }

#endif
