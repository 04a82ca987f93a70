#include "integrate/bernstein.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { SIZE = JLT_BERNSTEIN_DEGREE_MAX + 1, DEPTH_MAX = 40 };

void jlt_bernstein_of(double *b, const double *c, size_t stride, unsigned degree)
{
    /* Scaled coefficients c_k/C(degree,k), then running sums: b is their table of binomial sums. */
    double binomial = 1;
    for (unsigned k = 0; k <= degree; k++) {
        b[k] = c[k * stride] / binomial;
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

static unsigned variations(const double *b, unsigned degree)
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

/* The one zero of b on (0, 1), by the Illinois method with bisection as a watchdog. */
static double only_root(const double *b, unsigned degree)
{
    double lo = 0, hi = 1, at_lo = b[0], at_hi = b[degree];
    int stayed = 0;

    for (unsigned i = 0; i < 80 && hi - lo > DBL_EPSILON * hi; i++) {
        double mid = i % 8 == 7 ? 0.5 * (lo + hi) : (lo * at_hi - hi * at_lo) / (at_hi - at_lo);
        if (!(mid > lo && mid < hi)) mid = 0.5 * (lo + hi);
        const double at_mid = jlt_bernstein_value(b, degree, mid);
        if (at_mid == 0) return mid;
        if (at_mid * at_lo > 0) {
            lo = mid, at_lo = at_mid;
            if (stayed > 0) at_hi *= 0.5;
            stayed = 1;
        } else {
            hi = mid, at_hi = at_mid;
            if (stayed < 0) at_lo *= 0.5;
            stayed = -1;
        }
    }
    return 0.5 * (lo + hi);
}

typedef struct {
    double *roots;
    unsigned count, degree;
} collection;

static void collect(collection *found, const double *b, double from, double width, unsigned depth)
{
    const unsigned degree = found->degree, changes = variations(b, degree);

    if (changes == 0 || found->count == degree) return;
    if (changes == 1) {
        found->roots[found->count++] = from + width * only_root(b, degree);
        return;
    }
    if (depth == DEPTH_MAX) {
        if (changes % 2 == 1) found->roots[found->count++] = from + 0.5 * width;
        return;
    }
    double left[SIZE], right[SIZE], theta = 0.5;
    split(left, right, b, degree, theta);
    if (right[0] == 0) { /* a zero at the cut belongs to neither part: cut elsewhere */
        theta = 0.4375;
        split(left, right, b, degree, theta);
    }
    collect(found, left, from, width * theta, depth + 1);
    collect(found, right, from + width * theta, width * (1 - theta), depth + 1);
}

unsigned jlt_bernstein_sign_changes(double *roots, const double *b, unsigned degree)
{
    double inner[SIZE]; /* zeros at the ends divided out: signs on (0, 1) stay */
    memcpy(inner, b, (degree + 1) * sizeof *inner);
    while (degree > 0 && inner[0] == 0) jlt_bernstein_deflate(inner, degree--);
    while (degree > 0 && inner[degree] == 0) {
        for (unsigned j = 0; j < degree; j++) inner[j] = inner[j] * degree / (degree - j);
        degree--;
    }
    collection found = { .roots = roots, .degree = degree };
    if (degree > 0) collect(&found, inner, 0, 1, 0);
    return found.count;
}
