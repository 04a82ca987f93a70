#include "integrate/signs.h"

#include <math.h>

enum {
    PLACES = 32,
    FIRST = 4, /* places that are enough to look for groups: what is found there is tested at all PLACES */
    N = JLT_DOMAIN_STATES_MAX
};

typedef struct {
    const jlt_field *field;
    const jlt_quantity *states; /* whose intervals */
} rates;

/* Compute the rates, shape (dim,), where the states of the set have the value `at`, and the others are spread over their intervals,
 * in different parts of these, so that terms do not cancel; where an interval is infinite, at distances of all sizes from its end,
 * or from 0 on either side. */
static void rates_at(const rates *self, double *f, const jlt_state_set *set, double at, unsigned place)
{
    static const double golden = 0.6180339887498949;
    double x[N];

    for (unsigned j = 0; j < self->field->dim; j++) {
        const double low = self->states[j].low, high = self->states[j].high, part = fmod((place + 1) * (j + 1) * golden, 1);
        const double either = 2 * part - 1, away = exp2(20 * part - 12);
        x[j] = jlt_state_set_has(set, j) ? at
               : isfinite(low)           ? isfinite(high) ? low + part * (high - low) : low + away
               : isfinite(high)          ? high - away
                                         : copysign(exp2(20 * fabs(either) - 12), either);
    }
    self->field->call(x, self->field->p, f);
}

/* The sum of |f_i| over the set; NaN if one is. */
static double size(const rates *self, const double *f, const jlt_state_set *set)
{
    double sum = 0;

    for (unsigned i = 0; i < self->field->dim; i++)
        if (jlt_state_set_has(set, i)) sum += fabs(f[i]);
    return sum;
}

/* Whether the rates of the set's states go to 0 with these states, and about as fast (a rate like sqrt(x) lets x reach 0). *moves
 * becomes true if one is not 0 near there. Outside the domain there may be no rates: NaN counts as going to 0. */
static bool rest_at_zero(const rates *self, const jlt_state_set *set, double side, unsigned place, bool *moves)
{
    double f[N];

    rates_at(self, f, set, 0, place);
    if (isnan(size(self, f, set))) return true;
    if (size(self, f, set) > 0) return false;
    rates_at(self, f, set, side * 0x1p-40, place);
    const double near = size(self, f, set);
    rates_at(self, f, set, side * 0x1p-80, place);
    *moves |= near > 0;
    return !(size(self, f, set) * 0x1p40 > 4 * near);
}

/* Whether rest_at_zero holds whatever the other states are, and some rate is not 0 near there. */
static bool vanish_together(const rates *self, const jlt_state_set *set)
{
    double low = -INFINITY, high = INFINITY;
    bool moves = false;

    for (unsigned i = 0; i < self->field->dim; i++) {
        if (!jlt_state_set_has(set, i)) continue;
        low = fmax(low, self->states[i].low);
        high = fmin(high, self->states[i].high);
    }
    if (low > 0 || high < 0) return false;
    for (unsigned place = 0; place < PLACES; place++) {
        const double side = low == 0 || (high > 0 && place % 2 == 0) ? 1 : -1;
        if (!rest_at_zero(self, set, side, place, &moves)) return false;
    }
    return moves;
}

/* Remove states from the set until the rates of those left are 0 where all of these are 0. A rate that has no value there, as at a
 * centre of attraction, is taken for 0: what is found by that is tested elsewhere. */
static void shrink(const rates *self, jlt_state_set *set)
{
    double f[N];

    for (bool shrinks = true; shrinks;) {
        shrinks = false;
        for (unsigned place = 0; place < FIRST; place++) {
            rates_at(self, f, set, 0, place);
            for (unsigned i = 0; i < self->field->dim; i++) {
                if (!jlt_state_set_has(set, i) || !(fabs(f[i]) > 0)) continue;
                jlt_state_set_remove(set, i);
                shrinks = true;
            }
        }
    }
}

/* Find the drivers of each state of `all`: itself; each j such that its rate is not 0 where j alone is not 0; and the drivers of
 * these. drivers: shape (dim,). */
static void find_drivers(const rates *self, jlt_state_set *drivers, const jlt_state_set *all)
{
    const unsigned dim = self->field->dim;
    double f[N];

    for (unsigned j = 0; j < dim; j++) {
        if (!jlt_state_set_has(all, j)) continue;
        jlt_state_set others = *all;
        jlt_state_set_remove(&others, j);
        jlt_state_set_add(&drivers[j], j);
        for (unsigned place = 0; place < FIRST; place++) {
            rates_at(self, f, &others, 0, place);
            for (unsigned i = 0; i < dim; i++)
                if (jlt_state_set_has(all, i) && fabs(f[i]) > 0) jlt_state_set_add(&drivers[i], j);
        }
    }
    for (unsigned via = 0; via < dim; via++)
        for (unsigned i = 0; i < dim; i++)
            if (jlt_state_set_has(&drivers[i], via)) jlt_state_set_join(&drivers[i], &drivers[via]);
}

/* Make the set a group if its states vanish together, and none of them is in a group. */
static void add_group(const rates *self, jlt_state_groups *groups, const jlt_state_set *set)
{
    for (unsigned i = 0; i < self->field->dim; i++)
        if (jlt_state_set_has(set, i) && groups->of[i] != 0) return;
    if (!vanish_together(self, set)) return;
    groups->count++;
    for (unsigned i = 0; i < self->field->dim; i++) {
        if (!jlt_state_set_has(set, i)) continue;
        groups->of[i] = (unsigned char)groups->count;
        groups->member[groups->members++] = (unsigned char)i;
    }
}

void jlt_signs_find(jlt_field *field, const jlt_quantity *states)
{
    const rates self = { field, states };
    jlt_state_set all = { 0 }, drivers[N] = { 0 };

    for (unsigned i = 0; i < field->dim; i++) {
        jlt_state_set alone = { 0 };
        jlt_state_set_add(&alone, i);
        if ((int)i == field->root) continue; /* it has a scale of its own */
        if (vanish_together(&self, &alone)) jlt_state_set_add(&field->kept, i);
        else if (states[i].low <= 0 && states[i].high >= 0) jlt_state_set_add(&all, i);
    }
    shrink(&self, &all);
    find_drivers(&self, drivers, &all);
    for (unsigned count = 2; count < field->dim; count++) /* small groups first */
        for (unsigned i = 0; i < field->dim; i++)
            if (jlt_state_set_count(&drivers[i]) == count) add_group(&self, &field->groups, &drivers[i]);
}
