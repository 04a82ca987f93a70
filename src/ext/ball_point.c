#include "ext/ball_point.h"

#include "ext/scoped.h"

#include <math.h>
#include <string.h>

enum { SIZE = JLT_BALL_SIZE_MAX, FARTHEST = 100, THINNINGS = 3 };

/* The equations rows[0 .. rank - 1] of the field, to be solved for the states columns[0 .. rank - 1]. */
typedef struct {
    const jlt_ball_table *table;
    const jlt_ball_question *question;
    arb_srcptr params;
    slong precision;
    unsigned n, rank, rows[SIZE], columns[SIZE];
} system_of;

bool jlt_ball_point_set(arb_t out, const jlt_ball_value *value, slong precision)
{
    bool good = true;

    if (value->fraction == NULL) {
        arb_set_d(out, value->value);
        return isfinite(value->value);
    }
    JLT_SCOPED(fmpq, exact);
    good = fmpq_set_str(exact, value->fraction, 10) == 0 && !fmpz_is_zero(fmpq_denref(exact));
    if (good) {
        fmpq_canonicalise(exact);
        arb_set_fmpq(out, exact, precision);
    }
    return good;
}

bool jlt_ball_point_fixed(arb_srcptr x, const signed char *signs, size_t states)
{
    for (size_t i = 0; i < states; i++)
        if (signs[i] < 0 && !arb_is_zero(x + i)) return false;
    return true;
}

slong jlt_ball_point_integral(const jlt_ball_table *table, const char *name)
{
    for (unsigned i = 0; i < table->integral_count; i++)
        if (strcmp(table->integral[i], name) == 0) return (slong)i;
    return -1;
}

static jlt_ball_point vanishes(const system_of *s, arb_srcptr x)
{
    JLT_SCOPED_VECTOR(arb, f, s->n);
    bool zero = true, exactly = true;

    s->table->rhs(f, x, s->params, s->precision);
    for (unsigned i = 0; i < s->n; i++) {
        zero = zero && arb_is_finite(f + i) && arb_contains_zero(f + i);
        exactly = exactly && arb_is_zero(f + i);
    }
    return exactly ? JLT_BALL_POINT_PROVED : zero ? JLT_BALL_POINT_NEAR : JLT_BALL_POINT_NONE;
}

/* Order equations and states by complete pivoting on the Jacobian, with the derivative by state j scaled by reach[j]; returns the
 * number of nonzero pivots. If `hold`, states with a fraction get no pivot. Doubles suffice: the order is a guess that is
 * confirmed when the whole field vanishes. */
