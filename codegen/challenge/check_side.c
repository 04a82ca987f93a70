/* Checks what is derived from records that are no claims, at one point: roots, variants, times, eliminations, poles. */
#include "challenge/check.h"

#include <stdlib.h>

/* A root or a logarithm. Those below it in the table are not assumed to be defined: two roots could vouch for each other. */
void ttc_check_root(ttc_check *check)
{
    const ttc_symbol_entry *root = &check->model->symbols[check->index];
    arb_srcptr radicand = ttc_check_at(check, root->definition);
    const char *what = root->kind == TTC_ROOT ? "the radicand of" : "the argument of";
    if (radicand != NULL) ttc_check_positive(check, radicand, what, root->name);
}

static bool depends_on_parameters_alone(const ttc_model *model, ttc_id id)
{
    unsigned char *support = ttc_model_support(model, &id, 1);
    bool alone = support != NULL;
    for (size_t i = 0; alone && i < model->state_count; i++) alone = !support[model->states[i]];
    free(support);
    return alone;
}

/* Records `domain` in parameters alone; others narrow the variant's domain. */
static void check_conditions_on_parameters(ttc_check *check)
{
    const ttc_model *model = check->model;
    for (size_t i = 0; i < model->region_count; i++) {
        if (!depends_on_parameters_alone(model, model->regions[i].expression)) continue;
        arb_srcptr value = ttc_check_at(check, model->regions[i].expression);
        if (value != NULL) ttc_check_positive(check, value, "not positive in the variant:", model->regions[i].name);
    }
}

/* The variant's parameters have their signs, the others being as they are. */
void ttc_check_variant(ttc_check *check)
{
    const ttc_bindings *map = &check->model->variants[check->index].bindings;
    arb_ptr images = ttc_check_bindings(check, map);
    if (images == NULL) return;
    for (size_t i = 0; i < map->count; i++) {
        const ttc_symbol_entry *entry = &check->model->symbols[map->items[i].symbol];
        if (entry->sign == TTC_POSITIVE) ttc_check_positive(check, images + i, "not positive in the variant:", entry->name);
        if (entry->sign == TTC_NONNEGATIVE && arb_is_negative(images + i))
            ttc_check_violate(check, "negative in the variant:", entry->name);
        if (entry->sign == TTC_NONZERO && arb_is_zero(images + i))
            ttc_check_violate(check, "zero in the variant:", entry->name);
        ttc_probe_set(check->probe, map->items[i].symbol, images + i);
    }
    check_conditions_on_parameters(check);
    _arb_vec_clear(images, (long)map->count);
}

void ttc_check_time(ttc_check *check)
{
    const ttc_time *time = &check->model->times[check->index];
    arb_srcptr factor = ttc_check_at(check, time->factor);
    if (factor != NULL) ttc_check_positive(check, factor, "dt/dtau of", time->name);
}

enum { NEAR_BITS = 200, NEARER_BITS = 280, FALL_BITS = 10 };

/* out = the rate of a root in its time, with the state at end - 2^-bits*way. Returns false if undefined. */
static bool rate_near(ttc_check *check, arb_t out, const ttc_time *time, uint32_t root, uint32_t state, arb_srcptr end,
                      arb_srcptr way, long bits)
{
    const long precision = ttc_probe_precision(check->probe);
    arb_t near;
    arb_init(near);
    arb_mul_2exp_si(near, way, -bits);
    arb_sub(near, end, near, precision);
    ttc_probe_set(check->probe, state, near);
    ttc_probe_seed_states(check->probe);
    const bool has_rate = ttc_check_rate(check, out, check->model->symbols[root].node);
    arb_srcptr factor = has_rate ? ttc_check_at(check, time->factor) : NULL;
    if (factor != NULL) arb_mul(out, out, factor, precision);
    arb_clear(near);
    return factor != NULL;
}

/* The rate of a root must go to zero at the end. Like the square root of the distance, it falls by 2^-40 between the two places; a
 * fall by less than 2^-10 is a violation. */
