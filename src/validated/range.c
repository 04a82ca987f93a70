#include "validated/range.h"

void jlt_range_init(jlt_range *self)
{
    arf_init(self->low);
    arf_init(self->high);
}

void jlt_range_clear(jlt_range *self)
{
    arf_clear(self->low);
    arf_clear(self->high);
}

void jlt_range_set(jlt_range *out, const jlt_range *a)
{
    arf_set(out->low, a->low);
    arf_set(out->high, a->high);
}

void jlt_range_set_fractions(jlt_range *out, const fmpq_t low, const fmpq_t high, slong bits)
{
    arf_fmpz_div_fmpz(out->low, fmpq_numref(low), fmpq_denref(low), bits, ARF_RND_FLOOR);
    arf_fmpz_div_fmpz(out->high, fmpq_numref(high), fmpq_denref(high), bits, ARF_RND_CEIL);
}

void jlt_range_add(jlt_range *out, const jlt_range *a, const jlt_range *b, slong bits)
{
    arf_add(out->low, a->low, b->low, bits, ARF_RND_FLOOR);
    arf_add(out->high, a->high, b->high, bits, ARF_RND_CEIL);
}

void jlt_range_multiply(jlt_range *out, const jlt_range *a, const jlt_range *b, slong bits)
{
    JLT_SCOPED(jlt_range, all);
    JLT_SCOPED(arf, product);

    for (unsigned i = 0; i < 4; i++) {
        arf_srcptr x = i < 2 ? a->low : a->high, y = i % 2 == 0 ? b->low : b->high;
        arf_mul(product, x, y, bits, ARF_RND_FLOOR);
        if (i == 0 || arf_cmp(product, all->low) < 0) arf_set(all->low, product);
        arf_mul(product, x, y, bits, ARF_RND_CEIL);
        if (i == 0 || arf_cmp(product, all->high) > 0) arf_set(all->high, product);
    }
    jlt_range_set(out, all);
}

static void absolute(jlt_range *out, const jlt_range *a)
{
    const int sign = jlt_range_sign(a);

    jlt_range_set(out, a);
    if (sign < 0) {
        arf_neg(out->low, out->low);
        arf_neg(out->high, out->high);
        arf_swap(out->low, out->high);
    } else if (sign == 0) {
        if (arf_cmpabs(out->low, out->high) > 0) arf_neg(out->high, out->low);
        arf_zero(out->low);
    }
}

void jlt_range_power(jlt_range *out, const jlt_range *a, unsigned exponent, slong bits)
{
    JLT_SCOPED(jlt_range, even, all);

    arf_one(all->low);
    arf_one(all->high);
    absolute(even, a);
    for (unsigned k = 0; k < exponent / 2 * 2; k++) jlt_range_multiply(all, all, even, bits);
    if (exponent % 2 != 0) jlt_range_multiply(all, all, a, bits);
    jlt_range_set(out, all);
}

bool jlt_range_invert(jlt_range *out, const jlt_range *a, slong bits)
{
    if (jlt_range_sign(a) == 0) return false;
    jlt_range_set(out, a);
    arf_ui_div(out->low, 1, out->low, bits, ARF_RND_CEIL);
    arf_ui_div(out->high, 1, out->high, bits, ARF_RND_FLOOR);
    arf_swap(out->low, out->high);
    return true;
}

bool jlt_range_root(jlt_range *out, const jlt_range *a, slong bits)
{
    if (arf_sgn(a->low) < 0) return false;
    arf_sqrt(out->low, a->low, bits, ARF_RND_FLOOR);
    arf_sqrt(out->high, a->high, bits, ARF_RND_CEIL);
    return true;
}

bool jlt_range_apply(jlt_range *out, const jlt_range *a, jlt_range_function function, slong bits)
{
    bool finite;
    JLT_SCOPED(arb, ball);

    arb_set_interval_arf(ball, a->low, a->high, bits);
    function(ball, ball, bits);
    finite = arb_is_finite(ball);
    if (finite) arb_get_interval_arf(out->low, out->high, ball, bits);
    return finite;
}

int jlt_range_sign(const jlt_range *a)
{
    return arf_sgn(a->low) > 0 ? 1 : arf_sgn(a->high) < 0 ? -1 : 0;
}

bool jlt_range_is_zero(const jlt_range *a)
{
    return arf_is_zero(a->low) && arf_is_zero(a->high);
}
