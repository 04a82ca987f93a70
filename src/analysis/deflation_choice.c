/* Chooses the pivots of a deflation (analysis/deflation.h) for the smallest bound on rounding errors. */
#include "analysis/deflation_problem.h"

#include "analysis/charpoly.h"
#include "core/guard.h"

#include <float.h>
#include <math.h>

enum { SIZE = JLT_DEFLATION_SIZE_MAX };

static const double roundoff = DBL_EPSILON / 2;

/* Reduce [W_p W_f E], by elimination with row pivoting and scaled rows, to [E X W_p^(-1)]. Returns false if W_p is singular. */
static bool eliminate(jlt_deflation_choice *c, const jlt_deflation_problem *p)
{
    const size_t k = p->rank, rest = p->n - k, width = p->n + k;
    double m[SIZE * 2 * SIZE] = { 0 };

    for (size_t i = 0; i < k; i++) {
        for (size_t j = 0; j < k; j++) m[i * width + j] = p->w[i * p->n + c->pivots[j]];
        for (size_t j = 0; j < rest; j++) m[i * width + k + j] = p->w[i * p->n + c->others[j]];
        m[i * width + p->n + i] = 1.0;
    }
    for (size_t i = 0; i < k; i++) {
        const int exponent = jlt_charpoly_exponent(m + i * width, k);
        for (size_t l = 0; l < width; l++) m[i * width + l] = ldexp(m[i * width + l], -exponent);
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

/* Called through a volatile pointer, so that the compiler cannot move arithmetic of the elimination out of the guard. */
static bool (*volatile eliminate_guarded)(jlt_deflation_choice *, const jlt_deflation_problem *) = eliminate;

/* Whether C approximates the inverse of every W_p within its errors: |E - C W_p| + |C| |error of W_p| < 1/10, columns scaled. */
static bool inverts(const jlt_deflation_choice *c, const jlt_deflation_problem *p)
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

/* Bound the error of X from its residual: |W_p^(-1)| (|W_f - W_p X| + |error of W_f| + |error of W_p| |X|), rounding included. */
static void bound_follow(jlt_deflation_choice *c, const jlt_deflation_problem *p)
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

/* Whether a product of nonzero factors underflows. */
static bool faint(double x, double y)
{
    return x != 0.0 && y != 0.0 && fabs(x * y) < DBL_MIN;
}

/* Compute B and its error bound for one choice of pivots. Returns false if the choice is unusable. */
static bool reduce(jlt_deflation_choice *c, const jlt_deflation_problem *p)
{
    const size_t n = p->n, k = p->rank, rest = n - k;
    double largest = 0.0, worst = 0.0;
    jlt_guard guard;
    bool invertible, safe;

    jlt_guard_enter(&guard);
    invertible = eliminate_guarded(c, p);
    safe = jlt_guard_leave(&guard) == JLT_OK;
    if (!invertible || !inverts(c, p)) return false;
    bound_follow(c, p);
    for (size_t i = 0; i < rest; i++)
        for (size_t j = 0; j < rest; j++) {
            const size_t row = c->others[i] * n;
            double sum = 0.0, added = 0.0;
            for (size_t l = 0; l < k; l++) {
                const double x = c->follow[l * rest + j], before = p->a[row + c->pivots[l]];
                const double x_error = c->follow_error[l * rest + j], before_error = p->error[row + c->pivots[l]];
                if (before == 0.0 && before_error == 0.0) continue; /* contributes nothing, whatever x is */
                /* A quantity that underflowed may not be small relative to its entry of B. */
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

/* The next choice of k out of n in lexicographic order. Returns false after the last. */
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

bool jlt_deflation_problem_choose(jlt_deflation_choice *best, const jlt_deflation_problem *problem)
{
    jlt_deflation_choice c;
    bool found = false;

    for (size_t i = 0; i < problem->rank; i++) c.pivots[i] = i;
    do {
        size_t count = 0, next = 0;
        for (size_t i = 0; i < problem->n; i++) {
            if (next < problem->rank && c.pivots[next] == i) next++;
            else c.others[count++] = i;
        }
        if (reduce(&c, problem) && (!found || c.merit < best->merit)) {
            *best = c;
            found = true;
        }
    } while (advance(c.pivots, problem->rank, problem->n));
    return found;
}
