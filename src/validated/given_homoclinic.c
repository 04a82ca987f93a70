#include "validated/given_homoclinic.h"

#include "validated/numerals.h"
#include "validated/theorem.h"

/* Initialize all members but the legs. */
static void begin(jlt_given_homoclinic *self, const jlt_given *of, const jlt_reversor *reversor, int landing)
{
    *self = (jlt_given_homoclinic){ .frame = _arb_vec_init(4) };
    arb_init(self->reach);
    arb_init(self->slope);
    self->question = (jlt_homoclinic_question){
        .question = &of->question, .signs = reversor == NULL ? NULL : reversor->signs, .saddle_box = of->legs.box,
        .saddle_instant = of->legs.instants, .kept = of->kept, .frame = self->frame, .reach = self->reach, .slope = self->slope,
        .landing = landing,
    };
}

static void take_legs(jlt_given_homoclinic *self)
{
    self->question.legs = self->legs.count;
    self->question.box = self->legs.box;
    self->question.instants = self->legs.instants;
}

void jlt_given_homoclinic_clear(jlt_given_homoclinic *self)
{
    _arb_vec_clear(self->frame, 4);
    arb_clear(self->reach);
    arb_clear(self->slope);
    jlt_given_legs_clear(&self->legs, self->question.question);
}

static bool has_turns(const json_t *legs)
{
    for (size_t i = 0; i < json_array_size(legs); i++)
        if (json_object_get(json_array_get(legs, i), "turns") != NULL) return true;
    return false;
}

bool jlt_given_homoclinic_read(jlt_given_homoclinic *self, const jlt_given *of, const json_t *given,
                               char problem[JLT_GIVEN_PROBLEM_MAX])
{
    const json_t *part = json_object_get(given, "homoclinic"), *frame = json_object_get(part, "frame");
    const json_t *legs = json_object_get(part, "legs");
    const slong bits = jlt_step_accuracy_for(of->question.digits).bits;
    const json_int_t landing = json_integer_value(json_object_get(part, "landing"));
    const json_t *flipped = json_object_get(part, "reversor");
    const jlt_descriptor *d = of->question.descriptor;
    const jlt_reversor *reversor = flipped == NULL ? jlt_theorem_reversor(d) : jlt_theorem_reversor_of(d, flipped);
    bool good = true;

    begin(self, of, reversor, (int)landing);
    if (flipped != NULL && reversor == NULL)
        return jlt_refuse(problem, "homoclinic: no proved reversor of the table flips the states that are named");
    if (part == NULL || of->legs.count != 1) return jlt_refuse(problem, "homoclinic: it needs a saddle of one leg, and an orbit");
    if (of->kept_count != 2) return jlt_refuse(problem, "homoclinic: two coordinates on the levels are served");
    if (of->question.free_count > 0) return jlt_refuse(problem, "homoclinic: parameters are numbers, not intervals");
    if (landing != 1 && landing != -1) return jlt_refuse(problem, "homoclinic: landing is 1 or -1");
    for (unsigned i = 0; i < 4; i++)
        good = good
               && jlt_numerals_read(self->frame + i, json_string_value(json_array_get(json_array_get(frame, i / 2), i % 2)),
                                        bits);
    if (!good) return jlt_refuse(problem, "homoclinic: the frame is two rows of two numbers");
    good = jlt_numerals_read(self->reach, json_string_value(json_object_get(part, "reach")), bits)
           && jlt_numerals_read(self->slope, json_string_value(json_object_get(part, "slope")), bits)
           && arb_is_positive(self->reach) && arb_is_positive(self->slope);
    if (!good) return jlt_refuse(problem, "homoclinic: reach and slope are numbers > 0");
    if (has_turns(legs)) return jlt_refuse(problem, "homoclinic: its legs have no turns");
    good = jlt_given_legs_read(&self->legs, &of->question, legs, problem);
    take_legs(self);
    return good;
}

/* The value, rounded up to five digits. */
static json_t *upper(const arb_t value)
{
    char text[32];

    snprintf(text, sizeof text, "%.4e", 1.0001 * arf_get_d(arb_midref(value), ARF_RND_UP));
    return json_string(text);
}

/* The states that the reversor flips, if the table has other reversors too; else NULL. */
static json_t *name_of(const jlt_descriptor *d, const jlt_reversor *reversor)
{
    return d->reversor_count > 1 ? jlt_theorem_flipped(d, reversor) : NULL;
}

static json_t *write_given(const jlt_given_homoclinic *self, const jlt_reversor *reversor)
{
    const unsigned digits = self->question.question->digits;
    json_t *frame = json_array();

    for (unsigned i = 0; i < 2; i++)
        json_array_append_new(frame, json_pack("[o,o]", jlt_given_legs_decimal(self->frame + 2 * i, digits),
                                               jlt_given_legs_decimal(self->frame + 2 * i + 1, digits)));
    return json_pack("{s:o,s:o,s:o,s:i,s:o*,s:o}", "frame", frame, "reach", upper(self->reach), "slope", upper(self->slope),
                     "landing", self->question.landing, "reversor", name_of(self->question.question->descriptor, reversor),
                     "legs", jlt_given_legs_write(&self->legs, self->question.question, NULL));
}

jlt_status jlt_given_homoclinic_make(const jlt_given *of, json_t *given, const jlt_reversor *reversor, unsigned legs,
                                     const double *x, const double *T, int landing)
{
    JLT_CLEARED(jlt_given_homoclinic_clear) jlt_given_homoclinic self;
    JLT_OWNED(jlt_cycle) *cycle = NULL;

    begin(&self, of, reversor, landing);
    if (legs < 1 || legs > JLT_CYCLE_LEGS_MAX || of->legs.count != 1 || of->kept_count != 2 || of->question.free_count > 0)
        return JLT_ERR_ARG;
    jlt_given_legs_guess(&self.legs, &of->question, legs, x, T);
    take_legs(&self);
    JLT_PASS(jlt_cycle_create(&cycle, &of->question));
    JLT_PASS(jlt_homoclinic_make(cycle, &self.question));
    return json_object_set_new(given, "homoclinic", write_given(&self, reversor)) == 0 ? JLT_OK : JLT_ERR_NOMEM;
}
