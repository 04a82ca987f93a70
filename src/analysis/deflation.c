#include "analysis/deflation.h"

#include "analysis/charpoly.h"
#include "analysis/quadratic.h"
#include "core/guard.h"
#include "ext/arpack.h"
#include "ext/eigen.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { SIZE = JLT_DEFLATION_SIZE_MAX, CHOICES_MAX = 20000 };

static const double roundoff = DBL_EPSILON / 2;

/* A block B that elimination has spoilt by more than this, relative to its largest entry, is not used. */
static const double merit_limit = 1e-12;

/* The problem, scaled by a power of two so that the largest entry of a is near one. */
typedef struct {
    size_t n, rank;
    double a[SIZE * SIZE], error[SIZE * SIZE];
    double w[SIZE * SIZE]; /* independent gradients, rows scaled near one, shape (rank, n) */
    double w_error[SIZE * SIZE];
    double columns[SIZE];  /* sizes of the gradients' columns */
    int row[SIZE];         /* which gradient each is */
    int exponent;
} problem;

typedef struct {
    size_t pivots[SIZE], others[SIZE];
    double follow[SIZE * SIZE], follow_error[SIZE * SIZE]; /* W_p^(-1) W_f, shape (rank, n - rank) */
    double inverse[SIZE * SIZE];                           /* W_p^(-1), shape (rank, rank) */
    double block[SIZE * SIZE], error[SIZE * SIZE];
    double merit;               /* largest error that the elimination adds to B, relative to its largest entry */
} choice;

/* [W_p W_f E] by elimination with row pivoting to [E X W_p^(-1)]; false when W_p is singular. */
static bool eliminate(choice *c, const problem *p)
{
    const size_t k = p->rank, rest = p->n - k, width = p->n + k;
    double m[SIZE * 2 * SIZE] = { 0 };

    for (size_t i = 0; i < k; i++) {
        for (size_t j = 0; j < k; j++) m[i * width + j] = p->w[i * p->n + c->pivots[j]];
        for (size_t j = 0; j < rest; j++) m[i * width + k + j] = p->w[i * p->n + c->others[j]];
        m[i * width + p->n + i] = 1.0;
    }
    for (size_t j = 0; j < k; j++) {
        size_t best = j;
        for (size_t i = j + 1; i < k; i++)
            if (fabs(m[i * width + j]) > fabs(m[best * width + j])) best = i;
        if (m[best * width + j] == 0.0) return false;
        for (size_t l = 0; l < width; l++) {
            const double held = m[j * width + l];
            m[j * width + l] = m[best * width + l];
            m[best * width + l] = held;
        }
        for (size_t i = 0; i < k; i++) {
            const double factor = m[i * width + j] / m[j * width + j];
            if (i == j || factor == 0.0) continue;
            for (size_t l = j; l < width; l++) m[i * width + l] -= factor * m[j * width + l];
        }
    }
    for (size_t i = 0; i < k; i++) {
        for (size_t j = 0; j < rest; j++) c->follow[i * rest + j] = m[i * width + k + j] / m[i * width + i];
        for (size_t j = 0; j < k; j++) c->inverse[i * k + j] = m[i * width + p->n + j] / m[i * width + i];
    }
    for (size_t i = 0; i < k * rest; i++)
        if (!isfinite(c->follow[i])) return false;
    return true;
}

/* Through a pointer that the compiler cannot see behind, so that the guard sees all of the elimination. */
static bool (*volatile eliminate_guarded)(choice *, const problem *) = eliminate;

/* The computed C is an inverse of every W_p within its errors: |E - C W_p| + |C| |error of W_p| < 1/10 in coordinates
 * scaled by the columns. */
static bool inverts(const choice *c, const problem *p)
{
    const size_t n = p->n, k = p->rank;

    for (size_t i = 0; i < k; i++) {
        double distance = 0.0;
        for (size_t j = 0; j < k; j++) {
            double entry = i == j ? 1.0 : 0.0, uncertain = 0.0;
            for (size_t q = 0; q < k; q++) {
                const size_t at = q * n + c->pivots[j];
                entry -= c->inverse[i * k + q] * p->w[at];
                uncertain += fabs(c->inverse[i * k + q]) * p->w_error[at];
            }
            distance += (fabs(entry) + uncertain) * p->columns[c->pivots[i]] / p->columns[c->pivots[j]];
        }
        if (!(distance < 0.1)) return false;
    }
    return true;
}

