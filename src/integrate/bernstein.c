#include "integrate/bernstein.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { SIZE = JLT_BERNSTEIN_DEGREE_MAX + 1, DEPTH_MAX = 40 };

void jlt_bernstein_of(double *b, const double *c, size_t stride, unsigned degree)
{
    /* Scaled coefficients c_k/C(degree,k), then running sums: b is their table of binomial sums. */
    double binomial = 1;
    for (unsigned k = 0; 2 * k <= degree; k++) {
        b[k] = c[k * stride] / binomial;
        b[degree - k] = c[(degree - k) * stride] / binomial;
        binomial = binomial * (degree - k) / (k + 1);
    }
    for (unsigned round = 1; round <= degree; round++)
        for (unsigned j = degree; j >= round; j--) b[j] += b[j - 1];
}

void jlt_bernstein_deflate(double *b, unsigned degree)
{
    for (unsigned j = 1; j <= degree; j++) b[j - 1] = b[j] * degree / j;
}

void jlt_bernstein_derive(double *d, const double *b, unsigned degree)
{
    for (unsigned j = 0; j < degree; j++) d[j] = degree * (b[j + 1] - b[j]);
}

double jlt_bernstein_value(const double *b, unsigned degree, double theta)
{
    double work[SIZE];
    memcpy(work, b, (degree + 1) * sizeof *work);
    for (unsigned round = degree; round >= 1; round--)
        for (unsigned j = 0; j < round; j++) work[j] += theta * (work[j + 1] - work[j]);
    return work[0];
}

/* Coefficients of the two parts left and right of theta. */
static void split(double *left, double *right, const double *b, unsigned degree, double theta)
{
    memcpy(right, b, (degree + 1) * sizeof *right);
    left[0] = right[0];
    for (unsigned round = 1; round <= degree; round++) {
        for (unsigned j = 0; j + round <= degree; j++) right[j] += theta * (right[j + 1] - right[j]);
        left[round] = right[0];
    }
}

/* Cut b into a left and a right part near the middle, where b is not zero, or for extrema its slope: such a zero would belong to
 * neither part. There are at most degree zeros, so one of degree + 1 points serves. Returns the point. */
static double cut(double *left, double *right, const double *b, unsigned degree, bool extrema)
{
    double theta = 0.5;
    split(left, right, b, degree, theta);
    for (unsigned i = 0; i < degree && right[extrema] == (extrema ? right[0] : 0); i++) {
        theta *= 0.875;
        split(left, right, b, degree, theta);
    }
    return theta;
}

unsigned jlt_bernstein_variations(const double *b, unsigned degree)
{
    unsigned count = 0;
    double last = 0;
    for (unsigned j = 0; j <= degree; j++) {
        if (b[j] == 0) continue;
        if (last * b[j] < 0) count++;
        last = b[j] > 0 ? 1 : -1;
    }
    return count;
}

/* The one zero of b on (0, 1) by Halley's method in a bracket. With u = theta/(1 - theta) b is q(u)/(1 + u)^degree,
 * q = sum_j C(degree,j) b_j u^j, which Horner's rule sums stably where u <= 1: the interval is reversed if the zero is right
 * of 1/2. */
static double only_root(const double *b, unsigned degree)
{
    double a[SIZE], binomial = 1, middle = 0, lo = 0, hi = 1;
    for (unsigned j = 0; 2 * j <= degree; j++) {
        a[j] = binomial * b[j];
        a[degree - j] = binomial * b[degree - j];
        binomial = binomial * (degree - j) / (j + 1);
    }
    for (unsigned j = 0; j <= degree; j++) middle += a[j];
    const bool rises = b[0] < 0, turned = rises ? middle < 0 : middle > 0;
    for (unsigned j = 0; turned && 2 * j < degree; j++) {
        const double other = a[degree - j];
        a[degree - j] = a[j];
        a[j] = other;
    }
    unsigned first = 0; /* start from the zero of the control polygon, which is near */
    while (rises ? b[first + 1] < 0 : b[first + 1] > 0) first++;
    const double start = (first + b[first] / (b[first] - b[first + 1])) / degree;
    double u = turned ? (1 - start) / start : start / (1 - start);
    if (!(u > 0 && u < hi)) u = 0.5;
    for (unsigned i = 0; i < 80; i++) {
        double value = a[degree], slope = 0, bend = 0; /* bend: half the second derivative */
        for (unsigned j = degree; j-- > 0;) {
            bend = bend * u + slope;
            slope = slope * u + value;
            value = value * u + a[j];
        }
        if (value == 0) break;
        if (rises == turned ? value > 0 : value < 0) lo = u;
        else hi = u;
        const double move = -value * slope / (slope * slope - value * bend), next = u + move;
        /* The error left by Halley's method is the cube of its move, unless that is short because the slope vanishes. */
        const bool done = fabs(move) <= 1e-5 * u && fabs(value) <= 1e-5 * u * fabs(slope);
        u = done || (next > lo && next < hi) ? next : 0.5 * (lo + hi);
        if (done || hi - lo <= DBL_EPSILON * hi) break;
    }
    return (turned ? 1 : u) / (1 + u);
}

