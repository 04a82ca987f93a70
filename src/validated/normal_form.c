#include "validated/normal_form.h"

enum { DEGREE = 3, TERMS = 10 };

void jlt_normal_form_init(jlt_normal_form *self)
{
    arb_init(self->twist);
    arb_init(self->growth);
}

void jlt_normal_form_clear(jlt_normal_form *self)
{
    arb_clear(self->twist);
    arb_clear(self->growth);
}

/* The index of z^j conj(z)^k, ordered by the degree j + k. */
static unsigned term_of(unsigned j, unsigned k) { return (j + k) * (j + k + 1) / 2 + k; }

/* out = a (first z + second conj(z)), truncated at degree 3. */
static void multiply(acb_ptr out, acb_srcptr a, const acb_t first, const acb_t second, slong bits)
{
    _acb_vec_zero(out, TERMS);
    for (unsigned d = 0; d < DEGREE; d++)
        for (unsigned k = 0; k <= d; k++) {
            acb_addmul(out + term_of(d - k + 1, k), a + term_of(d - k, k), first, bits);
            acb_addmul(out + term_of(d - k, k + 1), a + term_of(d - k, k), second, bits);
        }
}

/* h += weight_1 map_1 + weight_2 map_2, with u = (z + conj(z))/2, v = slope z + conj(slope z) substituted. */
static void substitute(acb_ptr h, arb_srcptr map, acb_srcptr weights, const acb_t slope, slong bits)
{
    JLT_SCOPED_VECTOR(acb, monomials, TERMS * TERMS);
    JLT_SCOPED(acb, half, other, factor);

    acb_one(half);
    acb_mul_2exp_si(half, half, -1);
    acb_conj(other, slope);
    acb_one(monomials);
    for (unsigned d = 1; d <= DEGREE; d++)
        for (unsigned k = 0; k <= d; k++) { /* u^(d-k) v^k */
            acb_ptr monomial = monomials + term_of(d - k, k) * TERMS;
            if (k < d) multiply(monomial, monomials + term_of(d - k - 1, k) * TERMS, half, half, bits);
            else multiply(monomial, monomials + term_of(0, k - 1) * TERMS, slope, other, bits);
            for (unsigned row = 0; row < 2; row++) {
                acb_mul_arb(factor, weights + row, map + row * TERMS + term_of(d - k, k), bits);
                for (unsigned term = 1; term < TERMS; term++) acb_addmul(h + term, factor, monomial + term, bits);
            }
        }
}

/* The eigenvector (1/2, slope), slope = (lambda - a_11)/(2 a_12), and the weights in z = weight_1 u + weight_2 v. */
static void diagonalize(acb_t slope, acb_ptr weights, arb_srcptr map, const acb_t lambda, slong bits)
{
    JLT_SCOPED(arb, twice);

    acb_sub_arb(slope, lambda, map + 1, bits);
    arb_mul_2exp_si(twice, map + 2, 1);
    acb_div_arb(slope, slope, twice, bits);
    arb_one(acb_realref(weights));
    arb_div(acb_imagref(weights), acb_realref(slope), acb_imagref(slope), bits);
    arb_mul_2exp_si(twice, acb_imagref(slope), 1);
    arb_inv(acb_imagref(weights + 1), twice, bits);
    arb_neg(acb_imagref(weights + 1), acb_imagref(weights + 1));
}

/* d by the formula in the header. */
static void reduce(acb_t d, acb_srcptr h, const acb_t lambda, slong bits)
{
    JLT_SCOPED(acb, inverse, square, a, b);
    JLT_SCOPED(arb, size);

    acb_conj(inverse, lambda);
    acb_mul(square, lambda, lambda, bits);
    acb_mul_2exp_si(a, lambda, 1);
    acb_sub_ui(a, a, 3, bits);
    acb_add(a, a, inverse, bits);
    acb_sub(b, square, lambda, bits);
    acb_div(a, a, b, bits);
    acb_sub_ui(b, inverse, 1, bits);
    acb_div(a, a, b, bits);
    acb_mul(a, a, h + term_of(2, 0), bits);
    acb_mul(a, a, h + term_of(1, 1), bits);
    acb_add(d, a, h + term_of(2, 1), bits);
    acb_neg(b, b);
    acb_abs(size, h + term_of(1, 1), bits);
    arb_mul(size, size, size, bits);
    acb_inv(b, b, bits);
    acb_addmul_arb(d, b, size, bits);
    acb_sub(b, square, inverse, bits);
    acb_abs(size, h + term_of(0, 2), bits);
    arb_mul(size, size, size, bits);
    arb_mul_2exp_si(size, size, 1);
    acb_inv(b, b, bits);
    acb_addmul_arb(d, b, size, bits);
    acb_mul(d, d, inverse, bits);
}

void jlt_normal_form_compute(jlt_normal_form *self, arb_srcptr map, const arb_t trace, slong bits)
{
    JLT_SCOPED_VECTOR(acb, h, TERMS);
    JLT_SCOPED_VECTOR(acb, weights, 2);
    JLT_SCOPED(acb, lambda, slope, d);

    arb_mul_2exp_si(acb_realref(lambda), trace, -1);
    arb_mul(acb_imagref(lambda), acb_realref(lambda), acb_realref(lambda), bits);
    arb_sub_ui(acb_imagref(lambda), acb_imagref(lambda), 1, bits);
    arb_neg(acb_imagref(lambda), acb_imagref(lambda));
    arb_sqrt(acb_imagref(lambda), acb_imagref(lambda), bits);
    diagonalize(slope, weights, map, lambda, bits);
    substitute(h, map, weights, slope, bits);
    reduce(d, h, lambda, bits);
    arb_set(self->twist, acb_imagref(d));
    arb_set(self->growth, acb_realref(d));
}
