#include "ext/ball_spectrum.h"

#include "ext/ball_point.h"

#if __has_include(<flint/acb_poly.h>)
#include <flint/acb_mat.h>
#include <flint/acb_poly.h>
#include <flint/arb_poly.h>
#else
#include <acb_mat.h>
#include <acb_poly.h>
#include <arb_poly.h>
#endif

#include <float.h>
#include <math.h>
#include <string.h>

enum { SIZE = JLT_BALL_SIZE_MAX, FIRST_PRECISION = 192, LAST_PRECISION = 6144, NULL_BITS = 1000, AXIS_BITS = 100 };

/* The linearization at one precision. */
typedef struct {
    const jlt_ball_table *table;
    const jlt_ball_question *question;
    slong n, precision;
    arb_ptr params, x;
    arb_mat_t a;
    arb_poly_t charpoly, rest; /* rest: what zeros leave of it */
    acb_ptr roots;             /* of rest */
} problem;

static void begin(problem *p, const jlt_ball_table *table, const jlt_ball_question *question, slong precision)
{
    *p = (problem){ .table = table, .question = question, .n = table->state_count, .precision = precision };
    p->params = _arb_vec_init(table->param_count);
    p->x = _arb_vec_init(p->n);
    arb_mat_init(p->a, p->n, p->n);
    arb_poly_init(p->charpoly);
    arb_poly_init(p->rest);
    p->roots = _acb_vec_init(p->n);
}

static void end(problem *p)
{
    _acb_vec_clear(p->roots, p->n);
    arb_poly_clear(p->rest);
    arb_poly_clear(p->charpoly);
    arb_mat_clear(p->a);
    _arb_vec_clear(p->x, p->n);
    _arb_vec_clear(p->params, p->table->param_count);
}

/* The magnitude of value is at most 2^-bits of size. */
static bool faint(const mag_t value, const mag_t size, slong bits)
{
    mag_t limit;
    bool small;

    mag_init(limit);
    mag_mul_2exp_si(limit, size, -bits);
    small = mag_cmp(value, limit) <= 0;
    mag_clear(limit);
    return small;
}

static jlt_status place(problem *p)
{
    for (unsigned i = 0; i < p->table->param_count; i++)
        if (!jlt_ball_point_set(p->params + i, &p->question->params[i], p->precision)) return JLT_ERR_ARG;
    if (!jlt_ball_point_find(p->x, p->table, p->params, p->question, p->precision)) return JLT_ERR_EMPTY;
    p->table->jacobian(arb_mat_entry(p->a, 0, 0), p->x, p->params, p->precision);
    return arb_mat_is_finite(p->a) ? JLT_OK : JLT_ERR_NO_CONVERGENCE;
}

static slong integral_index(const jlt_ball_table *table, const char *name)
{
    for (unsigned i = 0; i < table->integral_count; i++)
        if (strcmp(table->integral[i], name) == 0) return (slong)i;
    return -1;
}

/* Row `last` of w is a left null vector of A, and certainly independent of the rows before it. */
static bool forces_zero(const problem *p, const arb_mat_t w, slong last)
{
    arb_mat_t rows, row, transposed, gram, image;
    arb_t determinant;
    bool good;

    arb_mat_window_init(rows, w, 0, 0, last + 1, p->n);
    arb_mat_window_init(row, w, last, 0, last + 1, p->n);
    arb_mat_init(transposed, p->n, last + 1);
    arb_mat_init(gram, last + 1, last + 1);
    arb_mat_init(image, 1, p->n);
    arb_init(determinant);
    arb_mat_mul(image, row, p->a, p->precision);
    arb_mat_transpose(transposed, rows);
    arb_mat_mul(gram, rows, transposed, p->precision);
    arb_mat_det(determinant, gram, p->precision);
    good = arb_is_finite(determinant) && !arb_contains_zero(determinant);
    for (slong j = 0; j < p->n; j++) good = good && arb_contains_zero(arb_mat_entry(image, 0, j));
    arb_clear(determinant);
    arb_mat_clear(image);
    arb_mat_clear(gram);
    arb_mat_clear(transposed);
    arb_mat_window_clear(row);
    arb_mat_window_clear(rows);
    return good;
}

/* Zeros that integrals force: as many as their gradients have independent rows. */
static void attribute(jlt_ball_spectrum *s, const problem *p)
{
    arb_ptr gradients;
    arb_mat_t w;

    if (p->table->integral_gradients == NULL || p->question->integral_count == 0) return;
    gradients = _arb_vec_init((slong)p->table->integral_count * p->n);
    arb_mat_init(w, p->n, p->n);
    p->table->integral_gradients(gradients, p->x, p->params, p->precision);
    for (size_t i = 0; i < p->question->integral_count && s->attributed < s->n; i++) {
        const slong index = integral_index(p->table, p->question->integrals[i]), row = (slong)s->attributed;
        if (index < 0) continue;
        for (slong j = 0; j < p->n; j++) arb_set(arb_mat_entry(w, row, j), gradients + index * p->n + j);
        if (forces_zero(p, w, row)) s->source[s->attributed++] = (int)i;
    }
    arb_mat_clear(w);
    _arb_vec_clear(gradients, (slong)p->table->integral_count * p->n);
}

