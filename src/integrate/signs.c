#include "integrate/signs.h"

#include <math.h>

/* Places, as parts of intervals or of the way to infinity: near to 0 and far from it. */
static const double places[] = { 0.3, 0.7, 0.02, 0.98 };
enum { PLACES = sizeof places / sizeof *places };

/* Compute the rates, shape (dim,), where states a and b are `at`, and others are in the part `inside` of their intervals, or, where
 * these are infinite, as far from an end, or from 0 on either side. */
static void rates_at(const jlt_field *field, double *f, unsigned a, unsigned b, double at, double inside)
{
    double x[JLT_DOMAIN_STATES_MAX];

    for (unsigned j = 0; j < field->dim; j++) {
        const double low = field->domain.intervals[j].low, high = field->domain.intervals[j].high;
        const double away = inside / (1 - inside) * (1 + 0.1 * j), side = (j & 1) != (inside < 0.5) ? -1 : 1;
        x[j] = isfinite(low)    ? isfinite(high) ? low + inside * (high - low) : low + away
               : isfinite(high) ? high - away
                                : side * away;
    }
    x[a] = x[b] = at;
    field->call(x, field->p, f);
}

/* Whether the rates of states a and b, which may be one, go to 0 with them, about as fast: after sqrt(x) x comes to 0. *moves
 * becomes true where one is not 0 before. */
static bool rest_at_zero(const jlt_field *field, unsigned a, unsigned b, double side, double inside, bool *moves)
{
    double near[JLT_DOMAIN_STATES_MAX], nearer[JLT_DOMAIN_STATES_MAX], there[JLT_DOMAIN_STATES_MAX];

    rates_at(field, there, a, b, 0, inside);
    if (!(there[a] == 0 && there[b] == 0)) return false;
    rates_at(field, near, a, b, side * 0x1p-40, inside);
    rates_at(field, nearer, a, b, side * 0x1p-80, inside);
    *moves |= near[a] != 0 || near[b] != 0;
    return (fabs(nearer[a]) + fabs(nearer[b])) * 0x1p40 <= 4 * (fabs(near[a]) + fabs(near[b]));
}

/* Whether they do so wherever the others are. */
static bool vanish_together(const jlt_field *field, unsigned a, unsigned b)
{
    const jlt_quantity *first = &field->domain.intervals[a], *second = &field->domain.intervals[b];
    const double low = fmax(first->low, second->low), high = fmin(first->high, second->high);
    bool moves = false;

    if (low > 0 || high < 0) return false;
    for (size_t k = 0; k < PLACES; k++)
        for (int side = -1; side <= 1; side += 2)
            if ((side < 0 ? low < 0 : high > 0) && !rest_at_zero(field, a, b, side, places[k], &moves)) return false;
    return moves;
}

static bool is_free(const jlt_field *field, unsigned state, const jlt_state_set *paired)
{
    return !jlt_state_set_has(&field->kept, state) && !jlt_state_set_has(paired, state) && (int)state != field->root;
}

void jlt_signs_find(jlt_field *field)
{
    jlt_state_set paired = { 0 };

    if (field->domain.intervals == NULL) return;
    for (unsigned i = 0; i < field->dim; i++)
        if (vanish_together(field, i, i)) jlt_state_set_add(&field->kept, i);
    for (unsigned i = 0; i < field->dim && field->dim > 2; i++)
        for (unsigned j = i + 1; j < field->dim; j++) {
            if (!is_free(field, i, &paired) || !is_free(field, j, &paired) || !vanish_together(field, i, j)) continue;
            field->pairs.of[field->pairs.count++] = (jlt_state_pair){ (unsigned char)i, (unsigned char)j };
            jlt_state_set_add(&paired, i);
            jlt_state_set_add(&paired, j);
        }
}
