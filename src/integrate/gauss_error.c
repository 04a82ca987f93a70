#include "integrate/gauss_error.h"

#include "integrate/gauss_batch.h"
#include "integrate/gauss_coefficients.h"
#include "integrate/step_control.h"

enum { N = JLT_GAUSS_NODES };

/* Binary logarithms. */
static const double scatter = 0.1;  /* 2 of 100 steps fall short of r by more */
static const double digits = 44;    /* lower coefficients are rounding */
static const double explained = 2;  /* 1 of 1000 steps of smooth motions misses a slope by more than n_8 times this */
static const double outside = -6.7; /* half of the part of a step between an outer node and the end beside it */
static const double noise = 14;     /* errors of slopes leave as many digits at least */
static const double alike = 4;      /* they show in n_7 as in a slope at an end, up to this */
static const double smooth = 1.0 / 17;

jlt_gauss_error jlt_gauss_error_of(const double *sizes, double h, double tolerance)
{
    const double *n = sizes, size = jlt_larger(jlt_larger(n[0], n[1]), n[2]);
    if (!(size < JLT_GAUSS_SIZE_MAX)) return (jlt_gauss_error){ .local = NAN };
    /* A seventh coefficient may vanish by chance; the sixth then stands in, one factor r lower. */
    double last = jlt_larger(n[7], n[6] + (1.0 / 6) * (n[6] - size)), r = (1.0 / 7) * (last - size);
    /* The last coefficients of a large smooth part plus a small rough one fall more slowly; those of rounding do not fall. */
    const double tail = jlt_larger(n[6], n[7]), pairs = 0.5 * (tail - jlt_larger(n[4], n[5])) - 2 * scatter;
    const double fall = jlt_larger(pairs, 0.25 * (n[6] + n[7] - n[4] - n[5]) - scatter);
    if (fall > r && tail > size - digits) {
        r = jlt_smaller(fall, 0);
        last = jlt_larger(last, n[6] + r);
    }
    const double length = jlt_rough_log2(fabs(h)), units = length - jlt_rough_log2(tolerance);
    return (jlt_gauss_error){ .local = units + last + 9 * r, .root = smooth, .dense = length + last + r, .size = size, .rate = r,
                              .left_out = last + r, .units = units };
}

void jlt_gauss_error_see_ends(jlt_gauss_error *io, const double *legendre, const double *before, const double *after,
                              const double *weights, unsigned columns)
{
    double miss = 0;

    for (unsigned c = 0; c < columns; c++) {
        const double *a = legendre + c * N, even = (a[0] + a[2]) + (a[4] + a[6]), odd = (a[1] + a[3]) + (a[5] + a[7]);
        const double off = jlt_larger(fabs(before[c] - (even - odd)), fabs(after[c] - (even + odd)));
        miss = jlt_larger(off * weights[c], miss);
    }
    const double size = jlt_rough_log2(miss), more = size - io->left_out;
    if (more > 0) {
        io->local += 4.5 * more;
        io->dense += more;
        const double digit = io->size - size, beyond = io->rate + 0.5 * more;
        if (beyond > 0 && more + io->rate < alike && digit > noise && digit < digits) io->local -= 9 * beyond, io->root = 1;
    }
    if (more > explained) io->local = jlt_larger(io->local, io->units + size + outside);
}