static unsigned order(system_of *s, arb_srcptr x, bool hold)
{
    const unsigned n = s->n;
    JLT_SCOPED_VECTOR(arb, jacobian, (slong)n * n);
    double m[SIZE * SIZE];
    unsigned rank = 0, *rows = s->rows, *columns = s->columns;

    s->table->jacobian(jacobian, x, s->params, s->precision);
    for (unsigned i = 0; i < n; i++) {
        double largest = 0.0;
        rows[i] = columns[i] = i;
        for (unsigned j = 0; j < n; j++) {
            const bool held = hold && s->question->states[j].fraction != NULL;
            m[i * n + j] = held ? 0.0 : s->question->reach[j] * arf_get_d(arb_midref(jacobian + i * n + j), ARF_RND_NEAR);
            largest = fmax(largest, fabs(m[i * n + j]));
        }
        for (unsigned j = 0; j < n && largest > 0.0; j++) m[i * n + j] /= largest;
    }
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

/* Evaluate the system's equations at x, f, shape (rank, 1), and their derivatives by its states, slopes, shape (rank, rank). */
static void evaluate(arb_mat_t f, arb_mat_t slopes, const system_of *s, arb_srcptr x)
{
    const unsigned n = s->n;
    JLT_SCOPED_VECTOR(arb, all, n);
    JLT_SCOPED_VECTOR(arb, jacobian, (slong)n * n);

    s->table->rhs(all, x, s->params, s->precision);
    s->table->jacobian(jacobian, x, s->params, s->precision);
    for (unsigned i = 0; i < s->rank; i++) {
        arb_set(arb_mat_entry(f, i, 0), all + s->rows[i]);
        for (unsigned j = 0; j < s->rank; j++) arb_set(arb_mat_entry(slopes, i, j), jacobian + s->rows[i] * n + s->columns[j]);
    }
}

/* One Newton step in place: x -= step, shape (rank, 1). Returns false if the Jacobian is not invertible. */
static bool advance(arb_ptr x, arb_mat_t step, const system_of *s)
{
    bool good;
    JLT_SCOPED_MATRIX(arb, s->rank, 1, f);
    JLT_SCOPED_MATRIX(arb, s->rank, s->rank, slopes);

    evaluate(f, slopes, s, x);
    good = arb_mat_solve(step, slopes, f, s->precision);
    for (unsigned i = 0; good && i < s->rank; i++) {
        arb_sub(x + s->columns[i], x + s->columns[i], arb_mat_entry(step, i, 0), s->precision);
        arb_get_mid_arb(x + s->columns[i], x + s->columns[i]);
    }
    return good;
}

static bool near(const system_of *s, arb_srcptr x, arb_srcptr start)
{
    bool good = true;
    JLT_SCOPED(arb, distance, limit);

    for (unsigned j = 0; j < s->n; j++) {
        arb_sub(distance, x + j, start + j, s->precision);
        arb_abs(distance, distance);
        arb_set_d(limit, FARTHEST * s->question->reach[j]);
        good = good && (arb_contains_zero(distance) || arb_lt(distance, limit));
    }
    return good;
}

/* The largest modulus of the system's states. A state whose exact value is 0 has rounding errors of the size of the others. */
static void size_of(mag_t size, arb_srcptr x, const system_of *s)
{
    JLT_SCOPED(mag, one);

    mag_zero(size);
    for (unsigned i = 0; i < s->rank; i++) {
        arb_get_mag(one, x + s->columns[i]);
        mag_max(size, size, one);
    }
}

/* Newton's method from x, doubling the digits each step; then widen x by error estimates: twice the last step, and roundoff. */
static bool refine(arb_ptr x, const system_of *s)
{
    bool good = true;
    JLT_SCOPED_MATRIX(arb, s->rank, 1, step);

    for (slong digits = 16; good && digits < 8 * s->precision; digits *= 2) good = advance(x, step, s);
    JLT_SCOPED(mag, size);
    size_of(size, x, s);
    mag_mul_2exp_si(size, size, 4 - s->precision);
    for (unsigned i = 0; good && i < s->rank; i++) {
        arb_ptr state = x + s->columns[i];
        JLT_SCOPED(mag, error);
        arb_get_mag(error, arb_mat_entry(step, i, 0));
        mag_mul_2exp_si(error, error, 1);
        arb_add_error_mag(state, error);
        arb_add_error_mag(state, size);
    }
    return good;
}

/* Krawczyk's operator K(X) = c - Y F(c) + (1 - Y F'(X))(X - c), with c the midpoint of X and Y an approximate inverse of F'(c). If
 * K(X) lies in the interior of X, so that both contain a solution, replace X by K(X) and return true. */
static bool contract(arb_ptr x, const system_of *s)
{
    const slong rank = s->rank;
    JLT_SCOPED_VECTOR(arb, middle, s->n);
    bool inside;
    JLT_SCOPED_MATRIX(arb, rank, 1, f, off, moved);
    JLT_SCOPED_MATRIX(arb, rank, rank, slopes, inverse, image);

    _arb_vec_set(middle, x, s->n);
    for (slong i = 0; i < rank; i++) {
        arb_get_mid_arb(middle + s->columns[i], x + s->columns[i]);
        arb_sub(arb_mat_entry(off, i, 0), x + s->columns[i], middle + s->columns[i], s->precision);
    }
    evaluate(f, slopes, s, middle);
    arb_mat_get_mid(image, slopes);
    inside = arb_mat_inv(inverse, image, s->precision);
    arb_mat_get_mid(inverse, inverse);
    arb_mat_mul(moved, inverse, f, s->precision);
    evaluate(f, slopes, s, x);
    arb_mat_mul(image, inverse, slopes, s->precision);
    arb_mat_one(slopes);
    arb_mat_sub(image, slopes, image, s->precision);
    arb_mat_mul(f, image, off, s->precision);
    for (slong i = 0; i < rank; i++) {
        arb_ptr value = middle + s->columns[i];
        arb_sub(value, value, arb_mat_entry(moved, i, 0), s->precision);
        arb_add(value, value, arb_mat_entry(f, i, 0), s->precision);
        inside = inside && arb_is_finite(value) && arb_contains_interior(x + s->columns[i], value);
    }
    if (inside) _arb_vec_set(x, middle, s->n);
    return inside;
}

/* Apply Krawczyk's test to a ball with a relative radius of half the precision; if it succeeds, contract the ball further. */
static bool contains_solution(arb_ptr x, const system_of *s)
{
    JLT_SCOPED_VECTOR(arb, wide, s->n);
    bool proved;

    _arb_vec_set(wide, x, s->n);
    JLT_SCOPED(mag, room);
    size_of(room, x, s);
    mag_mul_2exp_si(room, room, -s->precision / 2);
    for (unsigned i = 0; i < s->rank; i++) arb_add_error_mag(wide + s->columns[i], room);
    proved = contract(wide, s);
    for (int k = 1; proved && k < THINNINGS; k++) (void)contract(wide, s);
    if (proved) _arb_vec_set(x, wide, s->n);
    return proved;
}

/* List the equations outside the system that neither hold identically nor follow from a reversor; returns their number. */
static unsigned leftover(unsigned *left, const system_of *s, arb_srcptr x)
{
    JLT_SCOPED_VECTOR(arb, f, s->n);
    unsigned count = 0;

    s->table->rhs(f, x, s->params, s->precision);
    for (unsigned i = s->rank; i < s->n; i++) {
        bool holds = arb_is_zero(f + s->rows[i]);
        for (size_t k = 0; k < s->question->reversor_count; k++) {
            const signed char *signs = s->question->reversors[k];
            holds = holds || (signs[s->rows[i]] > 0 && jlt_ball_point_fixed(x, signs, s->n));
        }
        if (!holds) left[count++] = s->rows[i];
    }
    return count;
}

/* Whether all other equations hold wherever those of the system do. */
static bool others_follow(const system_of *s, arb_srcptr x)
{
    const jlt_ball_question *q = s->question;
    const slong integrals = (slong)q->integral_count;
    unsigned left[SIZE];
    const slong count = leftover(left, s, x);

    if (count == 0) return true;
    if (integrals < count || s->table->integral_gradients == NULL) return false;
    JLT_SCOPED_VECTOR(arb, gradients, (slong)s->table->integral_count * s->n);
    s->table->integral_gradients(gradients, x, s->params, s->precision);
    JLT_SCOPED_MATRIX(arb, integrals, count, w);
    JLT_SCOPED_MATRIX(arb, count, integrals, transposed);
    JLT_SCOPED_MATRIX(arb, count, count, gram);
    JLT_SCOPED(arb, determinant);
    for (slong i = 0; i < integrals; i++) {
        const slong index = jlt_ball_point_integral(s->table, q->integrals[i]);
        for (slong j = 0; index >= 0 && j < count; j++) arb_set(arb_mat_entry(w, i, j), gradients + index * s->n + left[j]);
    }
    arb_mat_transpose(transposed, w);
    arb_mat_mul(gram, transposed, w, s->precision);
    arb_mat_det(determinant, gram, s->precision);
    return arb_is_finite(determinant) && !arb_contains_zero(determinant);
}

/* Newton's method with 1, 2, ... equations until an equilibrium is proved. Returns the better of `found` and the best result here;
 * sets x only if the latter is better. */
static jlt_ball_point search(arb_ptr x, jlt_ball_point found, system_of *s, arb_srcptr start, bool hold)
{
    const unsigned most = order(s, start, hold);
    JLT_SCOPED_VECTOR(arb, trial, s->n);
    jlt_ball_point here;

    for (s->rank = 1; found != JLT_BALL_POINT_PROVED && s->rank <= most; s->rank++) {
        _arb_vec_set(trial, start, s->n);
        for (unsigned j = 0; j < s->rank; j++) arb_get_mid_arb(trial + s->columns[j], start + s->columns[j]);
        if (!refine(trial, s) || !near(s, trial, start) || vanishes(s, trial) == JLT_BALL_POINT_NONE) continue;
        here = contains_solution(trial, s) && others_follow(s, trial) ? JLT_BALL_POINT_PROVED : JLT_BALL_POINT_NEAR;
        if (here <= found) continue;
        _arb_vec_set(x, trial, s->n);
        found = here;
    }
    return found;
}

jlt_ball_point jlt_ball_point_find(arb_ptr x, const jlt_ball_table *table, arb_srcptr params, const jlt_ball_question *question,
                                   slong precision)
{
    system_of s = { .table = table, .question = question, .params = params, .precision = precision, .n = table->state_count };
    JLT_SCOPED_VECTOR(arb, start, s.n);
    jlt_ball_point found = JLT_BALL_POINT_NONE;
    bool good = true;

    for (unsigned j = 0; good && j < s.n; j++) good = jlt_ball_point_set(start + j, &question->states[j], precision);
    if (good) found = vanishes(&s, start);
    if (found != JLT_BALL_POINT_NONE) _arb_vec_set(x, start, s.n);
    if (good && found != JLT_BALL_POINT_PROVED) found = search(x, found, &s, start, true);
    if (good && found != JLT_BALL_POINT_PROVED) found = search(x, found, &s, start, false);
    return found;
}
