#include "validated/krawczyk.h"

#include <math.h>

enum { NEWTON_STEPS = 12 };

bool jlt_krawczyk_invert(arb_mat_t M, const arb_mat_t DG, slong bits)
{
    bool invertible;
    JLT_SCOPED_MATRIX(arb, arb_mat_nrows(DG), arb_mat_ncols(DG), middle);

    arb_mat_get_mid(middle, DG);
    invertible = arb_mat_inv(M, middle, bits);
    arb_mat_get_mid(M, M);
    return invertible;
}

static jlt_status evaluate(const jlt_krawczyk *self, arb_mat_t G, arb_mat_t DG, arb_srcptr y)
{
    arb_mat_zero(G);
    arb_mat_zero(DG);
    return self->equations(self->context, G, DG, y);
}

/* log2 of the largest modulus of an entry. */
static double size_of(const arb_mat_t column)
{
    double size = -INFINITY;
    JLT_SCOPED(mag, bound);

    for (slong i = 0; i < arb_mat_nrows(column); i++) {
        arb_get_mag(bound, arb_mat_entry(column, i, 0));
        size = fmax(size, mag_get_d_log2_approx(bound));
    }
    return size;
}

jlt_status jlt_krawczyk_refine(const jlt_krawczyk *self, arb_ptr y, double accuracy)
{
    const slong n = self->n;
    double size = INFINITY;
    JLT_SCOPED_MATRIX(arb, n, 1, G, correction);
    JLT_SCOPED_MATRIX(arb, n, n, DG, M);

    for (unsigned attempt = 0; attempt < NEWTON_STEPS && size > -accuracy; attempt++) {
        JLT_PASS(evaluate(self, G, DG, y));
        if (!jlt_krawczyk_invert(M, DG, self->bits)) return JLT_ERR_NO_CONVERGENCE;
        arb_mat_mul(correction, M, G, self->bits);
        size = size_of(correction);
        if (!(size < 0)) return JLT_ERR_NO_CONVERGENCE;
        for (slong i = 0; i < n; i++) {
            arb_sub(y + i, y + i, arb_mat_entry(correction, i, 0), self->bits);
            arb_get_mid_arb(y + i, y + i);
        }
    }
    return size <= -accuracy ? JLT_OK : JLT_ERR_NO_CONVERGENCE;
}

/* The operator; y0, M and M G(y0) are those of the first box for all boxes. */
typedef struct {
    const jlt_krawczyk *of;
    arb_ptr middle, between;
    arb_mat_t M, offset, DG, unused;
} operator;

static void operator_clear(operator *self)
{
    _arb_vec_clear(self->middle, self->of->n);
    _arb_vec_clear(self->between, self->of->n);
    arb_mat_clear(self->M);
    arb_mat_clear(self->offset);
    arb_mat_clear(self->DG);
    arb_mat_clear(self->unused);
}

/* Evaluate at the midpoint of the box; M is the inverse of DG there. *invertible: it exists. */
static jlt_status operator_init(operator *self, const jlt_krawczyk *of, bool *invertible, arb_srcptr box)
{
    const slong n = of->n;
    jlt_status st;

    *self = (operator){ .of = of, .middle = _arb_vec_init(n), .between = _arb_vec_init(n) };
    arb_mat_init(self->M, n, n);
    arb_mat_init(self->offset, n, 1);
    arb_mat_init(self->DG, n, n);
    arb_mat_init(self->unused, n, 1);
    JLT_SCOPED_MATRIX(arb, n, 1, G);
    for (slong i = 0; i < n; i++) arb_get_mid_arb(self->middle + i, box + i);
    st = evaluate(of, G, self->DG, self->middle);
    *invertible = st == JLT_OK && jlt_krawczyk_invert(self->M, self->DG, of->bits);
    arb_mat_mul(self->offset, self->M, G, of->bits);
    return st;
}

static jlt_status operator_apply(operator *self, arb_ptr K, arb_srcptr y)
{
    const slong n = self->of->n, bits = self->of->bits;
    JLT_SCOPED_MATRIX(arb, n, n, rest);
    JLT_SCOPED_MATRIX(arb, n, 1, away);

    for (slong i = 0; i < n; i++) { /* the mean value theorem needs the hull of y and the midpoint */
        if (arb_contains(y + i, self->middle + i)) arb_set(self->between + i, y + i);
        else arb_union(self->between + i, y + i, self->middle + i, bits);
    }
    JLT_PASS(evaluate(self->of, self->unused, self->DG, self->between));
    arb_mat_mul(rest, self->M, self->DG, bits);
    arb_mat_neg(rest, rest);
    for (slong i = 0; i < n; i++) {
        arb_add_ui(arb_mat_entry(rest, i, i), arb_mat_entry(rest, i, i), 1, bits);
        arb_sub(arb_mat_entry(away, i, 0), y + i, self->middle + i, bits);
    }
    arb_mat_mul(away, rest, away, bits);
    arb_mat_sub(away, away, self->offset, bits);
    for (slong i = 0; i < n; i++) arb_add(K + i, arb_mat_entry(away, i, 0), self->middle + i, bits);
    return JLT_OK;
}

static bool all_inside(arb_srcptr outer, arb_srcptr inner, slong n)
{
    for (slong i = 0; i < n; i++)
        if (!arb_is_finite(inner + i) || !arb_contains_interior(outer + i, inner + i)) return false;
    return true;
}

/* log2 of the largest radius. */
static double width_of(arb_srcptr box, slong n)
{
    double width = -INFINITY;

    for (slong i = 0; i < n; i++) width = fmax(width, mag_get_d_log2_approx(arb_radref(box + i)));
    return width;
}

/* log2 of the largest radius of M G(y0): no K has a smaller one. */
static double least_width(const operator *self)
{
    double width = -INFINITY;

    for (slong i = 0; i < self->of->n; i++)
        width = fmax(width, mag_get_d_log2_approx(arb_radref(arb_mat_entry(self->offset, i, 0))));
    return width;
}

jlt_status jlt_krawczyk_prove(const jlt_krawczyk *self, jlt_krawczyk_verdict *verdict, arb_ptr solution, arb_srcptr box)
{
    const slong n = self->n;
    JLT_SCOPED_VECTOR(arb, K, n);
    bool invertible = false;
    JLT_CLEARED(operator_clear) operator op;

    *verdict = JLT_KRAWCZYK_UNSHOWN;
    JLT_PASS(operator_init(&op, self, &invertible, box));
    if (!invertible) return JLT_OK;
    JLT_PASS(operator_apply(&op, K, box));
    if (!all_inside(box, K, n)) return JLT_OK;
    *verdict = JLT_KRAWCZYK_PROVED;
    for (double before = INFINITY; width_of(K, n) < before - 3;) {
        before = width_of(K, n);
        _arb_vec_set(solution, K, n);
        if (least_width(&op) >= before - 3) break;
        JLT_PASS(operator_apply(&op, K, solution));
        for (slong i = 0; i < n; i++)
            if (!arb_intersection(K + i, K + i, solution + i, self->bits)) *verdict = JLT_KRAWCZYK_CONTRADICTED;
    }
    for (slong i = 0; i < n; i++) /* evaluate at the solution what the caller reads from the context of the equations */
        if (!arb_equal(op.between + i, solution + i)) return evaluate(self, op.unused, op.DG, solution);
    return JLT_OK;
}
