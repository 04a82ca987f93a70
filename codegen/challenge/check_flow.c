/* Checks claims about the flow, at one point. */
#include "challenge/check.h"
#include "challenge/series.h"

#include <stdlib.h>

enum { SERIES_ORDER = 8 };

static void require_rate_zero(ttc_check *check, ttc_id id)
{
    arb_t rate;
    arb_init(rate);
    if (ttc_check_rate(check, rate, id)) ttc_check_zero(check, rate, "d/dt of", check->claim->name);
    arb_clear(rate);
}

/* The flow keeps the set that conditions on states define: each such state moves as what it is set to. */
static void require_set_kept(ttc_check *check)
{
    const ttc_bindings *when = &check->claim->when;
    arb_t left, right;
    arb_init(left);
    arb_init(right);
    for (size_t i = 0; i < when->count; i++) {
        const ttc_symbol_entry *entry = &check->model->symbols[when->items[i].symbol];
        if (entry->kind != TTC_STATE) continue;
        if (!ttc_check_rate(check, left, entry->node) || !ttc_check_rate(check, right, when->items[i].expression)) break;
        arb_sub(left, left, right, ttc_probe_precision(check->probe));
        ttc_check_zero(check, left, "the condition is not kept by the flow:", entry->name);
    }
    arb_clear(right);
    arb_clear(left);
}

static bool has_conditions_on_states(const ttc_check *check)
{
    const ttc_claim *claim = check->claim;
    for (size_t i = 0; i < claim->when.count; i++)
        if (check->model->symbols[claim->when.items[i].symbol].kind == TTC_STATE) return true;
    return claim->modulo_count > 0;
}

/* An integral also varies with the states; not checked where conditions restrict these. */
void ttc_check_integral(ttc_check *check)
{
    require_rate_zero(check, check->claim->expression);
    require_set_kept(check);
    if (has_conditions_on_states(check)) return;
    arb_srcptr jet = ttc_check_at(check, check->claim->expression);
    for (size_t k = 0; jet != NULL && k < check->model->state_count; k++) ttc_check_witness(check, jet + 1 + k);
}

/* The point lies on the claim's own zero level. Where this is singular, the rate is zero whatever the field: there no coefficient
 * of its series along the orbit may exclude zero. */
void ttc_check_invariant(ttc_check *check)
{
    arb_srcptr jet = ttc_check_at(check, check->claim->expression);
    require_rate_zero(check, check->claim->expression);
    if (jet == NULL || !_arb_vec_is_zero(jet + 1, (long)check->model->state_count)) return;
    arb_ptr series = _arb_vec_init(SERIES_ORDER + 1);
    if (ttc_series_along(check->probe, check->model, check->claim->expression, SERIES_ORDER, series))
        for (long k = 2; k <= SERIES_ORDER; k++)
            ttc_check_zero(check, series + k, "a coefficient along the orbit of", check->claim->name);
    else
        ttc_check_undefined(check);
    _arb_vec_clear(series, SERIES_ORDER + 1);
}

void ttc_check_rate_claim(ttc_check *check)
{
    arb_t rate;
    arb_init(rate);
    arb_srcptr claimed = ttc_check_at(check, check->claim->other);
    if (claimed != NULL && ttc_check_rate(check, rate, check->claim->expression)) {
        arb_sub(rate, rate, claimed, ttc_probe_precision(check->probe));
        ttc_check_zero(check, rate, "rate - right side of", check->claim->name);
    }
    arb_clear(rate);
}

/* div(rho f) = grad(rho) . f + rho tr(Df) */
void ttc_check_measure(ttc_check *check)
{
    arb_t divergence;
    arb_init(divergence);
    arb_srcptr density = ttc_check_at(check, check->claim->expression);
    if (density != NULL && ttc_check_rate(check, divergence, check->claim->expression)) {
        for (size_t k = 0; k < check->model->state_count; k++) {
            arb_srcptr speed = ttc_check_at(check, ttc_model_field(check->model, k));
            if (speed != NULL) arb_addmul(divergence, density, speed + 1 + k, ttc_probe_precision(check->probe));
        }
        ttc_check_zero(check, divergence, "div(rho f) of", check->claim->name);
        if (check->has_smooth_density) ttc_check_positive(check, density, "said to be positive, not so:", check->claim->name);
        ttc_check_witness(check, density);
    }
    arb_clear(divergence);
}

void ttc_check_equal(ttc_check *check)
{
    arb_t difference;
    arb_init(difference);
    arb_srcptr left = ttc_check_at(check, check->claim->expression), right = ttc_check_at(check, check->claim->other);
    if (left != NULL && right != NULL) {
        arb_sub(difference, left, right, ttc_probe_precision(check->probe));
        ttc_check_zero(check, difference, "left - right of", check->claim->name);
    }
    arb_clear(difference);
}

