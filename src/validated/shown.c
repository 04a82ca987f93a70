#include "validated/shown.h"

#include "validated/theorem.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Relative margin of bounds as written: a replay may differ in last bits. */
static const double ROOM = 1e-5;

json_t *jlt_shown_ball(const arb_t ball, unsigned digits, bool replays)
{
    const slong places = (slong)digits + (replays ? 10 : 0);
    json_t *out = NULL;
    JLT_SCOPED(arb, roomy);

    arb_set(roomy, ball);
    if (!replays) mag_mul_2exp_si(arb_radref(roomy), arb_radref(roomy), 1);
    char *text = arb_get_str(roomy, places, ARB_STR_MORE), *between = strstr(text, " +/- "), *end = strchr(text, ']');
    if (strncmp(text, "[+/- ", 5) == 0 && end != NULL) { /* no digit of the midpoint is correct */
        *end = '\0';
        out = json_pack("{s:s,s:s}", "middle", "0", "radius", text + 5);
    } else if (between == NULL || end == NULL) out = json_pack("{s:s,s:s}", "middle", text, "radius", "0");
    else {
        *between = *end = '\0';
        out = json_pack("{s:s,s:s}", "middle", text + 1, "radius", between + 5);
    }
    flint_free(text);
    return out;
}

json_t *jlt_shown_lower_bound(const arf_t bound)
{
    json_t *out = NULL;
    char text[64];
    double value = arf_get_d(bound, ARF_RND_FLOOR);

    if (arf_is_nan(bound)) return json_string("-inf");
    value -= ROOM * fabs(value);
    JLT_SCOPED(arb, read);
    for (unsigned i = 0; i < 12; i++) { /* five digits, lowered until not above the bound: by at most 1e-4 of the value */
        snprintf(text, sizeof text, "%.5g", value);
        arb_set_str(read, text, 64);
        arb_get_ubound_arf(arb_midref(read), read, 64);
        if (arf_cmp(arb_midref(read), bound) <= 0) {
            out = json_string(text);
            break;
        }
        value -= ROOM * fabs(value);
    }
    return out;
}

json_t *jlt_shown_upper_bound(const arf_t bound)
{
    const char *below;
    char text[64];
    JLT_SCOPED(arf, opposite);

    arf_neg(opposite, bound);
    json_auto_t *lower = jlt_shown_lower_bound(opposite);
    below = json_string_value(lower);
    if (below == NULL) return NULL;
    snprintf(text, sizeof text, "%s%s", below[0] == '-' || strcmp(below, "0") == 0 ? "" : "-", below + (below[0] == '-'));
    return json_string(text);
}

static bool set(json_t *object, const char *key, json_t *value)
{
    return json_object_set_new(object, key, value) == 0;
}

static json_t *claims_of(const jlt_given *given, bool with_reversor)
{
    const jlt_descriptor *d = given->question.descriptor;
    const jlt_reversor *reversor = jlt_theorem_reversor(d);
    json_t *claims = json_array();
    char text[160];

    for (unsigned i = 0; i < given->question.level_count; i++) {
        snprintf(text, sizeof text, "integral %s", given->levels[i]);
        json_array_append_new(claims, json_string(text));
    }
    for (unsigned s = 0; given->legs.turns != NULL && s < d->state_count; s++) {
        bool turns = false;
        for (unsigned i = 0; i < given->legs.count; i++) turns |= given->legs.turns[i * d->state_count + s] != 0;
        snprintf(text, sizeof text, "periodic %s", d->states[s].name);
        if (turns) json_array_append_new(claims, json_string(text));
    }
    if (reversor != NULL && with_reversor) json_array_append_new(claims, json_string("reversor"));
    return claims;
}

json_t *jlt_shown_conditions(const arf_struct *least, const jlt_descriptor *d)
{
    json_t *conditions = json_object();

    for (unsigned i = 0; i < d->valid_count; i++)
        json_object_set_new(conditions, d->valids[i].name, jlt_shown_lower_bound(least + i));
    return conditions;
}

