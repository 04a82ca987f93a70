#include "validated/transport.h"

#include <math.h>
#include <stdlib.h>

enum { TRIES = 60 };

struct jlt_transport {
    jlt_rough around;
};

jlt_status jlt_transport_create(jlt_transport **transport, const jlt_formulas *of, arb_srcptr params, jlt_rough_accuracy accuracy,
                                unsigned degree)
{
    jlt_transport *self = calloc(1, sizeof *self);
    jlt_status st = JLT_ERR_NOMEM;

    *transport = NULL;
    if (self == NULL) return st;
    JLT_TRY(jlt_rough_init(&self->around, of, of->motion, params, accuracy, degree));
    *transport = self;
    self = NULL; /* ownership moved to the caller */
done:
    jlt_transport_destroy(self);
    return st;
}

void jlt_transport_destroy(jlt_transport *transport)
{
    if (transport == NULL) return;
    jlt_rough_clear(&transport->around);
    free(transport);
}

/* Shorten h until the step has a rough enclosure, and a remainder not far above the tolerance. Returns false if none serves. */
static bool validate(jlt_rough *around, arf_t h)
{
    const double slack = 8, tolerance = (double)around->accuracy.tolerance;

    for (unsigned attempt = 0; attempt < TRIES; attempt++) {
        double factor = 0.7;
        if (jlt_rough_enclose(around, h)) {
            const double excess = jlt_rough_remainder(around, h) + tolerance - slack;
            if (excess <= 0) return true;
            factor = fmax(0.5, fmin(0.98, exp2(-(excess + slack) / around->accuracy.order)));
        }
        around->caution *= factor;
        arf_set_d(h, arf_get_d(h, ARF_RND_DOWN) * factor);
    }
    return false;
}

/* Replace x by the state after `length`, at most the step that was enclosed last. */
static void move(const jlt_transport *self, arb_ptr x, const arb_t length)
{
    const jlt_rough *around = &self->around;
    const unsigned K = around->accuracy.order;

    for (unsigned i = 0; i < around->of->states; i++)
        for (unsigned term = 0; term < around->terms; term++)
            jlt_rough_sum(x + i * around->terms + term, jlt_transport_series(self, i, term), K,
                          jlt_jets_state(around->rough, i) + term * (K + 1) + K, length, around->accuracy.bits);
}

/* Choose the next step h <= most. A step that would leave less than its own length is shortened to half of what is left. */
static void choose(jlt_transport *self, arf_t h, const arf_t most, const arb_t left)
{
    arf_t half;

    arf_init(half);
    arf_set(h, most);
    jlt_rough_choose(&self->around, h);
    arf_mul_2exp_si(half, arb_midref(left), -1);
    if (arf_cmp(h, most) < 0 && arf_cmp(h, half) > 0) arf_set_d(h, arf_get_d(half, ARF_RND_DOWN));
    arf_clear(half);
}

jlt_status jlt_transport_carry(jlt_transport *self, arb_ptr x, const arb_t time)
{
    const slong bits = self->around.accuracy.bits;
    jlt_status st = JLT_OK;
    arb_t left, length;
    arf_t h, most;

    arb_init(left);
    arb_init(length);
    arf_init(h);
    arf_init(most);
    arb_set(left, time);
    while (arb_is_positive(left)) {
        jlt_transport_expand(self, x);
        arb_get_ubound_arf(most, left, bits);
        choose(self, h, most, left);
        st = validate(&self->around, h) ? JLT_OK : JLT_ERR_NO_PROGRESS;
        if (st != JLT_OK) goto done;
        self->around.caution = fmin(self->around.caution * 1.02, 0.9);
        const bool last = arf_cmp(h, most) == 0;
        if (last) arb_set(length, left);
        else arb_set_arf(length, h);
        move(self, x, length);
        if (last) goto done;
        arb_sub(left, left, length, bits);
    }
    st = JLT_ERR_NO_PROGRESS;
done:
    arb_clear(left);
    arb_clear(length);
    arf_clear(h);
    arf_clear(most);
    return st;
}

void jlt_transport_expand(jlt_transport *self, arb_srcptr x)
{
    jlt_jets_run(self->around.hull, x, self->around.params, self->around.accuracy.bits);
}

arb_srcptr jlt_transport_series(const jlt_transport *self, unsigned state, unsigned term)
{
    return jlt_jets_state(self->around.hull, state) + term * (self->around.accuracy.order + 1);
}
