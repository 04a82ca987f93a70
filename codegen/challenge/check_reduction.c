/* Checks reductions and embeddings at one point: the image lies in the target's domain and moves as the target says; that of a
 * reduction has the target's dimension, that of an embedding the dimension here. */
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

/* The target's parameters and states at the image; given parameters must be constant along the flow. */
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

/* Whether a binding gives a state of the target, or, for an embedding, a parameter. */
static bool has_row(const ttc_check *check, size_t binding)
{
    uint32_t symbol;
    if (!ttc_model_find_symbol(check->target, check->claim->target_names[binding], &symbol)) return false;
    return check->target->symbols[symbol].kind == TTC_STATE
           || (check->target->symbols[symbol].kind == TTC_PARAM && check->claim->kind == TTC_CLAIM_EMBEDDING);
}

/* Derivatives of the images by the states, shape (rows, states); rows that are not used are zero. */
static bool fill_derivatives(ttc_check *check, arb_mat_t rows)
{
    for (size_t i = 0; i < check->claim->bindings.count; i++) {
        if (!has_row(check, i)) continue;
        arb_srcptr jet = ttc_check_at(check, check->claim->bindings.items[i].expression);
        if (jet == NULL) return false;
        for (size_t k = 0; k < check->model->state_count; k++) arb_set(arb_mat_entry(rows, (long)i, (long)k), jet + 1 + k);
    }
    return true;
}

/* J has the derivatives of the images. Onto: the target's states have independent gradients at some point, so that J J^T, without
 * zero rows, is invertible there. Into: J has independent columns, so that J^T J is. Not checked under conditions. */
static void check_dimension(ttc_check *check)
{
    const long rows = (long)check->claim->bindings.count, n = (long)check->model->state_count;
    const long precision = ttc_probe_precision(check->probe);
    const bool onto = check->claim->kind == TTC_CLAIM_REDUCTION;
    const long size = onto ? rows : n;
    arb_t determinant;
    arb_mat_t derivatives, transposed, gram;
    if (check->claim->modulo_count > 0 || check->claim->when.count > 0) return;
    arb_init(determinant);
    arb_mat_init(derivatives, rows, n);
    arb_mat_init(transposed, n, rows);
    arb_mat_init(gram, size, size);
    if (fill_derivatives(check, derivatives)) {
        arb_mat_transpose(transposed, derivatives);
        if (onto) arb_mat_mul(gram, derivatives, transposed, precision);
        else arb_mat_mul(gram, transposed, derivatives, precision);
        for (long i = 0; onto && i < rows; i++)
            if (!has_row(check, (size_t)i)) arb_one(arb_mat_entry(gram, i, i));
        arb_mat_det(determinant, gram, precision);
        ttc_check_witness(check, determinant);
    }
    arb_mat_clear(gram);
    arb_mat_clear(transposed);
    arb_mat_clear(derivatives);
    arb_clear(determinant);
}

void ttc_check_reduction(ttc_check *check)
{
    char fault[256];
    if (check->target == NULL || !set_image(check)) {
        ttc_check_undefined(check);
        return;
    }
    if (ttc_domain_locate_image(check->target_probe, check->target, fault, sizeof fault) == TTC_OUTSIDE)
        ttc_check_violate(check, "the image leaves the domain of the target:", fault);
    check_given_roots(check);
    check_chain_rule(check);
    ttc_check_observations(check, check->probe);
    check_dimension(check);
}
