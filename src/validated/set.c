#include "validated/set.h"

#include <stdbool.h>

void jlt_set_init(jlt_set *self, arb_srcptr x, unsigned dim, slong bits)
{
    arb_mat_t *const squares[] = { &self->C, &self->Q, &self->V, &self->B };

    self->dim = dim;
    self->bits = bits;
    arb_mat_init(self->x, dim, 1);
    arb_mat_init(self->r0, dim, 1);
    arb_mat_init(self->r, dim, 1);
    arb_mat_init(self->R, dim, dim);
    for (unsigned i = 0; i < sizeof squares / sizeof *squares; i++) {
        arb_mat_init(*squares[i], dim, dim);
        arb_mat_one(*squares[i]);
    }
    for (unsigned i = 0; i < dim; i++) {
        arb_get_mid_arb(arb_mat_entry(self->x, i, 0), x + i);
        mag_set(arb_radref(arb_mat_entry(self->r0, i, 0)), arb_radref(x + i));
    }
}

void jlt_set_clear(jlt_set *self)
{
    arb_mat_clear(self->x);
    arb_mat_clear(self->r0);
    arb_mat_clear(self->r);
    arb_mat_clear(self->R);
    arb_mat_clear(self->C);
    arb_mat_clear(self->Q);
    arb_mat_clear(self->V);
    arb_mat_clear(self->B);
}

void jlt_set_hull(arb_ptr x, const jlt_set *self)
{
    JLT_SCOPED_MATRIX(arb, self->dim, 1, sum, part);

    arb_mat_mul(sum, self->C, self->r0, self->bits);
    arb_mat_mul(part, self->Q, self->r, self->bits);
    arb_mat_add(sum, sum, part, self->bits);
    arb_mat_add(sum, sum, self->x, self->bits);
    for (unsigned i = 0; i < self->dim; i++) arb_set(x + i, arb_mat_entry(sum, i, 0));
}

void jlt_set_slope(arb_mat_t slope, const jlt_set *self)
{
    arb_mat_mul(slope, self->B, self->R, self->bits);
    arb_mat_add(slope, slope, self->V, self->bits);
}

/* weight = (length of column j of the axes times largest radius in row j of the factors)^2. */
static void weigh(arb_t weight, const arb_mat_t axes, const arb_mat_t factors, slong j, slong bits)
{
    JLT_SCOPED(mag, radius);
    JLT_SCOPED(arf, length);

    arb_zero(weight);
    for (slong i = 0; i < arb_mat_nrows(axes); i++) arb_addmul(weight, arb_mat_entry(axes, i, j), arb_mat_entry(axes, i, j), bits);
    for (slong k = 0; k < arb_mat_ncols(factors); k++) mag_max(radius, radius, arb_radref(arb_mat_entry(factors, j, k)));
    mag_mul(radius, radius, radius);
    arf_set_mag(length, radius);
    arf_mul(arb_midref(weight), arb_midref(weight), length, bits, ARF_RND_DOWN);
    mag_zero(arb_radref(weight));
}

/* Subtract from column k its component along column j, which has length 1. */
static void remove_along(arb_mat_t axes, slong k, slong j, slong bits)
{
    JLT_SCOPED(arb, product);

    for (slong i = 0; i < arb_mat_nrows(axes); i++) arb_addmul(product, arb_mat_entry(axes, i, k), arb_mat_entry(axes, i, j), bits);
    for (slong i = 0; i < arb_mat_nrows(axes); i++) {
        arb_submul(arb_mat_entry(axes, i, k), arb_mat_entry(axes, i, j), product, bits);
        arb_get_mid_arb(arb_mat_entry(axes, i, k), arb_mat_entry(axes, i, k));
    }
}

