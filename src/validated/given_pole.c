#include "validated/given_pole.h"

#include "kernel/descriptor.h"
#include "read/model.h"
#include "validated/numerals.h"
#include "validated/shown.h"

static bool read_pole(jlt_given_pole *self, const json_t *given, char *problem)
{
    const jlt_descriptor *d = self->question.descriptor;
    const char *name = json_string_value(json_object_get(given, "pole"));
    const char *time = json_string_value(json_object_get(given, "time"));
    const jlt_claim *claim = name == NULL ? NULL : jlt_descriptor_claim(d, "pole", name);
    const jlt_claim *runs = time == NULL ? NULL : jlt_descriptor_claim(d, "time", time);
    size_t state;

    if (claim == NULL || !jlt_descriptor_state(d, name, &state))
        return jlt_refuse(problem, "%s has no pole '%s'", d->model, name == NULL ? "" : name);
    if (claim->verdict != JLT_PROVED) return jlt_refuse_claim(problem, claim);
    self->question.state = (unsigned)state;
    self->question.time = time;
    if (runs == NULL) return jlt_refuse(problem, "time: %s has no such time", d->model);
    return runs->verdict == JLT_PROVED || jlt_refuse(problem, "the time %s of %s is not proved to run forwards", time, d->model);
}

static bool read_box(jlt_given_pole *self, const json_t *given, slong bits, char *problem)
{
    const jlt_descriptor *d = self->question.descriptor;
    const json_t *box = json_object_get(given, "box");

    if (!json_is_object(box) || json_object_size(box) != d->state_count)
        return jlt_refuse(problem, "box: it must give all %u states of %s", d->state_count, d->model);
    for (unsigned i = 0; i < d->state_count; i++)
        if (!jlt_given_read_value(self->box + i, json_object_get(box, d->states[i].name), bits))
            return jlt_refuse(problem, "box: %s: no number", d->states[i].name);
    return true;
}

static bool read_instant(jlt_given_pole *self, const json_t *given, bool asks, slong bits, char *problem)
{
    const json_t *instant = json_object_get(given, "instant");
    arb_t value;
    bool good;

    if (instant == NULL && asks) return true;
    arb_init(value);
    good = jlt_numerals_read(value, json_string_value(instant), bits);
    arf_set(self->instant, arb_midref(value));
    arb_clear(value);
    return (good && arf_sgn(self->instant) > 0) || jlt_refuse(problem, "instant: a number > 0");
}

bool jlt_given_pole_read(jlt_given_pole *self, const json_t *given, const jlt_descriptor *d, bool asks,
                         char problem[JLT_GIVEN_PROBLEM_MAX])
{
    const json_int_t digits = json_integer_value(json_object_get(given, "digits"));

    *self = (jlt_given_pole){ .question = { .descriptor = d, .digits = (unsigned)digits } };
    self->params = _arb_vec_init(d->param_count + 1);
    self->box = _arb_vec_init(d->state_count);
    arf_init(self->instant);
    self->question.params = self->params;
    self->question.box = self->box;
    if (digits < 5 || digits > JLT_GIVEN_DIGITS_MAX) return jlt_refuse(problem, "digits: between 5 and %d", JLT_GIVEN_DIGITS_MAX);
    if (d->state_count > JLT_CYCLE_STATES_MAX)
        return jlt_refuse(problem, "tables of up to %d states are served", JLT_CYCLE_STATES_MAX);
    const slong bits = jlt_step_accuracy_for((unsigned)digits).bits;
    return jlt_given_read_params(self->params, given, d, bits, problem) && read_pole(self, given, problem)
           && read_box(self, given, bits, problem) && read_instant(self, given, asks, bits, problem);
}

void jlt_given_pole_clear(jlt_given_pole *self)
{
    const jlt_descriptor *d = self->question.descriptor;

    _arb_vec_clear(self->params, d->param_count + 1);
    _arb_vec_clear(self->box, d->state_count);
    arf_clear(self->instant);
}

/* An end of the interval of a pole's state, which is a number, as text "p/q". */
static json_t *end_of(const jlt_descriptor *d, unsigned state, bool is_high)
{
    ttc_model *model = ttc_model_again(d->table, d->model);
    const ttc_symbol_entry *entry = model == NULL ? NULL : &model->symbols[model->states[state]];
    char *text = entry == NULL ? NULL : fmpq_get_str(NULL, 10, ttc_coefficient(model->graph, is_high ? entry->high : entry->low));
    json_t *out = json_string(text);

    flint_free(text);
    ttc_model_destroy(model);
    return out;
}

json_t *jlt_given_pole_shown(const jlt_given_pole *self, const jlt_pole_result *result)
{
    const jlt_descriptor *d = self->question.descriptor;
    const jlt_quantity *pole = &d->states[self->question.state];
    const unsigned digits = self->question.digits;
    json_t *limit = json_object(), *vanish = json_array();
    for (unsigned i = 0; i < result->states; i++) {
        if (i == self->question.state) continue;
        if (result->vanishes[i]) json_array_append_new(vanish, json_string(d->states[i].name));
        else json_object_set_new(limit, d->states[i].name, jlt_shown_ball(result->limit + i, digits, self->replays));
    }
    return json_pack("{s:o,s:o,s:o,s:o,s:o,s:[o]}", "end", end_of(d, self->question.state, result->is_high), "vanish", vanish,
                     "limit", limit, "time", jlt_shown_ball(result->time, digits, self->replays), "conditions",
                     jlt_shown_conditions(result->least, d), "claims", json_sprintf("pole %s", pole->name));
}

const char *jlt_given_pole_problem(const jlt_pole_result *result)
{
    static const char *const reasons[] = {
        [JLT_POLE_OPEN] = "the motions are not shown to come to rest at a pole from the instant on (try smaller radii, more "
                          "digits, or other starts)",
        [JLT_POLE_OUTSIDE] = "the states of the box are not shown to lie in the domain of the table",
        [JLT_POLE_LEAVES] = "the motions are not shown to stay in the domain of the table (where they do, try smaller radii, or "
                            "more digits)",
        [JLT_POLE_EITHER] = "the motions come to rest, but are not shown to do so at one end of the pole's interval (try smaller "
                            "radii)",
    };

    return reasons[result->verdict];
}
