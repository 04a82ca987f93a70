/* Computes the image of a point in another table, in balls. */
#include "challenge/check.h"

bool ttc_check_way_to(ttc_check *check, ttc_probe *probe, const ttc_image *image, size_t state, arb_t sine, arb_t cosine)
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
        good = ttc_check_way_to(check, check->probe, image, i, sine, cosine);
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