static void check_rest(ttc_check *check, const ttc_time *time, uint32_t root, uint32_t state, arb_srcptr end, arb_srcptr way)
{
    const long precision = ttc_probe_precision(check->probe);
    arb_t before, after;
    arb_init(before);
    arb_init(after);
    if (rate_near(check, before, time, root, state, end, way, NEAR_BITS) &&
        rate_near(check, after, time, root, state, end, way, NEARER_BITS)) {
        arb_abs(before, before);
        arb_abs(after, after);
        arb_mul_2exp_si(after, after, FALL_BITS);
        arb_sub(before, before, after, precision);
        if (arb_is_negative(before))
            ttc_check_violate(check, "at an end that orbits should not run through changes", check->model->symbols[root].name);
    }
    arb_clear(after);
    arb_clear(before);
}

/* With the state at an end of its interval, some lifted root is zero, and comes to rest. */
static void check_end(ttc_check *check, uint32_t state, ttc_id end, ttc_id other)
{
    const ttc_model *model = check->model;
    bool vanishes = false;
    arb_t at, way;
    arb_srcptr value = ttc_check_at(check, end), opposite = ttc_check_at(check, other);
    if (value == NULL || opposite == NULL) return;
    arb_init(at);
    arb_init(way);
    arb_set(at, value);
    arb_sub(way, value, opposite, ttc_probe_precision(check->probe));
    for (size_t i = 0; i < model->time_count; i++)
        for (size_t k = 0; k < model->times[i].lifted_count; k++) {
            const uint32_t root = model->times[i].lifted[k];
            ttc_probe_set(check->probe, state, at);
            arb_srcptr radicand = ttc_probe_at(check->probe, model->symbols[root].definition);
            const bool is_zero = radicand == NULL || arb_contains_zero(radicand);
            if (radicand != NULL && is_zero) check_rest(check, &model->times[i], root, state, at, way);
            vanishes |= is_zero;
        }
    if (!vanishes) ttc_check_violate(check, "no lifted root is zero at an end of", model->symbols[state].name);
    arb_clear(way);
    arb_clear(at);
}

void ttc_check_pole(ttc_check *check)
{
    const uint32_t state = check->model->poles[check->index].state;
    const ttc_symbol_entry *entry = check->model->symbols + state;
    check_end(check, state, entry->low, entry->high);
    check_end(check, state, entry->high, entry->low);
}

/* With the level at the integral's value, the solution is the state, and moves as it does. If the integral depends on the level's
 * parameter, the state is set to the solution, and the integral must be the level there. */
void ttc_check_elimination(ttc_check *check)
{
    const ttc_elimination *elimination = &check->model->eliminations[check->index];
    const ttc_symbol_entry *state = &check->model->symbols[elimination->state];
    const long precision = ttc_probe_precision(check->probe);
    arb_t level, rate, speed;
    arb_init(level);
    arb_init(rate);
    arb_init(speed);
    const ttc_id expression = check->model->claims[elimination->integral].expression;
    const bool in_itself = ttc_model_depends(check->model, expression, elimination->level);
    arb_srcptr given = in_itself ? ttc_check_at(check, elimination->solution) : NULL;
    if (given != NULL) {
        arb_set(level, given);
        ttc_probe_set(check->probe, elimination->state, level);
    }
    arb_srcptr integral = in_itself && given == NULL ? NULL : ttc_check_at(check, expression);
    if (integral != NULL && in_itself) {
        arb_sub(level, integral, ttc_probe_value(check->probe, elimination->level), precision);
        ttc_check_zero(check, level, "integral - level", state->name);
        integral = NULL;
    }
    if (integral != NULL) {
        arb_set(level, integral);
        ttc_probe_set(check->probe, elimination->level, level);
        arb_srcptr solution = ttc_check_at(check, elimination->solution);
        if (solution != NULL) {
            arb_sub(level, solution, ttc_probe_value(check->probe, elimination->state), precision);
            ttc_check_zero(check, level, "solution - state", state->name);
        }
        if (ttc_check_rate(check, rate, elimination->solution) && ttc_check_rate(check, speed, state->node)) {
            arb_sub(rate, rate, speed, precision);
            ttc_check_zero(check, rate, "rate of the solution - rate of", state->name);
        }
    }
    arb_clear(speed);
    arb_clear(rate);
    arb_clear(level);
}