/* The error of X by its residual: |W_p^(-1)| (|W_f - W_p X| + |error of W_f| + |error of W_p| |X|), roundings counted. */
static void bound_follow(choice *c, const problem *p)
{
    const size_t n = p->n, k = p->rank, rest = n - k;
    const double rounding = (double)(k + 2) * roundoff;

    for (size_t j = 0; j < rest; j++) {
        double side[SIZE];
        for (size_t q = 0; q < k; q++) {
            const size_t f = q * n + c->others[j];
            double residual = p->w[f], size = fabs(p->w[f]), uncertain = p->w_error[f];
            for (size_t l = 0; l < k; l++) {
                const size_t at = q * n + c->pivots[l];
                const double x = c->follow[l * rest + j];
                residual -= p->w[at] * x;
                size += fabs(p->w[at] * x);
                uncertain += p->w_error[at] * fabs(x);
            }
            side[q] = fabs(residual) + rounding * size + uncertain;
        }
        for (size_t i = 0; i < k; i++) {
            double sum = 0.0;
            for (size_t q = 0; q < k; q++)
                if (side[q] != 0.0) sum += 1.2 * fabs(c->inverse[i * k + q]) * side[q];
            c->follow_error[i * rest + j] = sum;
        }
    }
}

/* A product of nonzero factors that underflows. */
static bool faint(double x, double y)
{
    return x != 0.0 && y != 0.0 && fabs(x * y) < DBL_MIN;
}

/* B and its error bound for one choice of pivots. */
static bool reduce(choice *c, const problem *p)
{
    const size_t n = p->n, k = p->rank, rest = n - k;
    double largest = 0.0, worst = 0.0;
    jlt_guard guard;
    bool regular, safe;

    jlt_guard_enter(&guard);
    regular = eliminate_guarded(c, p);
    safe = jlt_guard_leave(&guard) == JLT_OK;
    if (!regular || !inverts(c, p)) return false;
    bound_follow(c, p);
    for (size_t i = 0; i < rest; i++)
        for (size_t j = 0; j < rest; j++) {
            const size_t row = c->others[i] * n;
            double sum = 0.0, added = 0.0;
            for (size_t l = 0; l < k; l++) {
                const double x = c->follow[l * rest + j], before = p->a[row + c->pivots[l]];
                const double x_error = c->follow_error[l * rest + j], before_error = p->error[row + c->pivots[l]];
                if (before == 0.0 && before_error == 0.0) continue; /* whatever x is */
                /* What underflowed may not be small beside the entry of B it belongs to. */
                if (!safe || faint(before, x) || faint(before, x_error) || faint(before_error, x) ||
                    faint(before_error, x_error))
                    return false;
                sum += before * x;
                added += before_error * (fabs(x) + x_error) +
                         fabs(before) * (x_error + (double)(k + 1) * roundoff * fabs(x));
            }
            c->block[i * rest + j] = p->a[row + c->others[j]] - sum;
            if (sum != 0.0) added += roundoff * fabs(c->block[i * rest + j]);
            c->error[i * rest + j] = p->error[row + c->others[j]] + added;
            if (!isfinite(c->block[i * rest + j]) || !isfinite(c->error[i * rest + j])) return false;
            largest = fmax(largest, fabs(c->block[i * rest + j]));
            worst = fmax(worst, added);
        }
    c->merit = largest > 0.0 ? worst / largest : worst;
    return true;
}

/* The next ascending choice of k out of n; false after the last. */
static bool advance(size_t *pivots, size_t k, size_t n)
{
    for (size_t i = k; i-- > 0;)
        if (pivots[i] < n - k + i) {
            pivots[i]++;
            for (size_t j = i + 1; j < k; j++) pivots[j] = pivots[j - 1] + 1;
            return true;
        }
    return false;
}

static bool choose(choice *best, const problem *p)
{
    choice c;
    bool found = false;
    long tried = 0;

    for (size_t i = 0; i < p->rank; i++) c.pivots[i] = i;
    do {
        size_t count = 0, next = 0;
        for (size_t i = 0; i < p->n; i++) {
            if (next < p->rank && c.pivots[next] == i) next++;
            else c.others[count++] = i;
        }
        if (reduce(&c, p) && (!found || c.merit < best->merit)) {
            *best = c;
            found = true;
        }
    } while (++tried < CHOICES_MAX && advance(c.pivots, p->rank, p->n));
    return found;
}

/* At a relative equilibrium gradients are dependent, and what elimination leaves of one is rounding. A true left null
 * vector stays one; rounding does not: r A, r = `row` times the columns' scales, must stay below a thousandth of its terms'
 * sizes in every column. */