typedef struct {
    double *roots;
    unsigned count, degree;
} collection;

static void collect(collection *found, const double *b, double from, double width, unsigned depth)
{
    const unsigned degree = found->degree, changes = jlt_bernstein_variations(b, degree);

    if (changes == 0 || found->count == degree) return;
    if (changes == 1) {
        found->roots[found->count++] = from + width * only_root(b, degree);
        return;
    }
    if (depth == DEPTH_MAX) {
        if (changes % 2 == 1) found->roots[found->count++] = from + 0.5 * width;
        return;
    }
    double left[SIZE], right[SIZE];
    const double theta = cut(left, right, b, degree, false);
    collect(found, left, from, width * theta, depth + 1);
    collect(found, right, from + width * theta, width * (1 - theta), depth + 1);
}

/* Divide out zeros at the ends, which keeps signs on (0, 1). Returns the degree left. */
static unsigned without_ends(double *b, unsigned degree)
{
    while (degree > 0 && b[0] == 0) jlt_bernstein_deflate(b, degree--);
    while (degree > 0 && b[degree] == 0) {
        for (unsigned j = 0; j < degree; j++) b[j] = b[j] * degree / (degree - j);
        degree--;
    }
    return degree;
}

unsigned jlt_bernstein_sign_changes(double *roots, const double *b, unsigned degree)
{
    double inner[SIZE];
    memcpy(inner, b, (degree + 1) * sizeof *inner);
    collection found = { .roots = roots, .degree = without_ends(inner, degree) };
    if (found.degree > 0) collect(&found, inner, 0, 1, 0);
    return found.count;
}

/* Whether all coefficients are above the bound, or below its negative: so is the polynomial then. */
static bool stays_off(const double *b, unsigned degree, double bound)
{
    double least = b[0], most = b[0];
    for (unsigned j = 1; j <= degree; j++) {
        least = b[j] < least ? b[j] : least;
        most = b[j] > most ? b[j] : most;
    }
    return least > bound || most < -bound;
}

static void collect_touches(collection *found, const double *b, double bound, double from, double width, unsigned depth)
{
    const unsigned degree = found->degree;
    double slope[SIZE];

    if (stays_off(b, degree, bound) || found->count == degree - 1) return;
    jlt_bernstein_derive(slope, b, degree);
    const unsigned inner = without_ends(slope, degree - 1), changes = jlt_bernstein_variations(slope, inner);
    if (changes == 0) return;
    if (changes == 1) {
        const double at = only_root(slope, inner);
        if (fabs(jlt_bernstein_value(b, degree, at)) <= bound) found->roots[found->count++] = from + width * at;
        return;
    }
    if (depth == DEPTH_MAX) {
        if (changes % 2 == 1) found->roots[found->count++] = from + 0.5 * width;
        return;
    }
    double left[SIZE], right[SIZE];
    const double theta = cut(left, right, b, degree, true);
    collect_touches(found, left, bound, from, width * theta, depth + 1);
    collect_touches(found, right, bound, from + width * theta, width * (1 - theta), depth + 1);
}

unsigned jlt_bernstein_touches(double *at, const double *b, unsigned degree, double bound)
{
    collection found = { .roots = at, .degree = degree };
    if (degree >= 2) collect_touches(&found, b, bound, 0, 1, 0);
    return found.count;
}
