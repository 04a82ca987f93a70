#include "analysis/deflation.h"

#include "analysis/charpoly.h"
#include "analysis/deflation_problem.h"
#include "analysis/quadratic.h"
#include "dynamics/linear.h"
#include "ext/arpack.h"
#include "ext/eigen.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { SIZE = JLT_DEFLATION_SIZE_MAX };

static const double roundoff = DBL_EPSILON / 2;

/* The block B is not used if elimination adds an error larger than this, relative to its largest entry. */
static const double merit_limit = 1e-12;

/* |x| |y| / |y^H x| of the whole matrix for an eigenvalue lambda of B, whose right and left eigenvectors u, v come from the
 * adjugate of B: x = ((A_pf - A_pp W_p^(-1) W_f) u / lambda, u) and y = A_f^T v / lambda. */
static double condition(const jlt_deflation_problem *p, const jlt_deflation_choice *c, double re, double im)
{
    const size_t n = p->n, k = p->rank, rest = n - k;
    double adjugate[2 * SIZE * SIZE], x2 = 0.0, y2 = 0.0, product_re = 0.0, product_im = 0.0;
    const double *real = adjugate, *imaginary = adjugate + rest * rest;
    const double lambda = hypot(re, im);
    size_t row = 0, column = 0;

    if (lambda == 0.0) return NAN;
    (void)jlt_charpoly_adjugate(adjugate, c->block, rest, re, im);
    for (size_t i = 0; i < rest; i++)
        for (size_t j = 0; j < rest; j++)
            if (hypot(real[i * rest + j], imaginary[i * rest + j]) >
                hypot(real[row * rest + column], imaginary[row * rest + column]))
                row = i, column = j;
    for (size_t i = 0; i < rest; i++) {
        const double ur = real[i * rest + column], ui = imaginary[i * rest + column];
        const double vr = real[row * rest + i], vi = imaginary[row * rest + i];
        x2 += ur * ur + ui * ui;
        product_re += ur * vr - ui * vi;
        product_im += ur * vi + ui * vr;
    }
    for (size_t l = 0; l < k; l++) {
        const double *whole = p->a + c->pivots[l] * n;
        double r = 0.0, i = 0.0;
        for (size_t j = 0; j < rest; j++) {
            double entry = whole[c->others[j]];
            for (size_t q = 0; q < k; q++)
                if (whole[c->pivots[q]] != 0.0) entry -= whole[c->pivots[q]] * c->follow[q * rest + j];
            r += entry * real[j * rest + column];
            i += entry * imaginary[j * rest + column];
        }
        x2 += (r * r + i * i) / (lambda * lambda);
    }
    for (size_t j = 0; j < n; j++) {
        double r = 0.0, i = 0.0;
        for (size_t l = 0; l < rest; l++) {
            r += real[row * rest + l] * p->a[c->others[l] * n + j];
            i += imaginary[row * rest + l] * p->a[c->others[l] * n + j];
        }
        y2 += r * r + i * i;
    }
    const double product = hypot(product_re, product_im);
    if (!(x2 > 0.0 && y2 > 0.0)) return NAN; /* no entry: several eigenvectors, or less than the least double */
    return product == 0.0 ? INFINITY : sqrt(x2) * (sqrt(y2) / lambda) / product;
}

/* Indices of rows and columns of B that are still coupled, after those with their eigenvalue on the diagonal are removed; this
 * permutes B exactly to block triangular form. */
typedef struct {
    size_t count, index[SIZE];
} coupled;

static bool isolated(const jlt_deflation_choice *c, const coupled *active, size_t rest, size_t at)
{
    bool row = true, column = true;

    for (size_t k = 0; k < active->count; k++) {
        const size_t i = active->index[at], j = active->index[k];
        if (k == at) continue;
        row = row && c->block[i * rest + j] == 0.0 && c->error[i * rest + j] == 0.0;
        column = column && c->block[j * rest + i] == 0.0 && c->error[j * rest + i] == 0.0;
    }
    return row || column;
}

/* Move the eigenvalues that stand on the diagonal to re, im, error, and remove their rows from `active`; returns their number. */
static size_t take_isolated(double *re, double *im, double *error, coupled *active, const jlt_deflation_choice *c, size_t rest)
{
    size_t taken = 0;

    for (size_t at = 0; at < active->count;) {
        const size_t i = active->index[at];
        if (!isolated(c, active, rest, at)) {
            at++;
            continue;
        }
        re[taken] = c->block[i * rest + i];
        im[taken] = 0.0;
        error[taken++] = c->error[i * rest + i];
        active->count--;
        memmove(active->index + at, active->index + at + 1, (active->count - at) * sizeof *active->index);
        at = 0;
    }
    return taken;
}

