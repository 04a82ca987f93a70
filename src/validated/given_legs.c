#include "validated/given_turns.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool jlt_given_legs_number(arb_t out, const char *text, slong bits)
{
    bool good = text != NULL && text[0] != '\0' && text[strspn(text, "0123456789+-./eE")] == '\0';

    if (good && strchr(text, '/') != NULL) {
        fmpq_t fraction;
        fmpq_init(fraction);
        good = fmpq_set_str(fraction, text, 10) == 0 && !fmpz_is_zero(fmpq_denref(fraction));
        if (good) fmpq_canonicalise(fraction);
        if (good) arb_set_fmpq(out, fraction, bits);
        fmpq_clear(fraction);
    } else if (good) {
        good = strlen(text) < 4096 && arb_set_str(out, text, bits) == 0;
    }
    return good && arb_is_finite(out);
}

bool jlt_given_legs_ball(arb_t out, const json_t *ball, slong bits)
{
    arb_t radius;
    bool good;

    arb_init(radius);
    good = jlt_given_legs_number(radius, json_string_value(json_object_get(ball, "radius")), bits)
           && jlt_given_legs_number(out, json_string_value(json_object_get(ball, "middle")), bits) && !arb_is_negative(radius);
    if (good) arb_add_error(out, radius);
    arb_clear(radius);
    return good;
}

static void make_room(jlt_given_legs *self, const jlt_cycle_question *question, unsigned count)
{
    self->count = count;
    self->box = _arb_vec_init((slong)(count * (question->descriptor->state_count - 1)));
    self->instants = _arb_vec_init((slong)count);
}

static bool read_leg(arb_ptr box, arb_ptr instant, const jlt_cycle_question *question, const json_t *leg, char *problem)
{
    const jlt_descriptor *d = question->descriptor;
    const slong bits = jlt_step_accuracy_for(question->digits).bits;
    const json_t *balls = json_object_get(leg, "box");

    if (json_object_size(balls) > d->state_count - 1) {
        snprintf(problem, JLT_GIVEN_PROBLEM_MAX, "box: it names more than the %u states but the section's", d->state_count - 1);
        return false;
    }
    for (unsigned s = 0; s < d->state_count; s++) {
        if (s == question->column || jlt_given_legs_ball(box++, json_object_get(balls, d->states[s].name), bits)) continue;
        snprintf(problem, JLT_GIVEN_PROBLEM_MAX, "box: %s has no middle and radius", d->states[s].name);
        return false;
    }
    if (jlt_given_legs_number(instant, json_string_value(json_object_get(leg, "instant")), bits)) {
        arb_get_mid_arb(instant, instant);
        if (arb_is_positive(instant)) return true;
    }
    snprintf(problem, JLT_GIVEN_PROBLEM_MAX, "instant: a time > 0");
    return false;
}

bool jlt_given_legs_read(jlt_given_legs *self, const jlt_cycle_question *question, const json_t *legs,
                         char problem[JLT_GIVEN_PROBLEM_MAX])
{
    const size_t count = json_array_size(legs);
    bool good = true;

    if (count < 1 || count > JLT_CYCLE_LEGS_MAX) {
        snprintf(problem, JLT_GIVEN_PROBLEM_MAX, "legs: 1 to %d", JLT_CYCLE_LEGS_MAX);
        return false;
    }
    make_room(self, question, (unsigned)count);
    for (size_t i = 0; good && i < count; i++)
        good = read_leg(self->box + i * (question->descriptor->state_count - 1), self->instants + i, question,
                        json_array_get(legs, i), problem);
    return good && jlt_given_turns_read(self, question, legs, problem);
}

void jlt_given_legs_clear(jlt_given_legs *self, const jlt_cycle_question *question)
{
    if (self->count == 0) return;
    _arb_vec_clear(self->box, (slong)(self->count * (question->descriptor->state_count - 1)));
    _arb_vec_clear(self->instants, (slong)self->count);
    if (self->grown != NULL) _arb_vec_clear(self->grown, (slong)(self->count * question->descriptor->state_count));
    free(self->turns);
    *self = (jlt_given_legs){ .count = 0 };
}

void jlt_given_legs_guess(jlt_given_legs *self, const jlt_cycle_question *question, unsigned count, const double *x,
                          const double *T)
{
    const unsigned states = question->descriptor->state_count;
    arb_ptr out;

    make_room(self, question, count);
    out = self->box;
    for (unsigned i = 0; i < count * states; i++)
        if (i % states != question->column) arb_set_d(out++, x[i]);
    for (unsigned i = 0; i < count; i++) arb_set_d(self->instants + i, T[i]);
}

json_t *jlt_given_legs_decimal(const arb_t value, unsigned digits)
{
    char *text = arb_get_str(value, (slong)digits, ARB_STR_NO_RADIUS);
    json_t *out = json_string(text);

    flint_free(text);
    return out;
}

/* Of three digits, and no less. */
static json_t *own_radius(const arb_t value)
{
    char text[32];

    snprintf(text, sizeof text, "%.2e", 1.01 * mag_get_d(arb_radref(value)));
    return json_string(text);
}

json_t *jlt_given_legs_write(const jlt_given_legs *self, const jlt_cycle_question *question, const char *radius)
{
    const jlt_descriptor *d = question->descriptor;
    json_t *legs = json_array();
    arb_srcptr y = self->box;
    arb_t middle;

    arb_init(middle);
    for (unsigned i = 0; i < self->count; i++) {
        json_t *box = json_object();
        for (unsigned s = 0; s < d->state_count; s++) {
            if (s == question->column) continue;
            arb_get_mid_arb(middle, y);
            json_object_set_new(box, d->states[s].name,
                                json_pack("{s:o,s:o}", "middle", jlt_given_legs_decimal(middle, question->digits), "radius",
                                          radius != NULL ? json_string(radius) : own_radius(y)));
            y++;
        }
        json_array_append_new(legs, json_pack("{s:o,s:o,s:o*}", "box", box, "instant",
                                              jlt_given_legs_decimal(self->instants + i, question->digits), "turns",
                                              jlt_given_turns_write(self, question, i)));
    }
    arb_clear(middle);
    return legs;
}