static bool annihilates(const double *row, const double *columns, const problem *p)
{
    const size_t n = p->n;
    double largest = 0.0;

    for (size_t i = 0; i < n; i++) largest = fmax(largest, fabs(row[i]));
    for (size_t j = 0; j < n; j++) {
        double sum = 0.0, size = 0.0;
        for (size_t i = 0; i < n; i++) {
            sum += row[i] * columns[i] * p->a[i * n + j];
            size += largest * columns[i] * fabs(p->a[i * n + j]);
        }
        if (fabs(sum) > 1e-3 * size) return false;
    }
    return true;
}

/* Keep gradients that are independent of those before them: rows and columns are scaled near one, and a row is left out
 * whose remainder after elimination falls below 1e-10, below its own error, or is rounding by what it does to A. */
static void independent(problem *p, const double *gradients, const double *errors, size_t count)
{
    const size_t n = p->n;
    double m[SIZE * SIZE], e[SIZE * SIZE], *columns = p->columns;
    size_t lead[SIZE];

    p->rank = 0;
    for (size_t r = 0; r < count; r++) {
        const int exponent = jlt_charpoly_exponent(gradients + r * n, n);
        for (size_t j = 0; j < n; j++) columns[j] = fmax(columns[j], fabs(ldexp(gradients[r * n + j], -exponent)));
    }
    for (size_t r = 0; r < count && p->rank < n; r++) {
        double *row = m + p->rank * n, *error = e + p->rank * n, *w = p->w + p->rank * n, *w_error = p->w_error + p->rank * n;
        const int exponent = jlt_charpoly_exponent(gradients + r * n, n);
        double largest = 0.0, left = 0.0;
        for (size_t j = 0; j < n; j++) {
            w[j] = ldexp(gradients[r * n + j], -exponent);
            w_error[j] = errors == NULL ? 8 * roundoff * fabs(w[j]) : ldexp(errors[r * n + j], -exponent);
            row[j] = columns[j] > 0.0 ? w[j] / columns[j] : 0.0;
            error[j] = columns[j] > 0.0 ? w_error[j] / columns[j] : 0.0;
            largest = fmax(largest, fabs(row[j]));
        }
        for (size_t i = 0; i < p->rank; i++) {
            const double factor = row[lead[i]] / m[i * n + lead[i]];
            const double slack = (error[lead[i]] + fabs(factor) * e[i * n + lead[i]]) / fabs(m[i * n + lead[i]]);
            for (size_t j = 0; j < n; j++) {
                error[j] += fabs(factor) * e[i * n + j] + slack * fabs(m[i * n + j]) + 2 * roundoff * fabs(row[j]);
                row[j] -= factor * m[i * n + j];
            }
            row[lead[i]] = 0.0;
        }
        for (size_t j = 0; j < n; j++)
            if (fabs(row[j]) > fmax(left, 4 * error[j])) {
                left = fabs(row[j]);
                lead[p->rank] = j;
            }
        if (left > 1e-10 * largest && annihilates(row, columns, p)) p->row[p->rank++] = (int)r;
    }
}

static double defect(const problem *p)
{
    double worst = 0.0;

    for (size_t i = 0; i < p->rank; i++)
        for (size_t j = 0; j < p->n; j++) {
            double sum = 0.0, size = 0.0;
            for (size_t l = 0; l < p->n; l++) {
                sum += p->w[i * p->n + l] * p->a[l * p->n + j];
                size += fabs(p->w[i * p->n + l] * p->a[l * p->n + j]);
            }
            if (size > 0.0) worst = fmax(worst, fabs(sum) / size);
        }
    return worst;
}

/* Rank of a by elimination with complete pivoting. */
static size_t rank_of(const double *a, size_t n)
{
    double m[SIZE * SIZE], first = 0.0;
    size_t rank = 0;

    memcpy(m, a, n * n * sizeof *m);
    for (; rank < n; rank++) {
        size_t row = rank, column = rank;
        for (size_t i = rank; i < n; i++)
            for (size_t j = rank; j < n; j++)
                if (fabs(m[i * n + j]) > fabs(m[row * n + column])) row = i, column = j;
        const double pivot = m[row * n + column];
        if (rank == 0) first = fabs(pivot);
        if (fabs(pivot) <= 32 * roundoff * first) break;
        for (size_t j = 0; j < n; j++) {
            const double held = m[rank * n + j];
            m[rank * n + j] = m[row * n + j];
            m[row * n + j] = held;
        }
        for (size_t i = 0; i < n; i++) {
            const double held = m[i * n + rank];
            m[i * n + rank] = m[i * n + column];
            m[i * n + column] = held;
        }
        for (size_t i = rank + 1; i < n; i++) {
            const double factor = m[i * n + rank] / pivot;
            for (size_t j = rank; j < n; j++) m[i * n + j] -= factor * m[rank * n + j];
        }
    }
    return rank;
}

