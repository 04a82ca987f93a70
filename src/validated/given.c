#include "validated/given.h"

#include "kernel/descriptor.h"
#include "validated/given_turns.h"
#include "validated/numerals.h"

#include <math.h>
#include <string.h>

const jlt_descriptor *jlt_given_table(const json_t *given, const jlt_descriptor *own, char problem[JLT_GIVEN_PROBLEM_MAX])
{
    const json_t *table = json_object_get(given, "table");
    const char *name = json_string_value(json_object_get(table, "name"));
    const char *digest = json_string_value(json_object_get(table, "sha256"));

    if (name == NULL || digest == NULL) {
        jlt_refuse(problem, "it names no table by name and sha256");
        return NULL;
    }
    /* `own` is meant if it has the name, even if a built-in table has it too: it may be an edited copy of that */
    const size_t count = own != NULL && strcmp(own->model, name) == 0 ? 0 : jlt_descriptor_count();
    for (size_t i = 0; i <= count; i++) {
        const jlt_descriptor *d = i == 0 ? own : jlt_descriptor_at(i - 1);
        if (d != NULL && d->variant[0] == '\0' && d->time[0] == '\0' && d->elimination[0] == '\0' && strcmp(d->model, name) == 0
            && strcmp(d->sha256, digest) == 0)
            return d;
    }
    unsigned way = 0;
    while (own != NULL && way < own->way_count && strcmp(own->ways[way].sha256, digest) != 0) way++;
    if (own == NULL) jlt_refuse(problem, "no table %s with SHA-256 %s is known here (name its file by --model)", name, digest);
    else if (way < own->way_count)
        jlt_refuse(problem, "it speaks of %s, to which %s leads: name %s by --model", name, own->model, own->ways[way].file);
    else
        jlt_refuse(problem, "it speaks of %s with SHA-256 %s, and --model names %s with %s (%s)", name, digest, own->model,
                   own->sha256, strcmp(own->model, name) == 0 ? "another version of that table"
                                                                   : "name the file of the table that it speaks of");
    return NULL;
}

bool jlt_given_read_value(arb_t out, const json_t *value, slong bits)
{
    return json_is_object(value) ? jlt_numerals_ball(out, value, bits) : jlt_numerals_read(out, json_string_value(value), bits);
}

static bool allows(const jlt_quantity *param, const arb_t value)
{
    return param->sign == JLT_ANY_SIGN || (param->sign == JLT_POSITIVE && arb_is_positive(value))
           || (param->sign == JLT_NONNEGATIVE && arb_is_nonnegative(value))
           || (param->sign == JLT_NONZERO && arb_is_nonzero(value));
}

bool jlt_given_read_params(arb_ptr params, const json_t *given, const jlt_descriptor *d, slong bits,
                           char problem[JLT_GIVEN_PROBLEM_MAX])
{
    const json_t *values = json_object_get(given, "parameters");

    if (!json_is_object(values) || json_object_size(values) != d->param_count)
        return jlt_refuse(problem, "it must give all %u parameters of %s", d->param_count, d->model);
    for (unsigned i = 0; i < d->param_count; i++) {
        if (!jlt_given_read_value(params + i, json_object_get(values, d->params[i].name), bits))
            return jlt_refuse(problem, "parameter %s: no number", d->params[i].name);
        if (!allows(&d->params[i], params + i))
            return jlt_refuse(problem, "parameter %s: the table does not allow this value", d->params[i].name);
    }
    return true;
}

/* Read the parameters; those that are intervals become free. */
static bool read_params(jlt_given *self, const json_t *given, slong bits, char *problem)
{
    const jlt_descriptor *d = self->question.descriptor;

    if (!jlt_given_read_params(self->params, given, d, bits, problem)) return false;
    for (unsigned i = 0; i < d->param_count; i++) {
        if (!json_is_object(json_object_get(json_object_get(given, "parameters"), d->params[i].name))) continue;
        if (self->question.free_count == JLT_FORMULAS_FREE_MAX)
            return jlt_refuse(problem, "more than %d parameters are intervals", JLT_FORMULAS_FREE_MAX);
        self->question.free[self->question.free_count++] = i;
    }
    return true;
}

static bool read_section(jlt_given *self, const json_t *given, slong bits, char *problem)
{
    const jlt_descriptor *d = self->question.descriptor;
    const json_t *section = json_object_get(given, "section");
    const char *state = json_string_value(json_object_get(section, "state"));
    const json_int_t direction = json_integer_value(json_object_get(section, "direction"));
    size_t column;

    if (state == NULL || !jlt_descriptor_state(d, state, &column)) return jlt_refuse(problem, "section: no such state");
    self->question.column = (unsigned)column;
    if (direction != 1 && direction != -1) return jlt_refuse(problem, "section: the direction is 1 or -1");
    self->question.direction = (int)direction;
    return jlt_numerals_read(self->section, json_string_value(json_object_get(section, "value")), bits)
           || jlt_refuse(problem, "section: no value");
}