void ttc_check_positive_claim(ttc_check *check)
{
    arb_srcptr value = ttc_check_at(check, check->claim->expression);
    if (value != NULL) ttc_check_positive(check, value, "not positive:", check->claim->name);
}

/* Move the probe to the image of its point, in which the claim maps states. */
static bool move_to_image(ttc_check *check)
{
    const ttc_bindings *map = &check->claim->bindings;
    arb_ptr images = ttc_check_bindings(check, map);
    if (images == NULL) return false;
    for (size_t i = 0; i < map->count; i++) ttc_probe_set(check->probe, map->items[i].symbol, images + i);
    _arb_vec_clear(images, (long)map->count);
    return true;
}

/* DS f at the point, shape (states,) */
static bool push_forward(ttc_check *check, arb_ptr out)
{
    const ttc_model *model = check->model;
    for (size_t i = 0; i < model->state_count; i++) {
        ttc_id image = model->symbols[model->states[i]].node;
        for (size_t k = 0; k < check->claim->bindings.count; k++)
            if (check->claim->bindings.items[k].symbol == model->states[i]) image = check->claim->bindings.items[k].expression;
        if (!ttc_check_rate(check, out + i, image)) return false;
    }
    return true;
}

/* The image lies in the domain, and f(S x) - sign DS f(x) = 0, S being affine. */
static void check_map(ttc_check *check, int sign, const char *what)
{
    const ttc_model *model = check->model;
    const size_t n = model->state_count;
    const long precision = ttc_probe_precision(check->probe);
    char fault[256];
    arb_ptr mapped = _arb_vec_init((long)n);
    if (push_forward(check, mapped) && move_to_image(check)) {
        if (ttc_domain_locate_image(check->probe, model, fault, sizeof fault) == TTC_OUTSIDE)
            ttc_check_violate(check, "the image of the point leaves the domain:", fault);
        for (size_t i = 0; check->outcome != TTC_VIOLATED && i < n; i++) {
            arb_srcptr speed = ttc_check_at(check, ttc_model_field(model, i));
            if (speed == NULL) break;
            if (sign > 0) arb_neg(mapped + i, mapped + i);
            arb_add(mapped + i, mapped + i, speed, precision);
            ttc_check_zero(check, mapped + i, what, model->symbols[model->states[i]].name);
        }
    }
    _arb_vec_clear(mapped, (long)n);
}

/* S(S(x)) = x; check_map has moved the probe to S(x). */
static void check_involution(ttc_check *check, arb_srcptr before)
{
    const ttc_bindings *map = &check->claim->bindings;
    arb_t difference;
    arb_init(difference);
    for (size_t i = 0; i < map->count && check->outcome != TTC_VIOLATED; i++) {
        arb_srcptr again = ttc_check_at(check, map->items[i].expression);
        if (again == NULL) break;
        arb_sub(difference, again, before + i, ttc_probe_precision(check->probe));
        ttc_check_zero(check, difference, "S(S(x)) - x in", check->model->symbols[map->items[i].symbol].name);
    }
    arb_clear(difference);
}

void ttc_check_reversor(ttc_check *check)
{
    const ttc_bindings *map = &check->claim->bindings;
    arb_ptr before = _arb_vec_init((long)map->count);
    for (size_t i = 0; i < map->count; i++) arb_set(before + i, ttc_probe_value(check->probe, map->items[i].symbol));
    check_map(check, -1, "f(Sx) + DS f(x) in");
    check_involution(check, before);
    _arb_vec_clear(before, (long)map->count);
}

void ttc_check_symmetry(ttc_check *check) { check_map(check, 1, "f(Sx) - DS f(x) in"); }

/* What holds the table valid has the same value at the image; check_map has moved the probe to S(x). */
static void check_validities(ttc_check *check, arb_srcptr before, const bool *has_value)
{
    const ttc_model *model = check->model;
    for (size_t i = 0; i < model->validity_count && check->outcome != TTC_VIOLATED; i++) {
        arb_srcptr image = has_value[i] ? ttc_probe_at(check->probe, model->validities[i].expression) : NULL;
        if (image != NULL) ttc_check_same(check, image, before + i, "not the same at the image:", model->validities[i].name);
    }
}

void ttc_check_period(ttc_check *check)
{
    const ttc_model *model = check->model;
    arb_ptr before = _arb_vec_init((long)model->validity_count);
    bool *has_value = calloc(model->validity_count + 1, sizeof *has_value);
    for (size_t i = 0; has_value != NULL && i < model->validity_count; i++) {
        arb_srcptr value = ttc_probe_at(check->probe, model->validities[i].expression);
        has_value[i] = value != NULL;
        if (value != NULL) arb_set(before + i, value);
    }
    check_map(check, 1, "f(Sx) - DS f(x) in");
    if (has_value != NULL) check_validities(check, before, has_value);
    else ttc_check_undefined(check);
    free(has_value);
    _arb_vec_clear(before, (long)model->validity_count);
}
