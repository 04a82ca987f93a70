#include "validated/given_turns.h"
#include "validated/numerals.h"

#include <stdio.h>
#include <stdlib.h>

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

    if (json_object_size(balls) > d->state_count - 1)
        return jlt_refuse(problem, "box: it names more than the %u states but the section's", d->state_count - 1);
    for (unsigned s = 0; s < d->state_count; s++) {
        if (s == question->column || jlt_numerals_ball(box++, json_object_get(balls, d->states[s].name), bits)) continue;
        return jlt_refuse(problem, "box: %s has no middle and radius", d->states[s].name);
    }
    if (jlt_numerals_read(instant, json_string_value(json_object_get(leg, "instant")), bits)) {
        arb_get_mid_arb(instant, instant);
        if (arb_is_positive(instant)) return true;
    }
    return jlt_refuse(problem, "instant: a time > 0");
}

bool jlt_given_legs_read(jlt_given_legs *self, const jlt_cycle_question *question, const json_t *legs,
                         char problem[JLT_GIVEN_PROBLEM_MAX])
{
    const size_t count = json_array_size(legs);
    bool good = true;

    if (count < 1 || count > JLT_CYCLE_LEGS_MAX) return jlt_refuse(problem, "legs: 1 to %d", JLT_CYCLE_LEGS_MAX);
    make_room(self, question, (unsigned)count);
    for (size_t i = 0; good && i < count; i++)
        good = read_leg(self->box + i * (question->descriptor->state_count - 1), self->instants + i, question,
                        json_array_get(legs, i), problem);
    return good && jlt_given_turns_read(self, question, legs, problem);
}

bool jlt_given_legs_hold(const json_t *legs, const jlt_cycle_question *question, arb_srcptr y)
{
    const jlt_descriptor *d = question->descriptor;
    const slong bits = 2 * jlt_step_accuracy_for(question->digits).bits;

    for (size_t i = 0; i < json_array_size(legs); i++) {
        const json_t *box = json_object_get(json_array_get(legs, i), "box");
        for (unsigned s = 0; s < d->state_count; s++)
            if (s != question->column && !jlt_numerals_hold(json_object_get(box, d->states[s].name), y++, bits)) return false;
    }
    return true;
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

static json_t *in_digits(const char *form, double radius)
{
    char text[32];

    snprintf(text, sizeof text, form, radius);
    return json_string(text);
}

json_t *jlt_given_legs_write(const jlt_given_legs *self, const jlt_cycle_question *question, const double *radii)
{
    const jlt_descriptor *d = question->descriptor;
    json_t *legs = json_array();
    arb_srcptr y = self->box;
    JLT_SCOPED(arb, middle);

    for (unsigned i = 0; i < self->count; i++) {
        json_t *box = json_object();
        for (unsigned s = 0; s < d->state_count; s++) {
            if (s == question->column) continue;
            arb_get_mid_arb(middle, y);
            json_object_set_new(box, d->states[s].name,
                                json_pack("{s:o,s:o}", "middle", jlt_given_legs_decimal(middle, question->digits), "radius",
                                          radii != NULL ? in_digits("%.3g", radii[s])
                                                        : in_digits("%.2e", 1.01 * mag_get_d(arb_radref(y)))));
            y++;
        }
        json_array_append_new(legs, json_pack("{s:o,s:o,s:o*}", "box", box, "instant",
                                              jlt_given_legs_decimal(self->instants + i, question->digits), "turns",
                                              jlt_given_turns_write(self, question, i)));
    }
    return legs;
}
