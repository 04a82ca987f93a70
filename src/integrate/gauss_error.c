#include "integrate/gauss_error.h"

#include <math.h>

#include "integrate/gauss_batch.h"
#include "integrate/gauss_coefficients.h"
#include "integrate/step_control.h"

enum { N = JLT_GAUSS_NODES };

/* Binary logarithms. */
static const double scatter = 0.1;  /* 2 of 100 steps fall short of r by more */
static const double digits = 44;    /* lower coefficients are rounding */
static const double explained = 2;  /* 1 of 1000 steps of smooth motions misses a slope by more than n_8 times this */
static const double limiting = -33; /* of an error in tolerances, above which the next step grows by less than it may */
static const double notable = 4;    /* of a change of an error: it changes the next step by a sixth */
static const double outside = -6.7; /* half of the part of a step between an outer node and the end beside it */

jlt_gauss_error jlt_gauss_error_of(const double *sizes, double h, double tolerance, double noise)
{
    const double *n = sizes, size = jlt_larger(jlt_larger(n[0], n[1]), n[2]);
    if (!(size < JLT_GAUSS_SIZE_MAX)) return (jlt_gauss_error){ .local = NAN };
    /* A seventh coefficient may vanish by chance; the sixth then stands in, one factor r lower. */
    double last = jlt_larger(n[7], n[6] + (1.0 / 6) * (n[6] - size)), r = (1.0 / 7) * (last - size);
    /* The last coefficients of a large smooth part plus a small rough one fall more slowly; those of rounding do not fall. */
    const double tail = jlt_larger(n[6], n[7]), pairs = 0.5 * (tail - jlt_larger(n[4], n[5])) - 2 * scatter;
    const double fall = jlt_larger(pairs, 0.25 * (n[6] + n[7] - n[4] - n[5]) - scatter);
    const bool falls = !(fall > r && tail > jlt_larger(size - digits, noise));
    if (!falls) {
        r = jlt_smaller(fall, 0);
        last = jlt_larger(last, n[6] + r);
    }
    const double length = jlt_rough_log2(fabs(h)), units = length - jlt_rough_log2(tolerance);
    return (jlt_gauss_error){ units + last + 9 * r, length + last + r, last + r, r, units, falls };
}

/* The largest difference of slopes, relative to the states. */
static double most(const jlt_gauss_step *step, const double *a, const double *b)
{
    double largest = 0;

    for (unsigned c = 0; c < step->columns; c++) largest = jlt_larger(fabs(a[c] - b[c]) * step->weights[c], largest);
    return largest;
}

/* By how much the polynomial misses a slope at an end of the step. */
static double missed(const jlt_gauss_step *step)
{
    double *start = step->work, *end = step->work + step->columns;

    for (unsigned c = 0; c < step->columns; c++) {
        const double *a = step->legendre + c * N, even = (a[0] + a[2]) + (a[4] + a[6]), odd = (a[1] + a[3]) + (a[5] + a[7]);
        start[c] = even - odd;
        end[c] = even + odd;
    }
    return jlt_larger(most(step, start, step->before), most(step, end, step->after));
}

/* By how much the slopes at the end move where states are changed by a part of their values, and by one of their sizes; a binary
 * logarithm. What keeps its sign has its value as its size: from 0 it would drive tangents that are known to far less. */
static double noise_of(const jlt_gauss_step *step, double of_value, double of_size)
{
    double *x = step->work, *slope = step->work + step->columns;

    for (unsigned c = 0; c < step->columns; c++) {
        const double value = fabs(step->end[c]), size = jlt_field_keeps(step->field, c) ? value : 1 / step->weights[c];
        const double change = of_value * value + of_size * size;
        x[c] = step->end[c] + (c % 2 == 0 ? change : -change);
    }
    jlt_field_rates(step->field, slope, x);
    return jlt_rough_log2(most(step, slope, step->after));
}

/* The errors, where the polynomial misses a slope by `miss`; both are binary logarithms. */
static jlt_gauss_error corrected(jlt_gauss_error e, double miss, double doubt)
{
    const double more = miss - jlt_larger(e.left_out, doubt);

    if (more > 0) {
        e.local += 9 * (jlt_smaller(e.rate + 0.5 * more, 0) - e.rate);
        e.dense += more;
    }
    if (more > explained) e.local = jlt_larger(e.local, e.units + miss + outside);
    return e;
}

/* Whether the next step would change if this error took the place of the other; if not, it need not wait for it. */
static bool is_notable(double error, double other)
{
    return error > 0 || (error > limiting && error > other + notable);
}

unsigned jlt_gauss_error_see_tail(jlt_gauss_error *io, const jlt_gauss_step *step, const double *sizes, double tolerance)
{
    const jlt_gauss_error strict = jlt_gauss_error_of(sizes, step->h, tolerance, -INFINITY);
    const bool limits = is_notable(strict.local, io->local);

    *io = limits ? jlt_gauss_error_of(sizes, step->h, tolerance, noise_of(step, step->rounding, 0)) : strict;
    return limits;
}

unsigned jlt_gauss_error_see_ends(jlt_gauss_error *io, const jlt_gauss_step *step)
{
    const double miss = jlt_rough_log2(missed(step));
    const jlt_gauss_error seen = corrected(*io, miss, -INFINITY);

    if (!is_notable(seen.local, io->local)) {
        io->dense = seen.dense;
        return 0;
    }
    *io = corrected(*io, miss, noise_of(step, 0, step->left));
    return 1;
}

unsigned jlt_gauss_error_raise(jlt_gauss_error *io, const jlt_gauss_step *step, double miss)
{
    const double error = io->units + miss;

    if (!is_notable(error, io->local)) return 0;
    if (miss > noise_of(step, 0, step->left)) io->local = error;
    return 1;
}
