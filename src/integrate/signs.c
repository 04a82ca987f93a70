#include "integrate/signs.h"

#include <math.h>

/* Places, as parts of intervals or of the way to infinity: near to 0 and far from it. */
static const double places[] = { 0.3, 0.7, 0.02, 0.98 };
enum { PLACES = sizeof places / sizeof *places };

typedef struct {
    const jlt_field *field;
    const jlt_quantity *states; /* whose intervals */
} rates;

/* Compute the rates, shape (dim,), where states a and b are `at`, and others are about in the part `inside` of their intervals,
 * each in another, lest terms cancel; where an interval is infinite, as far from its end, or from 0 on either side. */
static void rates_at(const rates *self, double *f, unsigned a, unsigned b, double at, double inside)
{
    double x[JLT_DOMAIN_STATES_MAX];

    for (unsigned j = 0; j < self->field->dim; j++) {
        const double low = self->states[j].low, high = self->states[j].high, part = pow(inside, 1 + (double)j / self->field->dim);
        const double away = part / (1 - part), side = (j & 1) != (inside < 0.5) ? -1 : 1;
        x[j] = isfinite(low)    ? isfinite(high) ? low + part * (high - low) : low + away
               : isfinite(high) ? high - away
                                : side * away;
    }
    x[a] = x[b] = at;
    self->field->call(x, self->field->p, f);
}

/* Whether the rates of states a and b, which may be one, go to 0 with them, about as fast: after sqrt(x) x comes to 0. *moves
 * becomes true where one is not 0 before. */
static bool rest_at_zero(const rates *self, unsigned a, unsigned b, double side, double inside, bool *moves)
{
    double near[JLT_DOMAIN_STATES_MAX], nearer[JLT_DOMAIN_STATES_MAX], there[JLT_DOMAIN_STATES_MAX];

    rates_at(self, there, a, b, 0, inside);
    if (!(there[a] == 0 && there[b] == 0)) return false;
    rates_at(self, near, a, b, side * 0x1p-40, inside);
    rates_at(self, nearer, a, b, side * 0x1p-80, inside);
    *moves |= near[a] != 0 || near[b] != 0;
    return (fabs(nearer[a]) + fabs(nearer[b])) * 0x1p40 <= 4 * (fabs(near[a]) + fabs(near[b]));
}

/* Whether they do so wherever the others are. */
static bool vanish_together(const rates *self, unsigned a, unsigned b)
{
    const jlt_quantity *first = &self->states[a], *second = &self->states[b];
    const double low = fmax(first->low, second->low), high = fmin(first->high, second->high);
    bool moves = false;

    if (low > 0 || high < 0) return false;
    for (size_t k = 0; k < PLACES; k++)
        for (int side = -1; side <= 1; side += 2)
            if ((side < 0 ? low < 0 : high > 0) && !rest_at_zero(self, a, b, side, places[k], &moves)) return false;
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
