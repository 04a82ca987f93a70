/* What is derived from records that are no claims (roots, variants, times, eliminations), and reductions, at one point. */
#include "challenge/check.h"

#include <string.h>

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

void ttc_check_root(ttc_check *check)
{
    const ttc_symbol_entry *root = &check->model->symbols[check->index];
    arb_srcptr radicand = ttc_check_at(check, root->definition);
    if (radicand != NULL) ttc_check_positive(check, radicand, "the radicand of", root->name);
}

/* The variant's parameters, with the others as they are, have their signs. */
void ttc_check_variant(ttc_check *check)
{
    const ttc_bindings *map = &check->model->variants[check->index].bindings;
    arb_ptr images = _arb_vec_init((long)map->count);
    bool good = true;
    for (size_t i = 0; good && i < map->count; i++) {
        arb_srcptr image = ttc_check_at(check, map->items[i].expression);
        good = image != NULL;
        if (good) arb_set(images + i, image);
    }
    for (size_t i = 0; good && i < map->count; i++) {
        const ttc_symbol_entry *entry = &check->model->symbols[map->items[i].symbol];
        if (entry->sign == TTC_POSITIVE) ttc_check_positive(check, images + i, "not positive in the variant:", entry->name);
        if (entry->sign == TTC_NONNEGATIVE && arb_is_negative(images + i))
            ttc_check_violate(check, "negative in the variant:", entry->name);
        if (entry->sign == TTC_NONZERO && arb_is_zero(images + i))
            ttc_check_violate(check, "zero in the variant:", entry->name);
        ttc_probe_set(check->probe, map->items[i].symbol, images + i);
    }
    _arb_vec_clear(images, (long)map->count);
}

void ttc_check_time(ttc_check *check)
{
    const ttc_time *time = &check->model->times[check->index];
    arb_srcptr factor = ttc_check_at(check, time->factor);
    if (factor != NULL) ttc_check_positive(check, factor, "dt/dtau of", time->name);
}

