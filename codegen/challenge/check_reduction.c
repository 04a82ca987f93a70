/* Reductions, at one point: the image lies in the target's domain, moves as the target says, and fills its dimensions. */
#include "challenge/check.h"

#include <string.h>

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

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

/* Column j of the images' derivatives: by the states, then by the parameters. */
static bool fill_derivatives(ttc_check *check, arb_mat_t rows)
{
    const ttc_model *model = check->model, *target = check->target;
    const size_t n = model->state_count;
    bool good = true;
    for (size_t first = 0; good && (first == 0 || first < model->param_count); first += TTC_PROBE_SPARE) {
        ttc_probe_seed_states(check->probe);
        for (size_t k = 0; k < TTC_PROBE_SPARE && first + k < model->param_count; k++)
            ttc_probe_seed(check->probe, model->params[first + k], n + k);
        for (size_t i = 0; good && i < target->state_count; i++) {
            arb_srcptr jet = ttc_check_at(check, image_of(check, target->symbols[target->states[i]].name)->expression);
            good = jet != NULL;
            for (size_t k = 0; good && k < n; k++) arb_set(arb_mat_entry(rows, (long)i, (long)k), jet + 1 + k);
            for (size_t k = 0; good && k < TTC_PROBE_SPARE && first + k < model->param_count; k++)
                arb_set(arb_mat_entry(rows, (long)i, (long)(n + first + k)), jet + 1 + n + k);
        }
    }
    ttc_probe_seed_states(check->probe);
    return good;
}

/* The Gram determinant of the images' gradients, by states and parameters, differs from zero at some point: the image has
 * full dimension (a model on levels of integrals has their values as parameters). With conditions this is not looked at. */
static void check_dimension(ttc_check *check)
{
    const long m = (long)check->target->state_count, precision = ttc_probe_precision(check->probe);
    const long columns = (long)(check->model->state_count + check->model->param_count);
    arb_t determinant;
    arb_mat_t rows, transposed, gram;
    if (check->claim->modulo_count > 0 || check->claim->when.count > 0) return;
    arb_init(determinant);
    arb_mat_init(rows, m, columns);
    arb_mat_init(transposed, columns, m);
    arb_mat_init(gram, m, m);
    if (fill_derivatives(check, rows)) {
        arb_mat_transpose(transposed, rows);
        arb_mat_mul(gram, rows, transposed, precision);
        arb_mat_det(determinant, gram, precision);
        ttc_check_witness(check, determinant);
    }
    arb_mat_clear(gram);
    arb_mat_clear(transposed);
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
