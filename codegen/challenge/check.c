#include "challenge/check.h"

#include <stdio.h>

enum { ZERO_BITS = 64, SHOWN_DIGITS = 12, SHOWN_EXPONENT = 10000 };

/* Print a ball; if its exponent is huge, only its sign. */
static void print_ball(char *out, size_t size, const arb_t value)
{
    if (arf_cmpabs_2exp_si(arb_midref(value), SHOWN_EXPONENT) > 0 || arf_cmpabs_2exp_si(arb_midref(value), -SHOWN_EXPONENT) < 0) {
        snprintf(out, size, "%s", arf_is_zero(arb_midref(value)) ? "0" : arf_sgn(arb_midref(value)) < 0 ? "negative" : "positive");
        return;
    }
    char *text = arb_get_str(value, SHOWN_DIGITS, 0);
    snprintf(out, size, "%s", text);
    flint_free(text);
}

void ttc_check_violate(ttc_check *check, const char *what, const char *name)
{
    if (check->outcome == TTC_VIOLATED) return;
    check->outcome = TTC_VIOLATED;
    snprintf(check->what, sizeof check->what, "%s %s", what, name);
}

static void violate_by(ttc_check *check, const arb_t value, const char *what, const char *name)
{
    char ball[200], text[400];
    print_ball(ball, sizeof ball, value);
    snprintf(text, sizeof text, "%s %s =", what, name);
    ttc_check_violate(check, text, ball);
}

void ttc_check_divides(ttc_check *check, ttc_probe *probe, const ttc_model *model, ttc_divisor_role role, uint32_t owner,
                       size_t use_count, const char *what, const char *name)
{
    if (ttc_domain_divides_by_zero(probe, model, role, owner, use_count)) ttc_check_violate(check, what, name);
}

static void leave_untold(ttc_check *check)
{
    if (check->outcome == TTC_HOLDS) check->outcome = TTC_NOT_TOLD;
}

void ttc_check_undefined(ttc_check *check)
{
    if (check->outcome != TTC_VIOLATED) check->outcome = TTC_UNDEFINED;
}

void ttc_check_zero(ttc_check *check, const arb_t value, const char *what, const char *name)
{
    if (!arb_is_finite(value)) ttc_check_undefined(check);
    else if (!arb_contains_zero(value)) violate_by(check, value, what, name);
    else if (mag_cmp_2exp_si(arb_radref(value), -ZERO_BITS) > 0) leave_untold(check);
}

void ttc_check_positive(ttc_check *check, const arb_t value, const char *what, const char *name)
{
    if (!arb_is_finite(value)) ttc_check_undefined(check);
    else if (arb_is_nonpositive(value)) violate_by(check, value, what, name);
    else if (!arb_is_positive(value)) leave_untold(check);
}

void ttc_check_witness(ttc_check *check, const arb_t value)
{
    check->wants_witness = true;
    if (arb_is_finite(value) && !arb_contains_zero(value)) check->has_witness = true;
}

arb_srcptr ttc_check_at(ttc_check *check, ttc_id id)
{
    arb_srcptr jet = ttc_probe_at(check->probe, id);
    if (jet == NULL) ttc_check_undefined(check);
    return jet;
}

arb_ptr ttc_check_bindings(ttc_check *check, const ttc_bindings *map)
{
    arb_ptr values = _arb_vec_init((long)map->count);
    for (size_t i = 0; i < map->count; i++) {
        arb_srcptr value = ttc_check_at(check, map->items[i].expression);
        if (value == NULL) {
            _arb_vec_clear(values, (long)map->count);
            return NULL;
        }
        arb_set(values + i, value);
    }
    return values;
}

bool ttc_check_rate(ttc_check *check, arb_t out, ttc_id id)
{
    long precision = ttc_probe_precision(check->probe);
    arb_srcptr jet = ttc_check_at(check, id);
    arb_zero(out);
    for (size_t k = 0; jet != NULL && k < check->model->state_count; k++) {
        if (arb_is_zero(jet + 1 + k)) continue;
        arb_srcptr speed = ttc_check_at(check, ttc_model_field(check->model, k));
        if (speed == NULL) return false;
        arb_addmul(out, jet + 1 + k, speed, precision);
    }
    return jet != NULL;
}

bool ttc_check_jacobian(ttc_check *check, arb_ptr out)
{
    const size_t n = check->model->state_count;
    for (size_t i = 0; i < n; i++) {
        arb_srcptr jet = ttc_check_at(check, ttc_model_field(check->model, i));
        if (jet == NULL) return false;
        for (size_t j = 0; j < n; j++) arb_set(out + i * n + j, jet + 1 + j);
    }
    return true;
}
