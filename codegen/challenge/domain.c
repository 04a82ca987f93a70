/* Locates a point in the domain of a model, one condition after another. */
#include "challenge/random_point.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct {
    ttc_probe *probe;
    const ttc_model *model;
    const ttc_bindings *family;
    bool outside, unclear, innocent_outside;
    char *fault;
    size_t fault_size;
} search;

/* 1: positive, -1: not positive, 0: not known. */
static int sign_of(const arb_t value)
{
    if (arb_is_positive(value)) return 1;
    return arb_is_nonpositive(value) ? -1 : 0;
}

static bool is_blamed(const search *s, ttc_id id, uint32_t symbol)
{
    if (s->family == NULL) return true;
    for (size_t i = 0; i < s->family->count; i++)
        if (s->family->items[i].symbol == symbol || (id != TTC_NONE && ttc_model_depends(s->model, id, s->family->items[i].symbol)))
            return true;
    return false;
}

/* Record the sign of what must be positive. symbol: a state or parameter that it is about, or UINT32_MAX; id: an expression that
 * it depends on, or TTC_NONE. */
static void take(search *s, int sign, ttc_id id, uint32_t symbol, const char *what, const char *name)
{
    if (sign > 0) return;
    if (sign == 0) {
        s->unclear = true;
        return;
    }
    s->outside = true;
    if (!is_blamed(s, id, symbol)) s->innocent_outside = true;
    else if (s->fault[0] == '\0') snprintf(s->fault, s->fault_size, "%s %s", what, name);
}

static int sign_of_expression(search *s, ttc_id id)
{
    arb_srcptr value = ttc_probe_at(s->probe, id);
    return value == NULL ? 0 : sign_of(value);
}

static void check_parameter(search *s, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &s->model->symbols[symbol];
    arb_srcptr value = ttc_probe_value(s->probe, symbol);
    int sign = 1;
    if (!ttc_probe_is_set(s->probe, symbol)) sign = entry->sign == TTC_ANY_SIGN ? 1 : 0;
    else if (entry->sign == TTC_POSITIVE) sign = sign_of(value);
    else if (entry->sign == TTC_NONNEGATIVE) sign = arb_is_nonnegative(value) ? 1 : arb_is_negative(value) ? -1 : 0;
    else if (entry->sign == TTC_NONZERO) sign = !arb_contains_zero(value) ? 1 : arb_is_zero(value) ? -1 : 0;
    take(s, sign, TTC_NONE, symbol, "the sign of", entry->name);
}

static void check_end(search *s, uint32_t symbol, ttc_id end, bool low)
{
    arb_t distance;
    if (end == TTC_NONE) return;
    arb_srcptr at = ttc_probe_at(s->probe, end);
    int sign = 0;
    arb_init(distance);
    if (at != NULL && ttc_probe_is_set(s->probe, symbol)) {
        arb_sub(distance, ttc_probe_value(s->probe, symbol), at, ttc_probe_precision(s->probe));
        if (!low) arb_neg(distance, distance);
        sign = sign_of(distance);
    }
    arb_clear(distance);
    take(s, sign, end, symbol, "the interval of", s->model->symbols[symbol].name);
}

ttc_place_in_domain ttc_domain_locate(ttc_probe *probe, const ttc_model *model, const ttc_bindings *family, uint32_t except,
                                      char *fault, size_t fault_size)
{
    search s = { .probe = probe, .model = model, .family = family, .fault = fault, .fault_size = fault_size };
    fault[0] = '\0';
    for (size_t i = 0; i < model->param_count; i++) check_parameter(&s, model->params[i]);
    for (size_t i = 0; i < model->state_count; i++) {
        const ttc_symbol_entry *entry = &model->symbols[model->states[i]];
        check_end(&s, model->states[i], entry->low, true);
        check_end(&s, model->states[i], entry->high, false);
    }
    /* A record `domain` narrows a family as it narrows all else: no fault of the family. */
    for (size_t i = 0; i < model->region_count; i++) {
        int sign = sign_of_expression(&s, model->regions[i].expression);
        if (family != NULL && sign < 0) s.innocent_outside = true;
        else take(&s, sign, model->regions[i].expression, UINT32_MAX, "the domain record", model->regions[i].name);
    }
    for (uint32_t i = 0; i < model->symbol_count && i < except; i++)
        if (model->symbols[i].kind == TTC_ROOT || model->symbols[i].kind == TTC_LOG)
            take(&s, sign_of_expression(&s, model->symbols[i].definition), model->symbols[i].definition, UINT32_MAX,
                 model->symbols[i].kind == TTC_ROOT ? "the radicand of" : "the argument of", model->symbols[i].name);
    if (s.unclear || s.innocent_outside) fault[0] = '\0';
    if (s.innocent_outside) return TTC_OUTSIDE;
    if (s.unclear) return TTC_UNCLEAR;
    return s.outside ? TTC_OUTSIDE : TTC_INSIDE;
}

/* used: flags, by symbol, for free(), which this does. */
static bool divides_by_zero(ttc_probe *probe, const ttc_model *model, ttc_divisor_role role, uint32_t owner, unsigned char *used)
{
    bool zero = false;
    for (size_t i = 0; used != NULL && !zero && i < model->divisor_count; i++) {
        const ttc_divisor *divisor = &model->divisors[i];
        const bool is_used = divisor->role == TTC_DIVIDES_SYMBOL && used[divisor->owner];
        if (!is_used && (divisor->role != role || divisor->owner != owner)) continue;
        arb_srcptr value = ttc_probe_at(probe, divisor->divisor);
        zero = value != NULL && arb_is_zero(value);
    }
    free(used);
    return zero;
}

bool ttc_domain_divides_by_zero(ttc_probe *probe, const ttc_model *model, ttc_divisor_role role, uint32_t owner, size_t use_count)
{
    return divides_by_zero(probe, model, role, owner, ttc_model_uses_between(model, role, owner, 0, use_count));
}

ttc_place_in_domain ttc_domain_locate_image(ttc_probe *probe, const ttc_model *model, char *fault, size_t fault_size)
{
    if (!divides_by_zero(probe, model, TTC_DIVIDES_FIELD, 0, ttc_model_uses_of_domain(model)))
        return ttc_domain_locate(probe, model, NULL, UINT32_MAX, fault, fault_size);
    snprintf(fault, fault_size, "a denominator is zero");
    return TTC_OUTSIDE;
}