/* Read levels of integrals that are proved for all parameters. */
static bool read_levels(jlt_given *self, const json_t *given, slong bits, char *problem)
{
    const jlt_descriptor *d = self->question.descriptor;
    const json_t *levels = json_object_get(given, "levels");
    const char *name;
    json_t *value;

    if (!json_is_object(levels)) return jlt_refuse(problem, "levels: no object of integrals with their values");
    if (json_object_size(levels) > JLT_FORMULAS_LEVELS_MAX)
        return jlt_refuse(problem, "levels: more than %d", JLT_FORMULAS_LEVELS_MAX);
    json_object_foreach((json_t *)(uintptr_t)levels, name, value) {
        const jlt_claim *claim = jlt_descriptor_claim(d, "integral", name);
        if (claim == NULL || claim->verdict != JLT_PROVED || !jlt_descriptor_lists(d, name))
            return jlt_refuse(problem, "levels: %s is no integral of %s that is proved without a condition%s%s%s", name, d->model,
                              claim != NULL && claim->condition[0] != '\0' ? ": write a table in which it is one, with " : "",
                              claim != NULL ? claim->condition : "",
                              claim != NULL && claim->condition[0] != '\0' ? " put into its equations" : "");
        arb_ptr out = self->level_values + self->question.level_count;
        if (!jlt_given_read_value(out, value, bits))
            return jlt_refuse(problem, "levels: %s has no value", name);
        self->levels[self->question.level_count++] = claim->name;
    }
    return true;
}

static bool read_coordinates(jlt_given *self, const json_t *given, char *problem)
{
    const jlt_descriptor *d = self->question.descriptor;
    const json_t *names = json_object_get(given, "coordinates");

    self->kept_count = d->state_count - 1 - self->question.level_count;
    if (json_array_size(names) != self->kept_count) return jlt_refuse(problem, "coordinates: %u on these levels", self->kept_count);
    for (unsigned i = 0; i < self->kept_count; i++) {
        const char *name = json_string_value(json_array_get(names, i));
        size_t state;
        if (name == NULL || !jlt_descriptor_state(d, name, &state) || state == self->question.column
            || (i > 0 && (unsigned)state <= self->kept[i - 1]))
            return jlt_refuse(problem, "coordinates: states but the section's, in the order of the table");
        self->kept[i] = (unsigned)state;
    }
    return true;
}

bool jlt_given_read(jlt_given *self, const json_t *given, const jlt_descriptor *descriptor, jlt_step_watch *watch,
                    char problem[JLT_GIVEN_PROBLEM_MAX])
{
    const json_int_t digits = json_integer_value(json_object_get(given, "digits"));

    *self = (jlt_given){ .question = { .descriptor = descriptor, .watch = watch } };
    self->params = _arb_vec_init(descriptor->param_count + 1);
    self->level_values = _arb_vec_init(JLT_FORMULAS_LEVELS_MAX);
    arb_init(self->section);
    self->question.params = self->params;
    self->question.section = self->section;
    self->question.levels = self->levels;
    self->question.level_values = self->level_values;
    if (digits < 5 || digits > JLT_GIVEN_DIGITS_MAX) return jlt_refuse(problem, "digits: between 5 and %d", JLT_GIVEN_DIGITS_MAX);
    if (descriptor->state_count > JLT_CYCLE_STATES_MAX || descriptor->state_count < 2)
        return jlt_refuse(problem, "tables of 2 to %d states are served", JLT_CYCLE_STATES_MAX);
    self->question.digits = (unsigned)digits;
    const slong bits = jlt_step_accuracy_for(self->question.digits).bits;
    return read_params(self, given, bits, problem) && read_section(self, given, bits, problem)
           && read_levels(self, given, bits, problem)
           && (descriptor->state_count >= 2 + self->question.level_count
               || jlt_refuse(problem, "levels: too many for %u states", descriptor->state_count));
}

bool jlt_given_read_legs(jlt_given *self, const json_t *given, char problem[JLT_GIVEN_PROBLEM_MAX])
{
    if (!read_coordinates(self, given, problem)
        || !jlt_given_legs_read(&self->legs, &self->question, json_object_get(given, "legs"), problem)) return false;
    self->question.turns = self->legs.grown;
    return true;
}

/* Set radii of boxes to 1.5 times the first-order spread of orbits, to allow for higher orders, but at least 5 % of the widest.
 * The boxes of all legs have equal radii, so if an orbit is its own mirror image, the boxes are mapped to each other too. */
static jlt_status widen(jlt_given *self, unsigned legs)
{
    const slong width = (slong)self->question.descriptor->state_count - 1, n = width * (slong)legs;
    const double room = 1.5, least = 0.05;
    double reaches[JLT_CYCLE_STATES_MAX] = { 0 }, widest = 0.0;
    JLT_SCOPED_VECTOR(arb, reach, n);
    JLT_OWNED(jlt_cycle) *cycle = NULL;

    JLT_PASS(jlt_cycle_create(&cycle, &self->question));
    JLT_PASS(jlt_cycle_reach(cycle, reach, self->legs.box, self->legs.instants, legs, self->kept));
    for (slong i = 0; i < n; i++) {
        reaches[i % width] = fmax(reaches[i % width], arf_get_d(arb_midref(reach + i), ARF_RND_UP));
        widest = fmax(widest, reaches[i % width]);
    }
    for (slong i = 0; i < n; i++) mag_set_d(arb_radref(self->legs.box + i), room * fmax(reaches[i % width], least * widest));
    return JLT_OK;
}

