#include "analysis/deflation_problem.h"

#include "analysis/charpoly.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { SIZE = JLT_DEFLATION_SIZE_MAX };

static const double roundoff = DBL_EPSILON / 2;

/* Whether a row is not just rounding errors, the rest of some gradients after elimination at a relative equilibrium, where these
 * depend on each other: an exact left null vector r satisfies r A = 0, unlike a row of rounding errors. r, `row` times the columns'
 * scales, passes if r A is at most a thousandth of the size of its terms in every column. */
static bool annihilates(const double *row, const double *columns, const jlt_deflation_problem *p)
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

/* Select the gradients that are independent of those before them. Rows and columns are scaled to the order of 1; a row is dropped
 * if its remainder after elimination is below 1e-10 or below its own error, or does not annihilate A. */
static void independent(jlt_deflation_problem *p, const double *gradients, const double *errors, size_t count)
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

double jlt_deflation_problem_defect(const jlt_deflation_problem *p)
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

static void swap_entries(double *m, size_t a, size_t b)
{
    const double held = m[a];
    m[a] = m[b];
    m[b] = held;
}

void jlt_deflation_problem_rank(size_t *least, size_t *most, const jlt_deflation_problem *p)
{
    const size_t n = p->n;
    double m[SIZE * SIZE], e[SIZE * SIZE];
    size_t rank = 0, row, column;

    memcpy(m, p->a, n * n * sizeof *m);
    memcpy(e, p->error, n * n * sizeof *e);
    for (; rank < n; rank++) {
        row = column = rank;
        for (size_t i = rank; i < n; i++)
            for (size_t j = rank; j < n; j++)
                if (fabs(m[i * n + j]) - e[i * n + j] > fabs(m[row * n + column]) - e[row * n + column]) row = i, column = j;
        const double pivot = m[row * n + column], certain = fabs(pivot) - e[row * n + column];
        if (!(certain > 0.0)) break;
        for (size_t j = 0; j < n; j++) swap_entries(m, rank * n + j, row * n + j), swap_entries(e, rank * n + j, row * n + j);
        for (size_t i = 0; i < n; i++) swap_entries(m, i * n + rank, i * n + column), swap_entries(e, i * n + rank, i * n + column);
        for (size_t i = rank + 1; i < n; i++) {
            const double factor = m[i * n + rank] / pivot;
            const double slack = (e[i * n + rank] + fabs(factor) * e[rank * n + rank]) / certain + 2 * roundoff * fabs(factor);
            if (factor == 0.0 && slack == 0.0) continue;
            for (size_t j = rank + 1; j < n; j++) {
                const double change = factor * m[rank * n + j];
                e[i * n + j] += fabs(factor) * e[rank * n + j] + slack * (fabs(m[rank * n + j]) + e[rank * n + j]);
                m[i * n + j] -= change;
                if (change != 0.0) e[i * n + j] += 2 * roundoff * (fabs(m[i * n + j]) + fabs(change));
            }
        }
    }
    *least = *most = rank;
    for (size_t i = rank; i < n; i++)
        for (size_t j = rank; j < n; j++)
            if (m[i * n + j] != 0.0 || e[i * n + j] > 0.0) *most = n;
}

jlt_status jlt_deflation_problem_set(jlt_deflation_problem *p, const double *a, const double *error, size_t n,
                                     const double *gradients, const double *gradient_error, size_t count)
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
