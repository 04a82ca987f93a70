#include "ext/ball_point.h"

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

#include <math.h>

enum { SIZE = JLT_BALL_SIZE_MAX, FARTHEST = 100 };

bool jlt_ball_point_set(arb_t out, const jlt_ball_value *value, slong precision)
{
    fmpq_t exact;
    bool good = true;

    if (value->fraction == NULL) {
        arb_set_d(out, value->value);
        return isfinite(value->value);
    }
    fmpq_init(exact);
    good = fmpq_set_str(exact, value->fraction, 10) == 0 && !fmpz_is_zero(fmpq_denref(exact));
    if (good) {
        fmpq_canonicalise(exact);
        arb_set_fmpq(out, exact, precision);
    }
    fmpq_clear(exact);
    return good;
}

static bool vanishes(const jlt_ball_table *table, arb_srcptr x, arb_srcptr params, slong precision)
{
    arb_ptr f = _arb_vec_init(table->state_count);
    bool zero = true;

    table->rhs(f, x, params, precision);
    for (unsigned i = 0; i < table->state_count; i++) zero = zero && arb_is_finite(f + i) && arb_contains_zero(f + i);
    _arb_vec_clear(f, table->state_count);
    return zero;
}

/* Equations and states in the order of complete pivoting on the Jacobian in units of what is within reach; returns how many
 * pivots there are. Doubles suffice: the order is a guess that the field's vanishing confirms. */
static unsigned order(unsigned *rows, unsigned *columns, const jlt_ball_table *table, arb_srcptr x, arb_srcptr params,
                      const double *reach, slong precision)
{
    const unsigned n = table->state_count;
    arb_ptr jacobian = _arb_vec_init((slong)n * n);
    double m[SIZE * SIZE];
    unsigned rank = 0;

    table->jacobian(jacobian, x, params, precision);
    for (unsigned i = 0; i < n; i++) {
        double largest = 0.0;
        rows[i] = columns[i] = i;
        for (unsigned j = 0; j < n; j++) {
            m[i * n + j] = reach[j] * arf_get_d(arb_midref(jacobian + i * n + j), ARF_RND_NEAR);
            largest = fmax(largest, fabs(m[i * n + j]));
        }
        for (unsigned j = 0; j < n && largest > 0.0; j++) m[i * n + j] /= largest;
    }
    _arb_vec_clear(jacobian, (slong)n * n);
    for (; rank < n; rank++) {
        unsigned row = rank, column = rank, held;
        for (unsigned i = rank; i < n; i++)
            for (unsigned j = rank; j < n; j++)
                if (fabs(m[rows[i] * n + columns[j]]) > fabs(m[rows[row] * n + columns[column]])) row = i, column = j;
        held = rows[rank], rows[rank] = rows[row], rows[row] = held;
        held = columns[rank], columns[rank] = columns[column], columns[column] = held;
        const double pivot = m[rows[rank] * n + columns[rank]];
        if (!(fabs(pivot) > 0.0)) break;
        for (unsigned i = rank + 1; i < n; i++) {
            const double factor = m[rows[i] * n + columns[rank]] / pivot;
            for (unsigned j = rank; j < n; j++) m[rows[i] * n + columns[j]] -= factor * m[rows[rank] * n + columns[j]];
        }
    }
    return rank;
}

/* One Newton step of `rank` equations in as many states, in place; step, shape (rank, 1), is what was taken off. */
static bool advance(arb_ptr x, arb_mat_t step, const jlt_ball_table *table, arb_srcptr params, const unsigned *rows,
                    const unsigned *columns, unsigned rank, slong precision)
{
    const unsigned n = table->state_count;
    arb_ptr f = _arb_vec_init(n), jacobian = _arb_vec_init((slong)n * n);
    arb_mat_t a, b;
    bool good;

    arb_mat_init(a, rank, rank);
    arb_mat_init(b, rank, 1);
    table->rhs(f, x, params, precision);
    table->jacobian(jacobian, x, params, precision);
    for (unsigned i = 0; i < rank; i++) {
        arb_set(arb_mat_entry(b, i, 0), f + rows[i]);
        for (unsigned j = 0; j < rank; j++) arb_set(arb_mat_entry(a, i, j), jacobian + rows[i] * n + columns[j]);
    }
    good = arb_mat_solve(step, a, b, precision);
    for (unsigned i = 0; good && i < rank; i++) {
        arb_sub(x + columns[i], x + columns[i], arb_mat_entry(step, i, 0), precision);
        arb_get_mid_arb(x + columns[i], x + columns[i]);
    }
    arb_mat_clear(b);
    arb_mat_clear(a);
    _arb_vec_clear(jacobian, (slong)n * n);
    _arb_vec_clear(f, n);
    return good;
}

static bool near(arb_srcptr x, arb_srcptr start, const double *reach, unsigned n, slong precision)
{
    arb_t distance, limit;
    bool good = true;

    arb_init(distance);
    arb_init(limit);
    for (unsigned j = 0; j < n; j++) {
        arb_sub(distance, x + j, start + j, precision);
        arb_abs(distance, distance);
        arb_set_d(limit, FARTHEST * reach[j]);
        good = good && (arb_contains_zero(distance) || arb_lt(distance, limit));
    }
    arb_clear(limit);
    arb_clear(distance);
    return good;
}

/* Newton's method from x, whose digits double a step; then x with its errors. */
static bool refine(arb_ptr x, const jlt_ball_table *table, arb_srcptr params, const unsigned *rows, const unsigned *columns,
                   unsigned rank, slong precision)
{
    arb_mat_t step;
    bool good = true;

    arb_mat_init(step, rank, 1);
    for (slong digits = 16; good && digits < 8 * precision; digits *= 2)
        good = advance(x, step, table, params, rows, columns, rank, precision);
    for (unsigned i = 0; good && i < rank; i++) {
        mag_t error;
        mag_init(error);
        arb_get_mag(error, arb_mat_entry(step, i, 0));
        mag_mul_2exp_si(error, error, 1);
        arb_add_error_mag(x + columns[i], error);
        arb_get_mag(error, x + columns[i]);
        mag_mul_2exp_si(error, error, 4 - precision);
        arb_add_error_mag(x + columns[i], error);
        mag_clear(error);
    }
    arb_mat_clear(step);
    return good;
}

bool jlt_ball_point_find(arb_ptr x, const jlt_ball_table *table, arb_srcptr params, const jlt_ball_question *question,
                         slong precision)
{
    const unsigned n = table->state_count;
    arb_ptr start = _arb_vec_init(n), trial = _arb_vec_init(n);
    unsigned rows[SIZE], columns[SIZE], most = 0;
    bool found = true;

    for (unsigned j = 0; found && j < n; j++) found = jlt_ball_point_set(start + j, &question->states[j], precision);
    if (found) {
        _arb_vec_set(trial, start, n);
        found = vanishes(table, trial, params, precision);
        if (!found) most = order(rows, columns, table, start, params, question->reach, precision);
    }
    for (unsigned rank = 1; !found && rank <= most; rank++) {
        for (unsigned j = 0; j < n; j++) arb_get_mid_arb(trial + j, start + j);
        found = refine(trial, table, params, rows, columns, rank, precision) &&
                near(trial, start, question->reach, n, precision) && vanishes(table, trial, params, precision);
    }
    if (found) _arb_vec_set(x, trial, n);
    _arb_vec_clear(trial, n);
    _arb_vec_clear(start, n);
    return found;
}