/* Whether parameters or levels are written as intervals. Numbers that are no binary fractions are balls too, but do not count. */
static bool has_intervals(const jlt_given *self, json_t *given)
{
    bool has = self->question.free_count > 0;
    const char *name;
    json_t *level;

    json_object_foreach(json_object_get(given, "levels"), name, level) has = has || json_is_object(level);
    return has;
}

/* The largest |x| of state i at the points x, shape (legs, states), in units of 2^unit. */
static double size_of(const double *x, unsigned legs, unsigned states, unsigned i, int unit)
{
    double size = 0;

    for (unsigned k = 0; k < legs; k++) size = fmax(size, fabs(ldexp(x[k * states + i], -unit)));
    return size;
}

/* Radii of boxes around the points x: 1e-10 of the units, of a state above 64 of its size, and of the largest where all are below
 * 1/64: as the motion's errors are. */
static void set_radii(double *radii, const double *x, unsigned legs, unsigned states, const int *units)
{
    static const double ordinary = 64;
    double largest = 0;

    for (unsigned i = 0; i < states; i++) largest = fmax(largest, size_of(x, legs, states, i, units[i]));
    for (unsigned i = 0; i < states; i++) {
        const double size = size_of(x, legs, states, i, units[i]);
        radii[i] = ldexp(1e-10 * (size > ordinary ? size : largest > 0 && largest < 1 / ordinary ? largest : 1), units[i]);
    }
}

jlt_status jlt_given_make_legs(jlt_given *self, json_t *given, unsigned legs, const double *x, const double *T,
                               const int *turns, double radius, const int *units, char problem[JLT_GIVEN_PROBLEM_MAX])
{
    const jlt_descriptor *d = self->question.descriptor;
    json_t *names = json_array();
    jlt_cycle_question middle; /* the question with parameters and levels at their midpoints */
    JLT_SCOPED_VECTOR(arb, params, d->param_count + 1);
    JLT_SCOPED_VECTOR(arb, levels, JLT_FORMULAS_LEVELS_MAX);
    jlt_cycle *cycle = NULL;
    const bool spreads = !(radius > 0) && has_intervals(self, given);
    double radii[JLT_CYCLE_STATES_MAX];
    jlt_status st = JLT_ERR_ARG;

    if (legs < 1 || legs > JLT_CYCLE_LEGS_MAX) goto done;
    jlt_given_legs_guess(&self->legs, &self->question, legs, x, T);
    st = JLT_ERR_UNSUPPORTED;
    if (!jlt_given_turns_set(&self->legs, &self->question, turns, problem)) goto done;
    self->question.turns = self->legs.grown;
    middle = self->question;
    self->kept_count = d->state_count - 1 - self->question.level_count;
    for (unsigned i = 0; i < d->param_count; i++) arb_get_mid_arb(params + i, self->params + i);
    for (unsigned i = 0; i < self->question.level_count; i++) arb_get_mid_arb(levels + i, self->level_values + i);
    middle.params = params;
    middle.level_values = levels;
    middle.free_count = 0;
    JLT_TRY(jlt_cycle_create(&cycle, &middle));
    JLT_TRY(jlt_cycle_choose(cycle, self->kept, self->legs.box));
    JLT_TRY(jlt_cycle_refine(cycle, self->legs.box, self->legs.instants, legs, self->kept));
    for (unsigned i = 0; i < self->kept_count; i++) json_array_append_new(names, json_string(d->states[self->kept[i]].name));
    set_radii(radii, x, legs, d->state_count, units);
    for (unsigned i = 0; radius > 0 && i < d->state_count; i++) radii[i] = radius;
    if (spreads) JLT_TRY(widen(self, legs));
    else for (unsigned i = 0, k = 0; i < legs * d->state_count; i++)
        if (i % d->state_count != self->question.column) mag_set_d(arb_radref(self->legs.box + k++), radii[i % d->state_count]);
    st = json_object_set(given, "coordinates", names) == 0
                 && json_object_set_new(given, "legs", jlt_given_legs_write(&self->legs, &self->question, spreads ? NULL : radii))
                        == 0
             ? JLT_OK
             : JLT_ERR_NOMEM;
done:
    jlt_cycle_destroy(cycle);
    json_decref(names);
    return st;
}

void jlt_given_clear(jlt_given *self)
{
    const jlt_descriptor *d = self->question.descriptor;

    _arb_vec_clear(self->params, d->param_count + 1);
    _arb_vec_clear(self->level_values, JLT_FORMULAS_LEVELS_MAX);
    arb_clear(self->section);
    jlt_given_legs_clear(&self->legs, &self->question);
}
