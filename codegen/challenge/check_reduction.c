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

/* Add the row of the derivatives of an expression by the states. Returns false if it has no value. */
static bool add_row(ttc_check *check, arb_mat_t rows, long *count, ttc_id id)
{
    arb_srcptr jet = ttc_check_at(check, id);
    for (size_t k = 0; jet != NULL && k < check->model->state_count; k++)
        arb_set(arb_mat_entry(rows, *count, (long)k), jet + 1 + k);
    *count += jet != NULL;
    return jet != NULL;
}

/* The rows of what is given for the target's symbols of one kind. */
static bool add_images(ttc_check *check, arb_mat_t rows, long *count, ttc_symbol_kind kind)
{
    const ttc_bindings *given = &check->claim->bindings;
    uint32_t symbol;
    bool good = true;
    for (size_t i = 0; good && i < given->count; i++)
        if (ttc_model_find_symbol(check->target, check->claim->target_names[i], &symbol)
            && check->target->symbols[symbol].kind == kind)
            good = add_row(check, rows, count, given->items[i].expression);
    return good;
}

/* The rows of zero levels, and of each state less what `when` sets it to. */
static bool add_conditions(ttc_check *check, arb_mat_t rows, long *count)
{
    const ttc_model *model = check->model;
    const ttc_bindings *when = &check->claim->when;
    bool good = true;
    for (size_t i = 0; good && i < check->claim->modulo_count; i++)
        good = add_row(check, rows, count, model->claims[check->claim->modulo[i]].expression);
    for (size_t k = 0; k < model->state_count; k++)
        for (size_t i = 0; good && i < when->count; i++) {
            if (when->items[i].symbol != model->states[k]) continue;
            good = add_row(check, rows, count, when->items[i].expression);
            if (good) arb_sub_si(arb_mat_entry(rows, *count - 1, (long)k), arb_mat_entry(rows, *count - 1, (long)k), 1,
                                 ttc_probe_precision(check->probe));
        }
    return good;
}

/* The rank of the first rows, or less if balls are too wide. */
static long rank_of(const arb_mat_t rows, long count, long precision)
{
    const long n = arb_mat_ncols(rows);
    long rank = 0;
    arb_t factor;
    arb_mat_t rest;
    arb_init(factor);
    arb_mat_init(rest, arb_mat_nrows(rows), n);
    arb_mat_set(rest, rows);
    for (long j = 0; j < n && rank < count; j++) {
        const long pivot = arb_mat_find_pivot_partial(rest, rank, count, j);
        if (pivot < 0) continue;
        arb_mat_swap_rows(rest, NULL, rank, pivot);
        for (long i = rank + 1; i < count; i++) {
            arb_div(factor, arb_mat_entry(rest, i, j), arb_mat_entry(rest, rank, j), precision);
            for (long k = j; k < n; k++)
                arb_submul(arb_mat_entry(rest, i, k), factor, arb_mat_entry(rest, rank, k), precision);
        }
        rank++;
    }
    arb_mat_clear(rest);
    arb_clear(factor);
    return rank;
}

/* Somewhere, images of the states that meet the conditions have the target's dimension, or, of an embedding, that of these states.
 * What is given for the target's parameters counts with the conditions, or with the images. The dimension of states that meet
 * conditions is known where these are independent. */
static void check_dimension(ttc_check *check)
{
    const ttc_model *model = check->model;
    const ttc_claim *claim = check->claim;
    const bool onto = claim->kind == TTC_CLAIM_REDUCTION;
    const long n = (long)model->state_count, precision = ttc_probe_precision(check->probe);
    long conditions = 0, count;
    arb_t found;
    arb_mat_t rows;
    arb_init(found);
    arb_mat_init(rows, (long)(claim->modulo_count + claim->when.count + claim->bindings.count), n);
    bool good = add_conditions(check, rows, &conditions) && rank_of(rows, conditions, precision) == conditions;
    count = conditions;
    good = good && add_images(check, rows, &count, TTC_PARAM);
    const long fixed = good && onto ? rank_of(rows, count, precision) : conditions;
    if (good && add_images(check, rows, &count, TTC_STATE)) {
        const long wanted = onto ? (long)check->target->state_count : n - conditions;
        arb_set_si(found, rank_of(rows, count, precision) == fixed + wanted);
        ttc_check_witness(check, found);
    }
    arb_mat_clear(rows);
    arb_clear(found);
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