static json_t *ball_of(const arb_t ball, const jlt_given *given)
{
    return jlt_shown_ball(ball, given->question.digits, given->replays);
}

/* States other than the section's by names: x has these alone, or, with has_all, all of them. */
static json_t *point_of(arb_srcptr x, bool has_all, const jlt_given *given)
{
    const jlt_descriptor *d = given->question.descriptor;
    json_t *point = json_object();
    bool good = true;

    for (unsigned i = 0; i < d->state_count; i++)
        if (i != given->question.column)
            good = set(point, d->states[i].name, ball_of(x++, given)) && good;
        else if (has_all) x++;
    if (good) return point;
    json_decref(point);
    return NULL;
}

json_t *jlt_shown_cycle(const jlt_cycle_result *result, const jlt_given *given, bool with_reversor)
{
    json_t *shown = json_object(), *orbit = json_array(), *multipliers = json_array();
    bool good = true;

    for (unsigned i = 0; i < result->legs; i++)
        good = good && json_array_append_new(orbit, point_of(result->solution + i * result->unknowns, false, given)) == 0;
    for (unsigned i = 0; i < result->multipliers && result->multipliers <= 2; i++)
        good = good && json_array_append_new(multipliers,
                   json_pack("{s:o,s:o}", "re", ball_of(acb_realref(result->multiplier + i), given), "im",
                             ball_of(acb_imagref(result->multiplier + i), given))) == 0;
    good = set(shown, "orbit", orbit) && good;
    good = set(shown, "period", ball_of(result->period, given)) && good;
    good = set(shown, "determinant", ball_of(result->determinant, given)) && good;
    good = set(shown, "determinant_of_matrix", ball_of(result->matrix_determinant, given)) && good;
    good = set(shown, "trace", ball_of(result->trace, given)) && good;
    good = set(shown, "multipliers", multipliers) && good;
    good = set(shown, "conditions", jlt_shown_conditions(result->least, given->question.descriptor)) && good;
    good = set(shown, "claims", claims_of(given, with_reversor)) && good;
    if (good) return shown;
    json_decref(shown);
    return NULL;
}

json_t *jlt_shown_symmetry(const jlt_symmetry_result *result, const jlt_given *given)
{
    static const char *const types[] = {
        [JLT_SYMMETRY_UNSETTLED] = "not settled", [JLT_SYMMETRY_ELLIPTIC] = "elliptic", [JLT_SYMMETRY_HYPERBOLIC] = "hyperbolic",
        [JLT_SYMMETRY_INVERSE_HYPERBOLIC] = "inverse hyperbolic",
    };
    json_t *part = json_pack("{s:s}", "type", types[result->type]);
    bool good = set(part, "reversor", jlt_theorem_flipped(given->question.descriptor, result->reversor));

    if (result->type == JLT_SYMMETRY_ELLIPTIC)
        good = set(part, "rotation", ball_of(result->rotation, given)) && good;
    if (good) return part;
    json_decref(part);
    return NULL;
}

json_t *jlt_shown_twist(const jlt_elliptic_result *result, const jlt_given *given)
{
    return json_pack("{s:s,s:o,s:o}", "coordinate", given->question.descriptor->states[given->kept[0]].name, "coefficient",
                     ball_of(result->form.twist, given), "growth", ball_of(result->form.growth, given));
}

json_t *jlt_shown_homoclinic(const jlt_homoclinic_result *result, const jlt_given *given)
{
    json_t *shown = jlt_shown_cycle(&result->saddle, given, true), *part = json_object();
    bool good = set(part, "start", ball_of(result->start, given));

    good = set(part, "first", point_of(result->solution, false, given)) && good;
    good = set(part, "point", point_of(result->point, true, given)) && good;
    good = set(part, "tangent", point_of(result->tangent, true, given)) && good;
    good = set(part, "conditions", jlt_shown_conditions(result->least, given->question.descriptor)) && good;
    good = shown != NULL && set(shown, "homoclinic", part) && good;
    if (good) return shown;
    json_decref(shown);
    return NULL;
}
