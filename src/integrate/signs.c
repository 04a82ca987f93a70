#include "integrate/signs.h"

#include <math.h>

enum {
    PLACES = 32,
    FIRST = 4, /* places that are enough to look for groups: what is found there is tested at all PLACES */
    LOOKS = 200, /* sets in the search for groups */
    N = JLT_DOMAIN_STATES_MAX
};

typedef struct {
    const jlt_field *field;
    const jlt_quantity *states; /* whose intervals */
} rates;

static jlt_state_set without(const jlt_state_set *set, const jlt_state_set *left_out)
{
    jlt_state_set rest;

    for (unsigned k = 0; k < JLT_STATE_SET_WORDS; k++) rest.words[k] = set->words[k] & ~left_out->words[k];
    return rest;
}

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

/* Find the drivers of each state of `all` while those of `left_out` are not 0: itself; each j such that its rate is not 0 where j
 * and those alone are not 0; and the drivers of these. drivers: shape (dim,). */
static void find_drivers(const rates *self, jlt_state_set *drivers, const jlt_state_set *all, const jlt_state_set *left_out)
{
    const unsigned dim = self->field->dim;
    double f[N];

    for (unsigned j = 0; j < dim; j++) {
        drivers[j] = (jlt_state_set){ 0 };
        if (jlt_state_set_has(all, j)) jlt_state_set_add(&drivers[j], j);
    }
    for (unsigned j = 0; j < dim; j++) {
        if (!jlt_state_set_has(all, j) || jlt_state_set_has(left_out, j)) continue;
        jlt_state_set others = without(all, left_out);
        jlt_state_set_remove(&others, j);
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

typedef struct {
    const rates *rates;
    const jlt_state_set *all;
    jlt_state_groups *groups;
    unsigned looks; /* how many sets may still be looked at */
} search;

/* Whether the set holds a group that has state i. */
static bool holds_group(const search *self, const jlt_state_set *set, unsigned i)
{
    const jlt_state_groups *groups = self->groups;

    for (unsigned g = 0; g < groups->count; g++) {
        bool has = false, within = true;
        for (unsigned k = groups->first[g]; k < groups->first[g + 1]; k++) {
            has = has || groups->member[k] == i;
            within = within && jlt_state_set_has(set, groups->member[k]);
        }
        if (has && within) return true;
    }
    return false;
}

/* Make the set a group if its states vanish together, and there is room. */
static void add_group(const search *self, const jlt_state_set *set)
{
    jlt_state_groups *groups = self->groups;
    unsigned end = groups->first[groups->count];

    if (groups->count == JLT_STATE_GROUPS_MAX || end + jlt_state_set_count(set) > JLT_STATE_MEMBERS_MAX) return;
    if (!vanish_together(self->rates, set)) return;
    for (unsigned i = 0; i < self->rates->field->dim; i++)
        if (jlt_state_set_has(set, i)) groups->member[end++] = (unsigned char)i;
    groups->first[++groups->count] = end;
    jlt_state_set_join(&groups->any, set);
}

/* Find a state outside the set on which rates of the set's states depend while these are 0; dim if there is none. */
static unsigned find_factor(const search *self, const jlt_state_set *set, const jlt_state_set *left_out)
{
    const unsigned dim = self->rates->field->dim;
    const jlt_state_set rest = without(self->all, left_out);
    double f[N], there[N];

    for (unsigned place = 0; place < FIRST; place++) {
        rates_at(self->rates, f, set, 0, place);
        if (!(size(self->rates, f, set) > 0)) continue;
        for (unsigned j = 0; j < dim; j++) {
            jlt_state_set with = *set;
            if (!jlt_state_set_has(&rest, j) || jlt_state_set_has(set, j)) continue;
            jlt_state_set_add(&with, j);
            rates_at(self->rates, there, &with, 0, place);
            for (unsigned i = 0; i < dim; i++)
                if (jlt_state_set_has(set, i) && fabs(f[i] - there[i]) > 0) return j;
        }
    }
    return dim;
}

/* Whether states of the set have rates where all but those that are left out are 0. */
static bool is_driven(const search *self, const jlt_state_set *set, const jlt_state_set *left_out)
{
    const jlt_state_set rest = without(self->all, left_out);
    double f[N];

    for (unsigned place = 0; place < FIRST; place++) {
        rates_at(self->rates, f, &rest, 0, place);
        if (size(self->rates, f, set) > 0) return true;
    }
    return false;
}

/* Add the least groups that have state i, hold the set, and have no state that is left out. Where a product drives one of the set,
 * one of its factors must be in the group: groups with the factor are found first, then those without it. drivers: while those that
 * are left out are not 0. */
static void find_groups(search *self, unsigned i, jlt_state_set set, const jlt_state_set *left_out, const jlt_state_set *drivers)
{
    const unsigned dim = self->rates->field->dim;

    for (unsigned j = 0; j < dim; j++)
        if (jlt_state_set_has(&set, j)) jlt_state_set_join(&set, &drivers[j]);
    if (jlt_state_set_count(&set) >= dim || holds_group(self, &set, i) || self->looks == 0) return;
    self->looks--;
    if (is_driven(self, &set, left_out)) return;
    const unsigned factor = find_factor(self, &set, left_out);
    if (factor == dim) {
        if (jlt_state_set_count(&set) > 1) add_group(self, &set);
        return;
    }
    jlt_state_set with = set, without_it = *left_out, then[N];
    jlt_state_set_add(&with, factor);
    find_groups(self, i, with, left_out, drivers);
    if (self->looks == 0) return;
    jlt_state_set_add(&without_it, factor);
    find_drivers(self->rates, then, self->all, &without_it);
    find_groups(self, i, set, &without_it, then);
}

void jlt_signs_find(jlt_field *field, const jlt_quantity *states)
{
    const rates self = { field, states };
    const jlt_state_set none = { 0 };
    jlt_state_set all = { 0 }, drivers[N];
    search of = { &self, &all, &field->groups, LOOKS };

    for (unsigned i = 0; i < field->dim; i++) {
        jlt_state_set alone = { 0 };
        jlt_state_set_add(&alone, i);
        if ((int)i == field->root) continue; /* it has a scale of its own */
        if (vanish_together(&self, &alone)) jlt_state_set_add(&field->kept, i);
        if (states[i].low <= 0 && states[i].high >= 0) jlt_state_set_add(&all, i);
    }
    shrink(&self, &all);
    find_drivers(&self, drivers, &all, &none);
    for (unsigned i = 0; i < field->dim; i++)
        if (jlt_state_set_has(&all, i) && !jlt_state_set_has(&field->kept, i)) find_groups(&of, i, drivers[i], &none, drivers);
}
