#include "kernel/region.h"

#include <math.h>
#include <stdlib.h>

#include "core/guard.h"
#include "core/memory.h"

/* Exceptions are ignored: if some prepared values are not finite, conditions that do not depend on them still count. */
static void evaluate(double *values, const jlt_descriptor *descriptor, double *prepared, const double *params, const double *x)
{
    jlt_guard guard;

    jlt_guard_enter(&guard);
    descriptor->prepare(params, prepared);
    descriptor->domain_values.call(x, prepared, values);
    const jlt_status st = jlt_guard_leave(&guard);
    (void)st;
}

/* Whether a divisor is 0, or so small that rounding may have produced it from terms that sum to 0: within a few units in the last
 * place of its terms, the sum of whose squares is `squares`. */
static bool is_zero(double value, double squares)
{
    return value == 0 || (squares > 0x1p-900 && isfinite(squares) && fabs(value) <= 0x1p-51 * sqrt(squares));
}

jlt_status jlt_region_check(const jlt_region **region, double *value, const jlt_descriptor *descriptor, const double *params,
                            const double *x)
{
    *region = NULL;
    if (descriptor == NULL) return JLT_ERR_ARG;
    const unsigned count = descriptor->domain_count, divisors = descriptor->divisor_count, states = descriptor->state_count;
    if (count == 0 && divisors == 0) return JLT_OK;
    JLT_FREED double *room = jlt_memory_array((size_t)count + 2 * divisors + states + descriptor->prepared_count, sizeof *room);
    if (room == NULL) return JLT_ERR_NOMEM;
    double *divisor = room + count, *nowhere = divisor + 2 * divisors;
    for (unsigned i = 0; i < states; i++) nowhere[i] = 0;
    if (count > 0) evaluate(room, descriptor, nowhere + states, params, x != NULL ? x : nowhere);
    for (unsigned i = 0; i < count && *region == NULL; i++) {
        if (room[i] > 0 || (x == NULL && !descriptor->domains[i].of_params)) continue;
        *region = &descriptor->domains[i];
        *value = room[i];
    }
    if (divisors > 0) descriptor->divisor_values(x != NULL ? x : nowhere, params, divisor);
    for (unsigned i = 0; i < divisors && *region == NULL; i++) {
        if (!is_zero(divisor[2 * i], divisor[2 * i + 1]) || (x == NULL && !descriptor->divisors[i].of_params)) continue;
        *region = &descriptor->divisors[i];
        *value = divisor[2 * i];
    }
    return *region == NULL ? JLT_OK : JLT_ERR_DOMAIN;
}

bool jlt_region_holds(unsigned count, jlt_kernel_function values, const double *p, const double *x)
{
    double value[JLT_REGION_CONDITIONS_MAX];
    bool hold = true;

    if (count > 0) values(x, p, value);
    for (unsigned i = 0; i < count; i++) hold &= value[i] > 0;
    return hold;
}

enum { SINGLE_MAX = 64 };

/* The index of the only state on which a condition depends, if it does so linearly; its gradients at two places, shape (states,),
 * are given. Returns `states` if there is no such state. */
static unsigned single_state(const double *here, const double *there, unsigned states)
{
    unsigned single = states;

    for (unsigned i = 0; i < states; i++) {
        if (here[i] != there[i]) return states;
        if (here[i] == 0) continue;
        if (single != states) return states;
        single = i;
    }
    return single;
}

void jlt_region_intervals(double *low, double *high, const jlt_descriptor *descriptor, const double *prepared)
{
    const unsigned states = descriptor->state_count, count = descriptor->domain_count;
    double x[SINGLE_MAX] = { 0 }, value[SINGLE_MAX], gradient[2][SINGLE_MAX * SINGLE_MAX];

    for (unsigned i = 0; i < states; i++) {
        low[i] = descriptor->states[i].low;
        high[i] = descriptor->states[i].high;
    }
    if (prepared == NULL || count == 0 || count > SINGLE_MAX || states > SINGLE_MAX) return;
    for (unsigned i = 0; i < states; i++) x[i] = 1 + i / 7.0;
    descriptor->domain_gradients.call(x, prepared, gradient[1]);
    for (unsigned i = 0; i < states; i++) x[i] = 0;
    descriptor->domain_gradients.call(x, prepared, gradient[0]);
    descriptor->domain_values.call(x, prepared, value);
    for (unsigned k = 0; k < count; k++) {
        const unsigned i = single_state(gradient[0] + k * states, gradient[1] + k * states, states);
        const double end = i < states ? -value[k] / gradient[0][k * states + i] : NAN;
        if (!isfinite(end)) continue;
        if (gradient[0][k * states + i] > 0) low[i] = fmax(low[i], end);
        else high[i] = fmin(high[i], end);
    }
}
