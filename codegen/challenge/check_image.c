/* Computes the image of a point in another table, in balls. */
#include "challenge/check.h"

#include <string.h>

enum { TARGET_DRAWS = 12 };

/* The two values that give the target's i-th state at a probe of the model: sine and cosine of an angle, both times one positive
 * number, or the state and 1. Returns false if one has no value. */
static bool way_to(ttc_check *check, ttc_probe *probe, const ttc_image *image, size_t state, arb_t sine, arb_t cosine)
{
    const ttc_id *entries = check->claim->entries + 2 * ttc_image_state(image, check->target, state);
    arb_srcptr value = ttc_probe_at(probe, entries[0]);
    if (value != NULL) arb_set(sine, value);
    if (value != NULL) value = ttc_probe_at(probe, entries[1]);
    if (value == NULL) return false;
    arb_set(cosine, value);
    return true;
}

static bool set_params(ttc_check *check, const ttc_image *image)
{
    bool good = true;
    arb_t value;
    arb_init(value);
    for (size_t i = 0; good && i < check->target->param_count; i++) {
        bool is_root;
        const ttc_id id = ttc_image_param(check->model, check->claim, image, check->target, i, &is_root);
        arb_srcptr given = ttc_probe_at(check->probe, id);
        good = given != NULL && !(is_root && arb_is_negative(given));
        if (!good) continue;
        if (is_root) arb_sqrt(value, given, ttc_probe_precision(check->probe));
        else arb_set(value, given);
        ttc_probe_set(check->target_probe, check->target->params[i], value);
    }
    arb_clear(value);
    return good;
}

bool ttc_check_set_image(ttc_check *check, const ttc_image *image)
{
    const ttc_model *target = check->target;
    const long precision = ttc_probe_precision(check->probe);
    arb_t sine, cosine;
    arb_init(sine);
    arb_init(cosine);
    ttc_probe_begin(check->target_probe, precision);
    bool good = set_params(check, image);
    for (size_t i = 0; good && i < target->state_count; i++) {
        good = way_to(check, check->probe, image, i, sine, cosine);
        if (good && image->forms[ttc_image_state(image, target, i)] == TTC_GIVEN_ANGLE) {
            good = !(arb_contains_zero(sine) && arb_contains_zero(cosine));
            arb_atan2(sine, sine, cosine, precision);
        }
        if (good) ttc_probe_set(check->target_probe, target->states[i], sine);
    }
    arb_clear(cosine);
    arb_clear(sine);
    return good;
}

void ttc_check_same(ttc_check *check, arb_srcptr a, arb_srcptr b, const char *what, const char *name)
{
    arb_t difference;
    if (a == NULL || b == NULL) {
        ttc_check_undefined(check);
        return;
    }
    arb_init(difference);
    arb_sub(difference, a, b, ttc_probe_precision(check->probe));
    ttc_check_zero(check, difference, what, name);
    arb_clear(difference);
}

/* The expression that a table observes, holds valid or claims under a name. TTC_NONE: none. */
static ttc_id observed_under(const ttc_model *model, const char *name)
{
    for (size_t i = 0; i < model->observed_count; i++)
        if (strcmp(model->symbols[model->observed[i]].name, name) == 0) return model->symbols[model->observed[i]].node;
    return TTC_NONE;
}

static ttc_id valid_under(const ttc_model *model, const char *name)
{
    for (size_t i = 0; i < model->validity_count; i++)
        if (strcmp(model->validities[i].name, name) == 0) return model->validities[i].expression;
    return TTC_NONE;
}

static ttc_id integral_under(const ttc_model *model, const char *name)
{
    for (size_t i = 0; i < model->claim_count; i++) {
        const ttc_claim *claim = model->claims + i;
        if (claim->kind == TTC_CLAIM_INTEGRAL && claim->when.count + claim->modulo_count == 0 && strcmp(claim->name, name) == 0)
            return claim->expression;
    }
    return TTC_NONE;
}

static void check_alike(ttc_check *check, ttc_probe *probe, ttc_id own, ttc_id theirs, const char *name)
{
    arb_srcptr here = ttc_probe_at(probe, own), there = ttc_probe_at(check->target_probe, theirs);
    if (here != NULL && there != NULL) ttc_check_same(check, here, there, "not the same in both tables:", name);
}

void ttc_check_observations(ttc_check *check, ttc_probe *probe)
{
    const ttc_model *model = check->model, *target = check->target;
    for (size_t i = 0; i < model->observed_count; i++) {
        const ttc_symbol_entry *own = model->symbols + model->observed[i];
        check_alike(check, probe, own->node, observed_under(target, own->name), own->name);
    }
    for (size_t i = 0; i < model->validity_count; i++)
        check_alike(check, probe, model->validities[i].expression, valid_under(target, model->validities[i].name),
                    model->validities[i].name);
    for (size_t i = 0; i < model->claim_count; i++) {
        const char *name = model->claims[i].name;
        check_alike(check, probe, integral_under(model, name), integral_under(target, name), name);
    }
}

bool ttc_check_draw_target(ttc_check *check)
{
    const ttc_situation situation = { .model = check->target, .own_root = UINT32_MAX };
    ttc_random_point point;
    char fault[256];
    bool found = false;
    if (!ttc_random_point_init(&point, &situation)) return false;
    for (int draw = 0; !found && draw < TARGET_DRAWS; draw++) {
        const ttc_sample_range range = (ttc_sample_range)ttc_random_below(&check->random, TTC_SAMPLE_SPECIAL + 1);
        found = ttc_random_point_draw(&point, &situation, &check->random, range)
                && ttc_random_point_place(check->target_probe, &point, &situation, ttc_probe_precision(check->probe), fault,
                                          sizeof fault) == TTC_INSIDE;
    }
    ttc_random_point_clear(&point);
    check->is_at_target = found;
    return found;
}

void ttc_check_return(ttc_check *check, ttc_probe *probe, const ttc_image *image, size_t state, bool where_angles)
{
    const char *name = check->target->symbols[check->target->states[state]].name;
    arb_srcptr own = ttc_probe_value(check->target_probe, check->target->states[state]);
    const long precision = ttc_probe_precision(check->probe);
    arb_t sine, cosine, own_sine, own_cosine, along, across;
    arb_init(sine);
    arb_init(cosine);
    arb_init(own_sine);
    arb_init(own_cosine);
    arb_init(along);
    arb_init(across);
    if (!way_to(check, probe, image, state, sine, cosine)) {
        ttc_check_undefined(check);
    } else if (image->forms[ttc_image_state(image, check->target, state)] != TTC_GIVEN_ANGLE) {
        ttc_check_same(check, sine, own, "the way back leads elsewhere in", name);
    } else if (!where_angles || !arb_contains_zero(sine) || !arb_contains_zero(cosine)) {
        arb_sin_cos(own_sine, own_cosine, own, precision);
        arb_mul(along, sine, own_sine, precision);
        arb_addmul(along, cosine, own_cosine, precision);
        arb_mul(across, sine, own_cosine, precision);
        arb_submul(across, cosine, own_sine, precision);
        ttc_check_zero(check, across, "the way back leads elsewhere in", name);
        ttc_check_positive(check, along, "the way back leads to the opposite of", name);
    }
    arb_clear(across);
    arb_clear(along);
    arb_clear(own_cosine);
    arb_clear(own_sine);
    arb_clear(cosine);
    arb_clear(sine);
}