/* The characteristic polynomial, its zeros counted and taken out; false when this precision does not tell them. */
static bool deflate(jlt_ball_spectrum *s, problem *p)
{
    mag_t size, scale, radius;
    bool settled = true;

    mag_init(size);
    mag_init(scale);
    mag_init(radius);
    arb_mat_charpoly(p->charpoly, p->a, p->precision);
    arb_mat_bound_frobenius_norm(size, p->a);
    for (s->zeros = 0; s->zeros < s->n; s->zeros++) {
        arb_ptr coefficient = arb_poly_get_coeff_ptr(p->charpoly, (slong)s->zeros);
        if (s->zeros >= s->attributed) {
            if (!arb_contains_zero(coefficient)) break;
            mag_pow_ui(scale, size, s->n - s->zeros);
            arb_get_mag(radius, coefficient);
            settled = faint(radius, scale, NULL_BITS);
            if (!settled) break;
        }
        arb_zero(coefficient);
    }
    arb_poly_shift_right(p->rest, p->charpoly, (slong)s->zeros);
    mag_clear(radius);
    mag_clear(scale);
    mag_clear(size);
    return settled;
}

/* Zero is semisimple where A q(A) = 0, q being what zeros leave of the characteristic polynomial. False: not settled. */
static bool judge_zero(jlt_ball_spectrum *s, const problem *p)
{
    arb_mat_t value;
    mag_t entry, size, bound;
    bool settled = true;

    if (s->zeros <= s->attributed) return true; /* as many left null vectors as zeros */
    arb_mat_init(value, p->n, p->n);
    mag_init(entry);
    mag_init(size);
    mag_init(bound);
    arb_mat_bound_frobenius_norm(size, p->a);
    for (slong k = arb_poly_degree(p->rest); k >= -1; k--) { /* Horner, and A once more */
        arb_mat_mul(value, value, p->a, p->precision);
        mag_mul(bound, bound, size);
        if (k < 0) break;
        for (slong i = 0; i < p->n; i++)
            arb_add(arb_mat_entry(value, i, i), arb_mat_entry(value, i, i), arb_poly_get_coeff_ptr(p->rest, k), p->precision);
        arb_get_mag(entry, arb_poly_get_coeff_ptr(p->rest, k));
        mag_add(bound, bound, entry);
    }
    for (slong i = 0; i < p->n; i++)
        for (slong j = 0; j < p->n; j++) {
            if (!arb_contains_zero(arb_mat_entry(value, i, j))) s->defective = 1;
            arb_get_mag(entry, arb_mat_entry(value, i, j));
            settled = settled && faint(entry, bound, NULL_BITS);
        }
    mag_clear(bound);
    mag_clear(size);
    mag_clear(entry);
    arb_mat_clear(value);
    return settled || s->defective;
}

/* The part of an eigenvalue is certainly not zero, or so faint that it is taken for zero. */
static bool known(arb_t part, const acb_t value)
{
    mag_t size, entry;
    bool sure = !arb_contains_zero(part);

    if (sure) return true;
    mag_init(size);
    mag_init(entry);
    acb_get_mag(size, value);
    arb_get_mag(entry, part);
    sure = faint(entry, size, AXIS_BITS);
    mag_clear(entry);
    mag_clear(size);
    return sure;
}

static bool find_roots(jlt_ball_spectrum *s, problem *p)
{
    const slong degree = p->n - (slong)s->zeros;
    acb_poly_t complex_rest;
    bool good;

    s->decaying = degree > 0;
    if (degree == 0) return true;
    acb_poly_init(complex_rest);
    acb_poly_set_arb_poly(complex_rest, p->rest);
    good = acb_poly_find_roots(p->roots, complex_rest, NULL, 0, p->precision) == degree;
    acb_poly_clear(complex_rest);
    for (slong i = 0; good && i < degree; i++) {
        acb_ptr root = p->roots + i;
        good = known(acb_realref(root), root) && known(acb_imagref(root), root);
        if (arb_is_positive(acb_realref(root))) s->growing = 1;
        if (!arb_is_negative(acb_realref(root))) s->decaying = 0;
    }
    return good;
}