/* Eigenvalues of a coupled block of three rows or more, by LAPACK. The error bound is the smaller of a first-order bound, if an
 * eigenvalue is simple, and Elsner's (L. Elsner, Linear Algebra Appl. 71, 1985). */
static jlt_status solve_large(double *re, double *im, double *error, const double *block, const double *block_error,
                              size_t n)
{
    const double size = jlt_linear_length(block, n * n);
    const double noise = jlt_linear_length(block_error, n * n) + 10 * (double)n * roundoff * size;

    JLT_PASS(jlt_eigen_values(re, im, block, n));
    for (size_t i = 0; i < n; i++) {
        double distances = 1.0;
        for (size_t k = 0; k < n; k++)
            if (k != i) distances *= hypot(re[k] - re[i], im[k] - im[i]);
        error[i] = pow(2 * size + noise, 1.0 - 1.0 / (double)n) * pow(noise, 1.0 / (double)n);
        if (distances > 0.0)
            error[i] = fmin(error[i], 2 * noise * jlt_charpoly_adjugate(NULL, block, n, re[i], im[i]) / distances);
    }
    return JLT_OK;
}

/* Eigenvalues of B with error bounds: those on a triangular part's diagonal as they are, a pair in closed form, more by LAPACK. */
static jlt_status solve_block(double *re, double *im, double *error, const jlt_deflation_problem *p, const jlt_deflation_choice *c)
{
    const size_t rest = p->n - p->rank;
    double block[SIZE * SIZE], block_error[SIZE * SIZE];
    coupled active = { .count = rest };
    size_t taken, n;

    for (size_t i = 0; i < rest; i++) active.index[i] = i;
    taken = take_isolated(re, im, error, &active, c, rest);
    n = active.count;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            block[i * n + j] = c->block[active.index[i] * rest + active.index[j]];
            block_error[i * n + j] = c->error[active.index[i] * rest + active.index[j]];
        }
    if (n == 0) return JLT_OK;
    if (n == 2) return jlt_quadratic_eigenvalues(re + taken, im + taken, error + taken, block, block_error);
    return solve_large(re + taken, im + taken, error + taken, block, block_error, n);
}

/* The largest distance from a value of the first list to the nearest of the second. */
static double farthest(const double *re, const double *im, size_t count, const double *others_re, const double *others_im,
                       size_t others)
{
    double worst = 0.0;

    for (size_t i = 0; i < count; i++) {
        double nearest = INFINITY;
        for (size_t j = 0; j < others; j++) nearest = fmin(nearest, hypot(re[i] - others_re[j], im[i] - others_im[j]));
        worst = fmax(worst, nearest);
    }
    return worst;
}

/* Compare with eigenvalues by LAPACK, with and without deflation, and by ARPACK. */
static jlt_status cross_check(jlt_deflation *result, const jlt_deflation_problem *p, const jlt_deflation_choice *c)
{
    const size_t n = p->n, rest = n - p->rank;
    const double size = fmax(jlt_linear_length(p->a, n * n), DBL_MIN);
    double re[SIZE], im[SIZE], other_re[SIZE], other_im[SIZE];
    size_t nonzero = 0, wanted, found = 0;

    for (size_t i = 0; i < n; i++) {
        re[i] = result->values[i].re;
        im[i] = result->values[i].im;
        nonzero += re[i] != 0.0 || im[i] != 0.0;
    }
    JLT_PASS(jlt_eigen_values(other_re, other_im, c->block, rest));
    result->lapack_difference = farthest(re + p->rank, im + p->rank, rest, other_re, other_im, rest) / size;
    JLT_PASS(jlt_eigen_values(other_re, other_im, p->a, n));
    result->plain_difference = fmax(farthest(re, im, n, other_re, other_im, n),
                                    farthest(other_re, other_im, n, re, im, n)) / size;
    if (n < 3) result->arpack_note = "ARPACK needs three rows";
    else if (nonzero == 0) result->arpack_note = "no eigenvalue differs from zero";
    if (result->arpack_note[0] != '\0') return JLT_OK;
    wanted = nonzero < n - 2 ? nonzero : n - 2;
    const jlt_status st = jlt_arpack_largest(other_re, other_im, &found, p->a, n, wanted);
    if (st == JLT_ERR_NOMEM) return st;
    if (st != JLT_OK || found == 0) result->arpack_note = "ARPACK did not converge";
    else result->arpack_difference = farthest(other_re, other_im, found, re, im, n) / size;
    return JLT_OK;
}

/* Eigenvalues of A itself; those of its triangular part are its diagonal. If at least p->rank of these are exactly zero, remove
 * that many, and set p->rank to 0: nothing is deflated. *found tells whether there are so many. */