static bool normalize(arb_mat_t axes, slong j, slong bits)
{
    bool is_long;
    JLT_SCOPED(arb, length);

    for (slong i = 0; i < arb_mat_nrows(axes); i++) arb_addmul(length, arb_mat_entry(axes, i, j), arb_mat_entry(axes, i, j), bits);
    arb_sqrt(length, length, bits);
    is_long = arb_is_positive(length);
    for (slong i = 0; is_long && i < arb_mat_nrows(axes); i++) {
        arb_div(arb_mat_entry(axes, i, j), arb_mat_entry(axes, i, j), length, bits);
        arb_get_mid_arb(arb_mat_entry(axes, i, j), arb_mat_entry(axes, i, j));
    }
    return is_long;
}

static void swap_columns(arb_mat_t a, slong j, slong k)
{
    for (slong i = 0; i < arb_mat_nrows(a); i++) arb_swap(arb_mat_entry(a, i, j), arb_mat_entry(a, i, k));
}

/* Choose exact, nearly orthogonal axes, the first along the longest edge of A times the box, and enclose their inverse. If A is
 * singular to working precision, take the coordinate axes. */
static void choose_axes(arb_mat_t axes, arb_mat_t inverse, const arb_mat_t A, const arb_mat_t factors, slong bits)
{
    const slong n = arb_mat_nrows(A);
    JLT_SCOPED_VECTOR(arb, weights, n);
    bool good = true;

    arb_mat_get_mid(axes, A);
    for (slong j = 0; j < n; j++) weigh(weights + j, axes, factors, j, bits);
    for (slong j = 0; good && j < n; j++) {
        slong longest = j;
        for (slong k = j + 1; k < n; k++)
            if (arf_cmp(arb_midref(weights + k), arb_midref(weights + longest)) > 0) longest = k;
        arb_swap(weights + j, weights + longest);
        swap_columns(axes, j, longest);
        for (unsigned twice = 0; twice < 2; twice++)
            for (slong k = 0; k < j; k++) remove_along(axes, j, k, bits);
        good = normalize(axes, j, bits);
    }
    good = good && arb_mat_inv(inverse, axes, bits);
    for (slong i = 0; good && i < n; i++)
        for (slong j = 0; j < n; j++) good = good && arb_is_finite(arb_mat_entry(inverse, i, j));
    if (!good) {
        arb_mat_one(axes);
        arb_mat_one(inverse);
    }
}

/* New axes and rest whose product encloses A*axes*rest + more. */
static void move_rest(arb_mat_t axes, arb_mat_t rest, const arb_mat_t A, const arb_mat_t more, slong bits)
{
    const slong n = arb_mat_nrows(axes), columns = arb_mat_ncols(rest);
    JLT_SCOPED_MATRIX(arb, n, n, product, inverse);
    JLT_SCOPED_MATRIX(arb, n, columns, next);

    arb_mat_mul(product, A, axes, bits);
    choose_axes(axes, inverse, product, rest, bits);
    arb_mat_mul(product, inverse, product, bits);
    arb_mat_mul(next, product, rest, bits);
    arb_mat_mul(rest, inverse, more, bits);
    arb_mat_add(rest, rest, next, bits);
}

/* Split `whole` into an exact midpoint and the rest around it. */
static void split(arb_mat_t middle, arb_mat_t rest, const arb_mat_t whole, slong bits)
{
    arb_mat_get_mid(middle, whole);
    arb_mat_sub(rest, whole, middle, bits);
}

void jlt_set_move(jlt_set *self, const arb_mat_t image, const arb_mat_t slope, const arb_mat_t derivative)
{
    const slong n = (slong)self->dim, bits = self->bits;
    JLT_SCOPED_MATRIX(arb, n, 1, more, left);
    JLT_SCOPED_MATRIX(arb, n, n, square, product);

    split(self->x, more, image, bits);
    arb_mat_mul(product, slope, self->C, bits);
    split(self->C, square, product, bits);
    arb_mat_mul(left, square, self->r0, bits);
    arb_mat_add(more, more, left, bits);
    move_rest(self->Q, self->r, slope, more, bits);

    arb_mat_mul(product, derivative, self->V, bits);
    split(self->V, square, product, bits);
    move_rest(self->B, self->R, derivative, square, bits);

}
