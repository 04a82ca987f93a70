#include "ext/ball_spectrum.h"

#include "ext/ball_problem.h"

#include <stdlib.h>

enum { SIZE = JLT_BALL_SIZE_MAX, FIRST_PRECISION = 192, LAST_PRECISION = 6144 };

static void begin(jlt_ball_problem *p, const jlt_ball_question *question, slong precision)
{
    *p = (jlt_ball_problem){ .table = question->table, .question = question, .precision = precision };
    p->n = p->table->state_count;
    p->params = _arb_vec_init(p->table->param_count);
    p->x = _arb_vec_init(p->n);
    arb_mat_init(p->a, p->n, p->n);
    arb_poly_init(p->charpoly);
    arb_poly_init(p->rest);
    p->roots = _acb_vec_init(p->n);
}

static void end(jlt_ball_problem *p)
{
    _acb_vec_clear(p->roots, p->n);
    arb_poly_clear(p->rest);
    arb_poly_clear(p->charpoly);
    arb_mat_clear(p->a);
    _arb_vec_clear(p->x, p->n);
    _arb_vec_clear(p->params, p->table->param_count);
}

/* Whether a reversor S fixes the equilibrium, so that the Jacobian A satisfies S A S = -A. */
static bool reversed_by(const jlt_ball_problem *p, const signed char *signs)
{
    return p->proved && jlt_ball_point_fixed(p->x, signs, (size_t)p->n);
}

static jlt_status place(jlt_ball_problem *p)
{
    const jlt_ball_question *q = p->question;

    for (unsigned i = 0; i < p->table->param_count; i++)
        if (!jlt_ball_point_set(p->params + i, &q->params[i], p->precision)) return JLT_ERR_ARG;
    if (q->exact != NULL) {
        for (slong i = 0; i < p->n; i++) jlt_surd_enclose(p->x + i, &q->exact->point[i], q->exact->field, p->precision);
        for (slong i = 0; i < p->n * p->n; i++)
            jlt_surd_enclose(arb_mat_entry(p->a, i / p->n, i % p->n), &q->exact->entries[i], q->exact->field, p->precision);
        p->proved = true;
        return JLT_OK;
    }
    const jlt_ball_point found = jlt_ball_point_find(p->x, p->table, p->params, q, p->precision);
    if (found == JLT_BALL_POINT_NONE) return JLT_ERR_EMPTY;
    p->proved = found == JLT_BALL_POINT_PROVED;
    p->table->jacobian(arb_mat_entry(p->a, 0, 0), p->x, p->params, p->precision);
    for (size_t k = 0; k < q->reversor_count; k++) {
        const signed char *signs = q->reversors[k];
        for (slong i = 0; reversed_by(p, signs) && i < p->n * p->n; i++)
            if (signs[i / p->n] == signs[i % p->n]) arb_zero(arb_mat_entry(p->a, i / p->n, i % p->n));
    }
    return arb_mat_is_finite(p->a) ? JLT_OK : JLT_ERR_NO_CONVERGENCE;
}

/* Whether row `last` of w, the gradient of an integral, may be a left null vector of A, and is independent of the rows above. */
static bool forces_zero(const jlt_ball_problem *p, const arb_mat_t w, slong last)
{
    arb_mat_t rows, row;
    bool good;

    arb_mat_window_init(rows, w, 0, 0, last + 1, p->n);
    arb_mat_window_init(row, w, last, 0, last + 1, p->n);
    JLT_SCOPED_MATRIX(arb, p->n, last + 1, transposed);
    JLT_SCOPED_MATRIX(arb, last + 1, last + 1, gram);
    JLT_SCOPED_MATRIX(arb, 1, p->n, image);
    JLT_SCOPED(arb, determinant);
    arb_mat_mul(image, row, p->a, p->precision);
    arb_mat_transpose(transposed, rows);
    arb_mat_mul(gram, rows, transposed, p->precision);
    arb_mat_det(determinant, gram, p->precision);
    good = arb_is_finite(determinant) && !arb_contains_zero(determinant);
    for (slong j = 0; j < p->n; j++) good = good && arb_contains_zero(arb_mat_entry(image, 0, j));
    arb_mat_window_clear(row);
    arb_mat_window_clear(rows);
    return good;
}