static jlt_status solve_whole(double *re, double *im, double *errors, bool *found, jlt_deflation_problem *p,
                              jlt_deflation_choice *c)
{
    const size_t n = p->n, rank = p->rank;
    size_t kept = 0, exact = 0;
    jlt_status st = JLT_OK;

    *found = false;
    p->rank = 0;
    if (jlt_deflation_problem_choose(c, p)) st = solve_block(re, im, errors, p, c);
    else st = JLT_ERR_NONFINITE;
    for (size_t i = 0; st == JLT_OK && i < n; i++) {
        if (re[i] == 0.0 && im[i] == 0.0 && errors[i] == 0.0 && exact < rank) {
            exact++;
            continue;
        }
        re[kept] = re[i], im[kept] = im[i], errors[kept++] = errors[i];
    }
    *found = st == JLT_OK && exact == rank;
    if (*found) jlt_eigen_sort(re, im, errors, kept);
    else p->rank = rank;
    return st;
}

/* All eigenvalues except the zeros that integrals force. If these stand in A's triangular part, nothing is eliminated, so that
 * nearly dependent gradients do no harm; otherwise the eigenvalues are those of B. */
static jlt_status solve_problem(double *re, double *im, double *errors, jlt_deflation_problem *p, jlt_deflation_choice *best)
{
    bool found;
    jlt_status st = solve_whole(re, im, errors, &found, p, best);

    if (found) return JLT_OK;
    if (!jlt_deflation_problem_choose(best, p) || best->merit > merit_limit)
        return st == JLT_OK ? JLT_ERR_NO_CONVERGENCE : st;
    st = solve_block(re, im, errors, p, best);
    if (st == JLT_OK) jlt_eigen_sort(re, im, errors, p->n - p->rank);
    return st;
}

static jlt_status compute(jlt_deflation *result, const double *a, const double *error, size_t n, const double *gradients,
                          const double *gradient_error, size_t count, bool checked)
{
    jlt_deflation_problem p = { 0 };
    jlt_deflation_choice best = { 0 };
    jlt_deflation r = { 0 };
    double re[SIZE], im[SIZE], errors[SIZE];
    size_t attributed, zeros;

    if (n == 0 || n > SIZE || count > SIZE) return JLT_ERR_ARG;
    JLT_PASS(jlt_deflation_problem_set(&p, a, error, n, gradients, gradient_error, count));
    r.defect = jlt_deflation_problem_defect(&p);
    attributed = p.rank;
    JLT_PASS(solve_problem(re, im, errors, &p, &best));
    r.n = n;
    r.kept = n - attributed;
    zeros = attributed;
    for (size_t i = 0; i < attributed; i++) r.values[i] = (jlt_eigenvalue){ 0.0, 0.0, NAN, 0.0, p.row[i] };
    for (size_t i = 0; i < r.kept; i++) {
        r.values[attributed + i] = (jlt_eigenvalue){ re[i], im[i], condition(&p, &best, re[i], im[i]), errors[i], -1 };
        zeros += re[i] == 0.0 && im[i] == 0.0 && errors[i] == 0.0;
        r.doubtful_zero = r.doubtful_zero || (errors[i] > 0.0 && hypot(re[i], im[i]) <= errors[i]);
    }
    if (zeros > attributed) {
        size_t least, most;
        jlt_deflation_problem_rank(&least, &most, &p);
        r.defective_zero = least > n - zeros;
        r.doubtful_zero = r.doubtful_zero || (most > n - zeros && !r.defective_zero);
    }
    r.lapack_difference = r.plain_difference = r.arpack_difference = NAN;
    r.arpack_note = "";
    if (checked) JLT_PASS(cross_check(&r, &p, &best));
    for (size_t i = 0; i < n; i++) {
        jlt_eigenvalue *value = &r.values[i];
        const bool small = value->re == 0.0 && value->im == 0.0;
        value->re = ldexp(value->re, p.exponent);
        value->im = ldexp(value->im, p.exponent);
        value->error = ldexp(value->error, p.exponent);
        if (!isfinite(value->re) || !isfinite(value->im) || (!small && !isnormal(hypot(value->re, value->im))))
            return JLT_ERR_NONFINITE;
        if (small && value->source < 0 && r.defective_zero) value->condition = INFINITY;
    }
    *result = r;
    return JLT_OK;
}

jlt_status jlt_deflation_solve(jlt_deflation *result, const double *a, const double *error, size_t n, const double *gradients,
                               const double *gradient_error, size_t count)
{
    return compute(result, a, error, n, gradients, gradient_error, count, false);
}

jlt_status jlt_deflation_compute(jlt_deflation *result, const double *a, const double *error, size_t n,
                                 const double *gradients, const double *gradient_error, size_t count)
{
    return compute(result, a, error, n, gradients, gradient_error, count, true);
}