/* With the level at the integral's value, the solution is the state, and moves as the state does. */
void ttc_check_elimination(ttc_check *check)
{
    const ttc_elimination *elimination = &check->model->eliminations[check->index];
    const ttc_symbol_entry *state = &check->model->symbols[elimination->state];
    const long precision = ttc_probe_precision(check->probe);
    arb_t level, rate, speed;
    arb_init(level);
    arb_init(rate);
    arb_init(speed);
    arb_srcptr integral = ttc_check_at(check, check->model->claims[elimination->integral].expression);
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

static const ttc_binding *image_of(const ttc_check *check, const char *name)
{
    for (size_t i = 0; i < check->claim->bindings.count; i++)
        if (strcmp(check->claim->target_names[i], name) == 0) return &check->claim->bindings.items[i];
    return NULL;
}

/* The target's parameters and states at the image; a parameter that is given is a quantity that our flow keeps. */
static bool set_image(ttc_check *check)
{
    const ttc_model *target = check->target;
    bool good = true;
    arb_t rate;
    arb_init(rate);
    ttc_probe_begin(check->target_probe, ttc_probe_precision(check->probe));
    for (uint32_t i = 0; good && i < target->symbol_count; i++) {
        const ttc_symbol_entry *entry = &target->symbols[i];
        uint32_t own;
        const ttc_binding *given = image_of(check, entry->name);
        if (entry->kind != TTC_PARAM && entry->kind != TTC_STATE) continue;
        if (given != NULL) {
            arb_srcptr value = ttc_check_at(check, given->expression);
            good = value != NULL;
            if (good) ttc_probe_set(check->target_probe, i, value);
            if (good && entry->kind == TTC_PARAM && ttc_check_rate(check, rate, given->expression))
                ttc_check_zero(check, rate, "d/dt of the parameter", entry->name);
        } else if (entry->kind == TTC_PARAM && ttc_model_find_symbol(check->model, entry->name, &own)
                   && check->model->symbols[own].kind == TTC_PARAM) {
            ttc_probe_set(check->target_probe, i, ttc_probe_value(check->probe, own));
        } else {
            good = false;
        }
    }
    arb_clear(rate);
    if (!good) ttc_check_undefined(check);
    return good;
}

/* A root of the target that is given is the positive root of the radicand at the image. */
static void check_given_roots(ttc_check *check)
{
    arb_t difference;
    arb_init(difference);
    for (uint32_t i = 0; i < check->target->symbol_count; i++) {
        const ttc_symbol_entry *entry = &check->target->symbols[i];
        const ttc_binding *given = image_of(check, entry->name);
        if (entry->kind != TTC_ROOT || given == NULL) continue;
        arb_srcptr own = ttc_check_at(check, given->expression), root = ttc_probe_at(check->target_probe, entry->node);
        if (own == NULL || root == NULL) continue;
        arb_sub(difference, own, root, ttc_probe_precision(check->probe));
        ttc_check_zero(check, difference, "given root - root of the target:", entry->name);
    }
    arb_clear(difference);
}

/* The images move as the target says. */
static void check_chain_rule(ttc_check *check)
{
    const ttc_model *target = check->target;
    arb_t rate;
    arb_init(rate);
    for (size_t i = 0; i < target->state_count; i++) {
        const ttc_symbol_entry *state = &target->symbols[target->states[i]];
        arb_srcptr speed = ttc_probe_at(check->target_probe, ttc_model_field(target, i));
        if (speed == NULL) {
            ttc_check_undefined(check);
            break;
        }
        if (!ttc_check_rate(check, rate, image_of(check, state->name)->expression)) break;
        arb_sub(rate, rate, speed, ttc_probe_precision(check->probe));
        ttc_check_zero(check, rate, "chain rule - field of the target in", state->name);
    }
    arb_clear(rate);
}

/* The Gram determinant of the images' gradients differs from zero at some point: the image has full dimension. On a smaller
 * set of states this is not looked at. */
static void check_dimension(ttc_check *check)
{
    const long m = (long)check->target->state_count, precision = ttc_probe_precision(check->probe);
    const size_t n = check->model->state_count;
    bool good = check->claim->modulo_count == 0;
    arb_t determinant;
    arb_mat_t rows, columns, gram;
    for (size_t i = 0; i < check->claim->when.count; i++)
        good = good && check->model->symbols[check->claim->when.items[i].symbol].kind != TTC_STATE;
    if (!good) return;
    arb_init(determinant);
    arb_mat_init(rows, m, (long)n);
    arb_mat_init(columns, (long)n, m);
    arb_mat_init(gram, m, m);
    for (long i = 0; good && i < m; i++) {
        arb_srcptr jet = ttc_check_at(check, image_of(check, check->target->symbols[check->target->states[i]].name)->expression);
        good = jet != NULL;
        for (size_t k = 0; good && k < n; k++) arb_set(arb_mat_entry(rows, i, (long)k), jet + 1 + k);
    }
    if (good) {
        arb_mat_transpose(columns, rows);
        arb_mat_mul(gram, rows, columns, precision);
        arb_mat_det(determinant, gram, precision);
        ttc_check_witness(check, determinant);
    }
    arb_mat_clear(gram);
    arb_mat_clear(columns);
    arb_mat_clear(rows);
    arb_clear(determinant);
}

void ttc_check_reduction(ttc_check *check)
{
    char fault[256];
    if (check->target == NULL || !set_image(check)) {
        ttc_check_undefined(check);
        return;
    }
    if (ttc_domain_locate(check->target_probe, check->target, NULL, UINT32_MAX, fault, sizeof fault) == TTC_OUTSIDE)
        ttc_check_violate(check, "the image leaves the domain of the target:", fault);
    check_given_roots(check);
    check_chain_rule(check);
    check_dimension(check);
}