/* Count the zeros that integrals force: the number of independent gradients. */
static void attribute(jlt_ball_spectrum *s, const jlt_ball_problem *p)
{
    arb_ptr gradients;

    s->attributed = 0;
    if (p->table->integral_gradients == NULL || p->question->integral_count == 0) return;
    gradients = _arb_vec_init((slong)p->table->integral_count * p->n);
    JLT_SCOPED_MATRIX(arb, p->n, p->n, w);
    p->table->integral_gradients(gradients, p->x, p->params, p->precision);
    for (size_t i = 0; i < p->question->integral_count && s->attributed < s->n; i++) {
        const slong index = jlt_ball_point_integral(p->table, p->question->integrals[i]), row = (slong)s->attributed;
        if (index < 0) continue;
        for (slong j = 0; j < p->n; j++) arb_set(arb_mat_entry(w, row, j), gradients + index * p->n + j);
        if (forces_zero(p, w, row)) s->source[s->attributed++] = (int)i;
    }
    _arb_vec_clear(gradients, (slong)p->table->integral_count * p->n);
}

/* Give this row of A a column of its own in which it is not zero; rows before it may get other columns. owner: shape (n,), -1 or
 * the row that has the column. Returns false if this is impossible. */
static bool place_row(const jlt_ball_problem *p, slong row, slong *owner, bool *seen)
{
    for (slong j = 0; j < p->n; j++) {
        if (seen[j] || arb_is_zero(arb_mat_entry(p->a, row, j))) continue;
        seen[j] = true;
        if (owner[j] >= 0 && !place_row(p, owner[j], owner, seen)) continue;
        owner[j] = row;
        return true;
    }
    return false;
}

/* A lower bound on the dimension of the null space of A: the number of zeros that integrals force; the number of rows that get no
 * column of their own, since all products of the determinants of more rows are zero; and if a reversor fixes the point, | fixed -
 * (n - fixed) | for its `fixed` states of sign +1, since A maps these to the others, and the others to these. */
static slong null_vectors(const jlt_ball_spectrum *s, const jlt_ball_problem *p)
{
    slong most = (slong)s->attributed, owner[JLT_BALL_SIZE_MAX], without = 0;

    for (slong i = 0; i < p->n; i++) owner[i] = -1;
    for (slong i = 0; i < p->n; i++) without += !place_row(p, i, owner, (bool[JLT_BALL_SIZE_MAX]){ false });
    if (without > most) most = without;
    for (size_t k = 0; k < p->question->reversor_count; k++) {
        slong fixed = 0;
        if (!reversed_by(p, p->question->reversors[k])) continue;
        for (slong i = 0; i < p->n; i++) fixed += p->question->reversors[k][i] > 0;
        if (labs(2 * fixed - p->n) > most) most = labs(2 * fixed - p->n);
    }
    return most;
}

/* Compute the characteristic polynomial, with exact zeros for the coefficients that integrals or a reversor force to be zero. */
static void expand(jlt_ball_problem *p, slong forced)
{
    arb_mat_charpoly(p->charpoly, p->a, p->precision);
    for (slong k = 0; k < forced; k++) arb_zero(arb_poly_get_coeff_ptr(p->charpoly, k));
    for (size_t r = 0; r < p->question->reversor_count; r++)
        for (slong k = p->n - 1; k >= 0 && reversed_by(p, p->question->reversors[r]); k -= 2)
            arb_zero(arb_poly_get_coeff_ptr(p->charpoly, k));
}

/* Decide whether the eigenvalue zero is semisimple: it is if its multiplicity is at most `forced`, and is defective (s->defective
 * = 1) if A q(A) is certainly not zero, where q is p->rest. Returns false if neither is known. */
static bool judge_zero(jlt_ball_spectrum *s, const jlt_ball_problem *p, slong forced)
{

    s->defective = 0;
    if ((slong)s->zeros <= forced) return true;
    JLT_SCOPED_MATRIX(arb, p->n, p->n, value);
    for (slong k = arb_poly_degree(p->rest); k >= -1; k--) { /* Horner's scheme, then one more factor A */
        arb_mat_mul(value, value, p->a, p->precision);
        for (slong i = 0; k >= 0 && i < p->n; i++)
            arb_add(arb_mat_entry(value, i, i), arb_mat_entry(value, i, i), arb_poly_get_coeff_ptr(p->rest, k), p->precision);
    }
    for (slong i = 0; i < p->n * p->n; i++)
        if (!arb_contains_zero(arb_mat_entry(value, i / p->n, i % p->n))) s->defective = 1;
    return s->defective;
}