static double norm(const double *values, size_t count)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) sum += values[i] * values[i];
    return sqrt(sum);
}

/* |x| |y| / |v u| of the whole matrix for an eigenvalue of B: u, v from the adjugate of B,
 * x = ((A_pf - A_pp W_p^(-1) W_f) u / lambda, u) and y = A_f^T v / lambda. */
static double condition(const problem *p, const choice *c, double re, double im)
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
    return product == 0.0 ? INFINITY : sqrt(x2) * (sqrt(y2) / lambda) / product;
}

/* Rows and columns of B that are still coupled, after those whose eigenvalue stands on the diagonal are taken out: an
 * exact permutation to block triangular form. */
typedef struct {
    size_t count, index[SIZE];
} coupled;

static bool isolated(const choice *c, const coupled *active, size_t rest, size_t at)
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

/* Eigenvalues on the diagonal, as many as there are, to the front of re, im, error; returns how many. */
static size_t take_isolated(double *re, double *im, double *error, coupled *active, const choice *c, size_t rest)
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

/* A coupled block of three rows or more, by GSL. First order where an eigenvalue is simple enough, Elsner's bound in any
 * case (L. Elsner, Linear Algebra Appl. 71, 1985). */
static jlt_status solve_large(double *re, double *im, double *error, const double *block, const double *block_error,
                              size_t n)
{
    const double size = norm(block, n * n), noise = norm(block_error, n * n) + 10 * (double)n * roundoff * size;
    const jlt_status st = jlt_eigen_values(re, im, block, n);

    if (st != JLT_OK) return st;
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

/* Eigenvalues of B with error bounds, those on the diagonal of a triangular part as they are, pairs in closed form. */
static jlt_status solve_block(double *re, double *im, double *error, const problem *p, const choice *c)
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

/* Ascending in (re, im), the errors along. */
static void sort_ascending(double *re, double *im, double *error, size_t n)
{
    for (size_t i = 1; i < n; i++)
        for (size_t j = i; j > 0; j--) {
            const double held[3] = { re[j], im[j], error[j] };
            if (re[j - 1] < re[j] || (!(re[j - 1] > re[j]) && im[j - 1] <= im[j])) break;
            re[j] = re[j - 1], im[j] = im[j - 1], error[j] = error[j - 1];
            re[j - 1] = held[0], im[j - 1] = held[1], error[j - 1] = held[2];
        }
}

/* The largest distance from a value of one list to the nearest of the other. */
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

/* The same eigenvalues by other routes. */
static jlt_status cross_check(jlt_deflation *result, const problem *p, const choice *c)
{
    const size_t n = p->n, rest = n - p->rank;
    const double size = fmax(norm(p->a, n * n), DBL_MIN);
    double re[SIZE], im[SIZE], other_re[SIZE], other_im[SIZE];
    size_t nonzero = 0, wanted, found = 0;
    jlt_status st;

    for (size_t i = 0; i < n; i++) {
        re[i] = result->values[i].re;
        im[i] = result->values[i].im;
        nonzero += re[i] != 0.0 || im[i] != 0.0;
    }
    st = jlt_eigen_values(other_re, other_im, c->block, rest);
    if (st != JLT_OK) return st;
    result->gsl_difference = farthest(re + p->rank, im + p->rank, rest, other_re, other_im, rest) / size;
    st = jlt_eigen_values(other_re, other_im, p->a, n);
    if (st != JLT_OK) return st;
    result->plain_difference = fmax(farthest(re, im, n, other_re, other_im, n),
                                    farthest(other_re, other_im, n, re, im, n)) / size;
    result->arpack_difference = NAN;
    result->arpack_note = "";
    if (n < 3) result->arpack_note = "ARPACK needs three rows";
    else if (nonzero == 0) result->arpack_note = "no eigenvalue differs from zero";
    if (result->arpack_note[0] != '\0') return JLT_OK;
    wanted = nonzero < n - 2 ? nonzero : n - 2;
    st = jlt_arpack_largest(other_re, other_im, &found, p->a, n, wanted);
    if (st == JLT_ERR_NOMEM) return st;
    if (st != JLT_OK || found == 0) result->arpack_note = "ARPACK did not converge";
    else result->arpack_difference = farthest(other_re, other_im, found, re, im, n) / size;
    return JLT_OK;
}

static jlt_status set_up(problem *p, const double *a, const double *error, size_t n, const double *gradients,
                         const double *gradient_error, size_t count)
{
    p->n = n;
    p->exponent = jlt_charpoly_exponent(a, n * n);
    for (size_t i = 0; i < n * n; i++) {
        if (!isfinite(a[i]) || (error != NULL && !isfinite(error[i]))) return JLT_ERR_NONFINITE;
        p->a[i] = ldexp(a[i], -p->exponent);
        if (a[i] != 0.0 && !isnormal(p->a[i])) return JLT_ERR_NONFINITE;
        p->error[i] = error == NULL ? 4 * roundoff * fabs(p->a[i]) : ldexp(error[i], -p->exponent);
    }
    for (size_t i = 0; i < count * n; i++)
        if (!isfinite(gradients[i]) || (gradient_error != NULL && !isfinite(gradient_error[i]))) return JLT_ERR_NONFINITE;
    independent(p, gradients, gradient_error, count);
    for (size_t i = 0; i < p->rank; i++)
        for (size_t j = 0; j < n; j++)
            if (gradients[(size_t)p->row[i] * n + j] != 0.0 && !isnormal(p->w[i * n + j])) return JLT_ERR_NONFINITE;
    return JLT_OK;
}

/* Eigenvalues of B, or of A itself when no choice of pivots gives a usable B: those that the integrals make zero must then
 * show on the diagonal of A's triangular part, as exact zeros. Out: the others, ascending; *zeros attributed. */
static jlt_status solve_problem(double *re, double *im, double *errors, size_t *attributed, problem *p, choice *best)
{
    const size_t n = p->n, rank = p->rank;
    size_t kept = 0, exact = 0;
    jlt_status st;

    *attributed = rank;
    if (choose(best, p) && best->merit <= merit_limit) {
        st = solve_block(re, im, errors, p, best);
        if (st == JLT_OK) sort_ascending(re, im, errors, n - rank);
        return st;
    }
    p->rank = 0;
    if (!choose(best, p)) return JLT_ERR_NONFINITE;
    st = solve_block(re, im, errors, p, best);
    if (st != JLT_OK) return st;
    for (size_t i = 0; i < n; i++) {
        if (re[i] == 0.0 && im[i] == 0.0 && errors[i] == 0.0 && exact < rank) {
            exact++;
            continue;
        }
        re[kept] = re[i], im[kept] = im[i], errors[kept++] = errors[i];
    }
    sort_ascending(re, im, errors, kept);
    *attributed = exact;
    return exact == rank ? JLT_OK : JLT_ERR_NO_CONVERGENCE;
}

jlt_status jlt_deflation_compute(jlt_deflation *result, const double *a, const double *error, size_t n,
                                 const double *gradients, const double *gradient_error, size_t count)
{
    problem p = { 0 };
    choice best = { 0 };
    jlt_deflation r = { 0 };
    double re[SIZE], im[SIZE], errors[SIZE];
    size_t attributed, zeros;
    jlt_status st;

    if (n == 0 || n > SIZE || count > SIZE) return JLT_ERR_ARG;
    JLT_TRY(set_up(&p, a, error, n, gradients, gradient_error, count));
    r.defect = defect(&p);
    JLT_TRY(solve_problem(re, im, errors, &attributed, &p, &best));
    r.n = n;
    r.kept = n - attributed;
    zeros = attributed;
    for (size_t i = 0; i < attributed; i++) r.values[i] = (jlt_eigenvalue){ 0.0, 0.0, NAN, 0.0, p.row[i] };
    for (size_t i = 0; i < r.kept; i++) {
        r.values[attributed + i] = (jlt_eigenvalue){ re[i], im[i], condition(&p, &best, re[i], im[i]), errors[i], -1 };
        zeros += hypot(re[i], im[i]) <= errors[i];
    }
    r.defective_zero = zeros > attributed && n - rank_of(p.a, n) < zeros;
    JLT_TRY(cross_check(&r, &p, &best));
    for (size_t i = 0; i < n; i++) {
        jlt_eigenvalue *value = &r.values[i];
        const bool small = value->re == 0.0 && value->im == 0.0;
        value->re = ldexp(value->re, p.exponent);
        value->im = ldexp(value->im, p.exponent);
        value->error = ldexp(value->error, p.exponent);
        if (!isfinite(value->re) || !isfinite(value->im) || (!small && !isnormal(hypot(value->re, value->im))))
            st = JLT_ERR_NONFINITE;
        if (small && value->source < 0 && r.defective_zero) value->condition = INFINITY;
    }
    if (st == JLT_OK) *result = r;
done:
    return st;
}
