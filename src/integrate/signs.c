#include "integrate/signs.h"

#include <math.h>

enum { PLACES = 32 };

typedef struct {
    const jlt_field *field;
    const jlt_quantity *states; /* whose intervals */
} rates;

/* Compute the rates, shape (dim,), where states a and b are `at`, and others all over their intervals, each in another part, lest
 * terms cancel; where an interval is infinite, at distances of all sizes from its end, or from 0 on either side. */
static void rates_at(const rates *self, double *f, unsigned a, unsigned b, double at, unsigned place)
{
    static const double golden = 0.6180339887498949;
    double x[JLT_DOMAIN_STATES_MAX];

    for (unsigned j = 0; j < self->field->dim; j++) {
        const double low = self->states[j].low, high = self->states[j].high, part = fmod((place + 1) * (j + 1) * golden, 1);
        const double either = 2 * part - 1, away = exp2(20 * part - 12);
        x[j] = isfinite(low)    ? isfinite(high) ? low + part * (high - low) : low + away
               : isfinite(high) ? high - away
                                : copysign(exp2(20 * fabs(either) - 12), either);
    }
    x[a] = x[b] = at;
    self->field->call(x, self->field->p, f);
}

/* Whether the rates of states a and b, which may be one, go to 0 with them, about as fast: after sqrt(x) x comes to 0. *moves
 * becomes true where one is not 0 before. Outside the domain there may be no rates. */
static bool rest_at_zero(const rates *self, unsigned a, unsigned b, double side, unsigned place, bool *moves)
{
    double near[JLT_DOMAIN_STATES_MAX], nearer[JLT_DOMAIN_STATES_MAX], there[JLT_DOMAIN_STATES_MAX];

    rates_at(self, there, a, b, 0, place);
    if (isnan(there[a]) || isnan(there[b])) return true;
    if (!(there[a] == 0 && there[b] == 0)) return false;
    rates_at(self, near, a, b, side * 0x1p-40, place);
    rates_at(self, nearer, a, b, side * 0x1p-80, place);
    *moves |= fabs(near[a]) + fabs(near[b]) > 0;
    return !((fabs(nearer[a]) + fabs(nearer[b])) * 0x1p40 > 4 * (fabs(near[a]) + fabs(near[b])));
}

/* Whether they do so wherever the others are. */
static bool vanish_together(const rates *self, unsigned a, unsigned b)
{
    const jlt_quantity *first = &self->states[a], *second = &self->states[b];
    const double low = fmax(first->low, second->low), high = fmin(first->high, second->high);
    bool moves = false;

    if (low > 0 || high < 0) return false;
    for (unsigned place = 0; place < PLACES; place++) {
        const double side = low == 0 || (high > 0 && place % 2 == 0) ? 1 : -1;
        if (!rest_at_zero(self, a, b, side, place, &moves)) return false;
    }
    return moves;
}

void jlt_signs_find(jlt_field *field, const jlt_quantity *states)
{
    const rates self = { field, states };
    jlt_state_set taken;

    for (unsigned i = 0; i < field->dim; i++)
        if ((int)i != field->root && vanish_together(&self, i, i)) jlt_state_set_add(&field->kept, i);
    taken = field->kept;
    if (field->root >= 0) jlt_state_set_add(&taken, (unsigned)field->root); /* it has a scale of its own */
    for (unsigned i = 0; i < field->dim && field->dim > 2; i++)
        for (unsigned j = i + 1; j < field->dim; j++) {
            if (jlt_state_set_has(&taken, i) || jlt_state_set_has(&taken, j) || !vanish_together(&self, i, j)) continue;
            field->pairs.of[field->pairs.count++] = (jlt_state_pair){ (unsigned char)i, (unsigned char)j };
            jlt_state_set_add(&taken, i);
            jlt_state_set_add(&taken, j);
        }
}