/* Compute the characteristic polynomial, count its roots zero and divide them out. Returns false if this precision does not decide
 * their number and kind; at the last precision, what may be zero is taken as zero. */
static bool deflate(jlt_ball_spectrum *s, jlt_ball_problem *p)
{
    const jlt_exact_matrix *exact = p->question->exact;
    const slong forced = null_vectors(s, p);
    bool sure = true;

    if (exact != NULL) {
        jlt_exact_poly_enclose(p->charpoly, &exact->charpoly, exact->field, p->precision);
        s->zeros = exact->zeros;
        s->defective = !exact->zero_semisimple;
    } else {
        expand(p, forced);
        for (s->zeros = 0; s->zeros < s->n; s->zeros++) {
            arb_ptr coefficient = arb_poly_get_coeff_ptr(p->charpoly, (slong)s->zeros);
            if (!arb_contains_zero(coefficient)) break;
            sure = sure && arb_is_zero(coefficient);
        }
    }
    arb_poly_shift_right(p->rest, p->charpoly, (slong)s->zeros);
    s->counted = sure;
    p->judged = exact != NULL || (sure && judge_zero(s, p, forced));
    return sure || p->last;
}

/* Compute the spectrum at one precision. *finished: more bits would change nothing. */
static jlt_status attempt(jlt_ball_spectrum *s, bool *finished, jlt_ball_problem *p)
{
    const bool decimals = p->question->digits > 0;
    bool sure;

    JLT_PASS(place(p));
    s->precision = p->precision;
    s->n = (size_t)p->n;
    s->exists = p->proved;
    attribute(s, p);
    if (!deflate(s, p)) return JLT_ERR_NO_CONVERGENCE;
    s->rooted = jlt_ball_problem_roots(s, p);
    if (!s->rooted && !(s->defective && p->last)) return JLT_ERR_NO_CONVERGENCE;
    s->proved = p->proved && (s->growing || (p->judged && (s->defective || (s->rooted && p->settled))));
    if (!jlt_ball_problem_round(s, &sure, p)) return JLT_ERR_NONFINITE;
    if (s->rooted && decimals) s->texts = jlt_ball_texts_create(&sure, p);
    if (s->rooted && decimals && s->texts == NULL) return JLT_ERR_NOMEM;
    s->sure = sure;
    *finished = (sure || p->clustered) && s->proved;
    return JLT_OK;
}

jlt_status jlt_ball_spectrum_compute(jlt_ball_spectrum *spectrum, const jlt_ball_question *question)
{
    const slong first = FIRST_PRECISION > 4 * question->digits + 64 ? FIRST_PRECISION : 4 * question->digits + 64;
    const slong last = LAST_PRECISION > 8 * first ? LAST_PRECISION : 8 * first;
    jlt_ball_spectrum found = { .precision = 0 };
    jlt_status st = JLT_ERR_UNSUPPORTED, end_status = JLT_ERR_UNSUPPORTED;
    bool finished = false;

    if (question->table == NULL) return st;
    if (question->table->state_count > SIZE || question->digits > JLT_BALL_TEXTS_DIGITS_MAX) return JLT_ERR_ARG;
    for (slong precision = first; precision <= last && !finished; precision *= 2) {
        jlt_ball_spectrum s = { .precision = 0 };
        jlt_ball_problem p;
        begin(&p, question, precision);
        p.last = 2 * precision > last;
        p.late = precision >= 4 * first;
        if (precision > first && question->exact != NULL) jlt_exact_matrix_split(question->exact);
        st = attempt(&s, &finished, &p);
        end(&p);
        if (st == JLT_OK) {
            jlt_ball_texts_destroy(found.texts);
            found = s;
        }
        if (st == JLT_OK || end_status != JLT_OK) end_status = st;
        if (st != JLT_OK && st != JLT_ERR_EMPTY && st != JLT_ERR_NO_CONVERGENCE) break;
    }
    if (st == JLT_ERR_NOMEM || st == JLT_ERR_NONFINITE) end_status = st;
    if (end_status == JLT_OK) *spectrum = found;
    else jlt_ball_texts_destroy(found.texts);
    return end_status;
}
