#include "validated/transport.h"

/* Replace x by the state after `length`, at most the step that was enclosed last. */
static void move(const jlt_rough *self, arb_ptr x, const arb_t length)
{
    const unsigned K = self->accuracy.order;

    for (unsigned i = 0; i < self->of->states * self->terms; i++)
        jlt_rough_sum(x + i, jlt_rough_series(self, self->hull, i), K, jlt_rough_series(self, self->rough, i) + K, length,
                      self->accuracy.bits);
}

/* Choose the next step h <= most. A step that would leave less than its own length is shortened to half of what is left. */
static void choose(const jlt_rough *self, arf_t h, const arf_t most, const arb_t left)
{
    JLT_SCOPED(arf, half);

    arf_set(h, most);
    jlt_rough_choose(self, h);
    arf_mul_2exp_si(half, arb_midref(left), -1);
    if (arf_cmp(h, most) < 0 && arf_cmp(h, half) > 0) arf_set_d(h, arf_get_d(half, ARF_RND_DOWN));
}

jlt_status jlt_transport_carry(jlt_rough *self, arb_ptr x, const arb_t time)
{
    const slong bits = self->accuracy.bits;
    JLT_SCOPED(arb, left, length);
    JLT_SCOPED(arf, h, most);

    arb_set(left, time);
    while (arb_is_positive(left)) {
        jlt_jets_run(self->hull, x, self->params, bits);
        arb_get_ubound_arf(most, left, bits);
        choose(self, h, most, left);
        if (!jlt_rough_validate(self, h, NULL, NULL)) return JLT_ERR_NO_PROGRESS;
        const bool last = arf_cmp(h, most) == 0;
        if (last) arb_set(length, left);
        else arb_set_arf(length, h);
        move(self, x, length);
        if (last) return JLT_OK;
        arb_sub(left, left, length, bits);
    }
    return JLT_ERR_NO_PROGRESS;
}