/* |x| |y| / |y^H x| of a simple eigenvalue: the product of A - mu over all others is a multiple of x y^H. */
static double condition(const problem *p, size_t zeros, slong which)
{
    acb_mat_t product, factor;
    acb_t trace;
    arb_t size, ratio;
    double value;

    acb_mat_init(product, p->n, p->n);
    acb_mat_init(factor, p->n, p->n);
    acb_init(trace);
    arb_init(size);
    arb_init(ratio);
    acb_mat_one(product);
    for (slong i = 0; i < p->n; i++) {
        if (i == which) continue;
        acb_mat_set_arb_mat(factor, p->a);
        for (slong j = 0; i < p->n - (slong)zeros && j < p->n; j++)
            acb_sub(acb_mat_entry(factor, j, j), acb_mat_entry(factor, j, j), p->roots + i, p->precision);
        acb_mat_mul(product, product, factor, p->precision);
    }
    acb_mat_trace(trace, product, p->precision);
    acb_abs(ratio, trace, p->precision);
    acb_mat_frobenius_norm(size, product, p->precision);
    arb_div(ratio, size, ratio, p->precision);
    value = arb_is_finite(ratio) ? arf_get_d(arb_midref(ratio), ARF_RND_NEAR) : INFINITY;
    arb_clear(ratio);
    arb_clear(size);
    acb_clear(trace);
    acb_mat_clear(factor);
    acb_mat_clear(product);
    return value;
}

/* The nearest double, zero where the ball holds it; *error grows by the distance to the ball's farthest point. */
static double rounded(double *error, arb_srcptr ball)
{
    const double value = arb_contains_zero(ball) ? 0.0 : arf_get_d(arb_midref(ball), ARF_RND_NEAR);
    arb_t distance;
    mag_t bound;

    arb_init(distance);
    mag_init(bound);
    arb_set_d(distance, value);
    arb_sub(distance, ball, distance, 64);
    arb_get_mag(bound, distance);
    *error += mag_get_d(bound);
    mag_clear(bound);
    arb_clear(distance);
    return value;
}

static bool follows(const jlt_ball_eigenvalue *a, const jlt_ball_eigenvalue *b)
{
    return a->re > b->re || (!(a->re < b->re) && a->im > b->im);
}

static bool round_all(jlt_ball_spectrum *s, const problem *p)
{
    const size_t kept = s->n - s->zeros;
    arb_t trace;
    bool finite = true;

    arb_init(trace);
    arb_mat_trace(trace, p->a, p->precision);
    s->trace_error = 0.0;
    s->trace = rounded(&s->trace_error, trace);
    arb_clear(trace);
    for (size_t k = 0; k <= s->n; k++) {
        s->charpoly_error[k] = 0.0;
        s->charpoly[k] = rounded(&s->charpoly_error[k], arb_poly_get_coeff_ptr(p->charpoly, (slong)(s->n - k)));
        finite = finite && isfinite(s->charpoly[k]);
    }
    for (size_t i = 0; s->rooted && i < kept; i++) {
        jlt_ball_eigenvalue value = { .condition = condition(p, s->zeros, (slong)i) };
        size_t at = i;
        value.re = rounded(&value.error, acb_realref(p->roots + i));
        value.im = rounded(&value.error, acb_imagref(p->roots + i));
        finite = finite && isnormal(hypot(value.re, value.im));
        for (; at > 0 && follows(&s->values[at - 1], &value); at--) s->values[at] = s->values[at - 1];
        s->values[at] = value;
    }
    return finite;
}

static jlt_status attempt(jlt_ball_spectrum *s, problem *p)
{
    jlt_status st = place(p);

    if (st != JLT_OK) return st;
    s->precision = p->precision;
    s->n = (size_t)p->n;
    attribute(s, p);
    if (!deflate(s, p) || !judge_zero(s, p)) return JLT_ERR_NO_CONVERGENCE;
    s->rooted = find_roots(s, p);
    if (!s->rooted && !(s->defective && p->precision == LAST_PRECISION)) return JLT_ERR_NO_CONVERGENCE;
    return round_all(s, p) ? JLT_OK : JLT_ERR_NONFINITE;
}

jlt_status jlt_ball_spectrum_compute(jlt_ball_spectrum *spectrum, const jlt_ball_question *question)
{
    const jlt_ball_table *table = question->table;
    jlt_status st = JLT_ERR_UNSUPPORTED;

    if (table == NULL) return st;
    if (table->state_count > SIZE) return JLT_ERR_ARG;
    for (slong precision = FIRST_PRECISION; precision <= LAST_PRECISION; precision *= 2) {
        jlt_ball_spectrum s = { .precision = 0 };
        problem p;
        begin(&p, table, question, precision);
        st = attempt(&s, &p);
        end(&p);
        if (st == JLT_OK) *spectrum = s;
        if (st != JLT_ERR_EMPTY && st != JLT_ERR_NO_CONVERGENCE) break;
    }
    return st;
}
