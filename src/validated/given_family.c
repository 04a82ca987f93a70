#include "validated/given_family.h"

#include "kernel/descriptor.h"
#include "validated/numerals.h"
#include "validated/shown.h"

#include <flint/fmpq_vec.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- reading ---- */

static const ttc_claim *claim_of(const ttc_model *model, ttc_claim_kind kind, const char *name)
{
    for (size_t i = 0; i < model->claim_count; i++)
        if (model->claims[i].kind == kind && strcmp(model->claims[i].name, name) == 0) return &model->claims[i];
    return NULL;
}

static bool read_family(jlt_given_family *self, const char *name, char *problem)
{
    const jlt_claim *claim = name == NULL ? NULL : jlt_descriptor_claim(self->descriptor, "equilibria", name);

    if (claim != NULL) self->question.family = claim_of(self->model, TTC_CLAIM_EQUILIBRIA, name);
    if (name != NULL && jlt_descriptor_proves(self->descriptor, "trace", name))
        self->question.trace = claim_of(self->model, TTC_CLAIM_TRACE, name);
    if (self->question.family == NULL)
        return jlt_refuse(problem, "%s has no family of equilibria '%s'", self->descriptor->model, name == NULL ? "" : name);
    if (claim->verdict != JLT_PROVED) return jlt_refuse_claim(problem, claim);
    for (size_t i = 0; i < self->question.family->when.count; i++) self->is_given[self->question.family->when.items[i].symbol] = 1;
    for (size_t i = 0; i < self->question.family->bindings.count; i++)
        self->is_given[self->question.family->bindings.items[i].symbol] = 1;
    return true;
}

/* Whether the table allows the values from low to high: by a parameter's sign, or a state's interval where its ends are numbers. */
static bool allows(const jlt_given_family *self, const ttc_symbol_entry *symbol, const fmpq_t low, const fmpq_t high)
{
    const ttc_graph *graph = self->model->graph;

    const fmpq *least = ttc_number_value(graph, symbol->low), *most = ttc_number_value(graph, symbol->high);

    if (symbol->kind == TTC_STATE) return (least == NULL || fmpq_cmp(least, low) < 0) && (most == NULL || fmpq_cmp(high, most) < 0);
    switch (symbol->sign) {
    case TTC_POSITIVE: return fmpq_sgn(low) > 0;
    case TTC_NONNEGATIVE: return fmpq_sgn(low) >= 0;
    case TTC_NONZERO: return fmpq_sgn(low) * fmpq_sgn(high) > 0;
    default: return true;
    }
}

static bool read_side(jlt_given_family *self, uint32_t number, const json_t *box, char *problem)
{
    const ttc_symbol_entry *symbol = &self->model->symbols[number];
    const char *what = symbol->kind == TTC_STATE ? "state" : "parameter";
    const json_t *value = json_object_get(box, symbol->name);
    const bool is_range = json_is_object(value);
    fmpq *low = &self->low[self->question.dim], *high = &self->high[self->question.dim];

    if (self->is_given[number])
        return value == NULL || jlt_refuse(problem, "box: the family '%s' gives %s itself", self->question.family->name,
                                           symbol->name);
    if (value == NULL) return jlt_refuse(problem, "box: %s %s has no value: give one, or a range", what, symbol->name);
    if ((is_range && json_object_size(value) != 2)
        || !jlt_numerals_fraction(low, json_string_value(is_range ? json_object_get(value, "low") : value))
        || !jlt_numerals_fraction(high, json_string_value(is_range ? json_object_get(value, "high") : value)))
        return jlt_refuse(problem, "box: %s %s: no number", what, symbol->name);
    if (is_range && fmpq_cmp(low, high) >= 0)
        return jlt_refuse(problem, "box: the range of %s is empty: its low end must be below its high one; for one value, %s=VALUE",
                          symbol->name, symbol->name);
    if (!allows(self, symbol, low, high))
        return jlt_refuse(problem, "box: %s %s: %s does not allow all of these values", what, symbol->name,
                          self->descriptor->model);
    self->symbols[self->question.dim++] = number;
    return true;
}

static bool read_box(jlt_given_family *self, const json_t *box, char *problem)
{
    const ttc_model *m = self->model;
    const char *name;
    json_t *value;
    bool good = true;

    json_object_foreach((json_t *)(uintptr_t)box, name, value) {
        size_t index;
        if (!jlt_descriptor_param(self->descriptor, name, &index) && !jlt_descriptor_state(self->descriptor, name, &index))
            return jlt_refuse(problem, "box: %s has neither a parameter nor a state '%s'", self->descriptor->model, name);
    }
    for (size_t i = 0; good && i < m->param_count; i++) good = read_side(self, m->params[i], box, problem);
    for (size_t i = 0; good && i < m->state_count; i++) good = read_side(self, m->states[i], box, problem);
    return good;
}

bool jlt_given_family_read(jlt_given_family *self, const json_t *given, const jlt_descriptor *d,
                           char problem[JLT_GIVEN_PROBLEM_MAX])
{
    const json_int_t digits = json_integer_value(json_object_get(given, "digits"));
    const json_int_t limit = json_integer_value(json_object_get(given, "limit"));
    const slong count = (slong)d->param_count + (slong)d->state_count;

    *self = (jlt_given_family){ .descriptor = d };
    self->low = _fmpq_vec_init(count);
    self->high = _fmpq_vec_init(count);
    self->symbols = calloc((size_t)count, sizeof *self->symbols);
    self->model = ttc_model_again(d->table, d->model);
    if (self->model != NULL) self->is_given = calloc(self->model->symbol_count + 1, 1);
    if (self->is_given == NULL || self->symbols == NULL) return jlt_refuse(problem, "the table %s cannot be read", d->model);
    if (digits < 5 || digits > JLT_GIVEN_DIGITS_MAX) return jlt_refuse(problem, "digits: between 5 and %d", JLT_GIVEN_DIGITS_MAX);
    if (limit < 1 || limit > JLT_GIVEN_FAMILY_LIMIT_MAX)
        return jlt_refuse(problem, "limit: between 1 and %d", JLT_GIVEN_FAMILY_LIMIT_MAX);
    self->question.model = self->model;
    self->question.symbols = self->symbols;
    self->question.low = self->low;
    self->question.high = self->high;
    self->question.limit = (unsigned)limit;
    self->question.bits = 32 + 4 * (slong)digits;
    return read_family(self, json_string_value(json_object_get(given, "family")), problem)
           && read_box(self, json_object_get(given, "box"), problem);
}

void jlt_given_family_clear(jlt_given_family *self)
{
    const slong count = (slong)self->descriptor->param_count + (slong)self->descriptor->state_count;

    _fmpq_vec_clear(self->low, count);
    _fmpq_vec_clear(self->high, count);
    free(self->symbols);
    free(self->is_given);
    ttc_model_destroy(self->model);
}

/* ---- what was found ---- */

static const char *name_of(const jlt_given_family *self, unsigned i)
{
    return self->model->symbols[self->symbols[i]].name;
}

static json_t *point_of(const jlt_given_family *self, const fmpq *x)
{
    json_t *point = json_object();

    for (unsigned i = 0; i < self->question.dim; i++) {
        char *text = fmpq_get_str(NULL, 10, &x[i]);
        json_object_set_new(point, name_of(self, i), json_string(text));
        flint_free(text);
    }
    return point;
}

json_t *jlt_given_family_shown(const jlt_given_family *self, const jlt_family_result *result)
{
    const jlt_descriptor *d = self->descriptor;
    const char *name = self->question.family->name;
    json_t *claims = json_array();

    json_array_append_new(claims, json_sprintf("equilibria %s", name));
    if (self->question.trace != NULL) json_array_append_new(claims, json_sprintf("trace %s", name));
    return json_pack("{s:{s:o,s:o},s:o,s:i,s:o,s:o}", "trace", "low", jlt_shown_lower_bound(result->trace.low), "high",
                     jlt_shown_upper_bound(result->trace.high), "conditions", jlt_shown_conditions(result->least, d), "boxes",
                     (int)result->boxes, "point", point_of(self, result->point), "claims", claims);
}

static double number_of(const fmpq *x)
{
    JLT_SCOPED(arf, value);

    arf_fmpz_div_fmpz(value, fmpq_numref(x), fmpq_denref(x), 53, ARF_RND_NEAR);
    return arf_get_d(value, ARF_RND_NEAR);
}

/* Write a point, or if `to` is not NULL a box, by the coordinates with ranges in `given`; "its only point" if there is none. */
static void write_point(FILE *out, const jlt_given_family *self, const fmpq *from, const fmpq *to)
{
    const char *between = "";

    for (unsigned i = 0; i < self->question.dim; i++) {
        if (fmpq_equal(&self->low[i], &self->high[i])) continue;
        if (to == NULL) fprintf(out, "%s%s = %.12g", between, name_of(self, i), number_of(&from[i]));
        else fprintf(out, "%s%s in [%.12g, %.12g]", between, name_of(self, i), number_of(&from[i]), number_of(&to[i]));
        between = ", ";
    }
    if (between[0] == '\0') fputs("its only point", out);
}

void jlt_given_family_problem(char problem[JLT_GIVEN_PROBLEM_MAX], const jlt_given_family *self, const jlt_family_result *result)
{
    FILE *out = fmemopen(problem, JLT_GIVEN_PROBLEM_MAX - 1, "w"); /* fmemopen does not terminate a full buffer */

    problem[JLT_GIVEN_PROBLEM_MAX - 1] = '\0';
    if (out == NULL) return;
    switch (result->verdict) {
    case JLT_FAMILY_PROVED: break;
    case JLT_FAMILY_ZERO:
        fputs("the trace is 0 at ", out);
        write_point(out, self, result->point, NULL);
        break;
    case JLT_FAMILY_CHANGES:
        fputs("the trace changes its sign: it is > 0 at ", out);
        write_point(out, self, result->point, NULL);
        fputs(", < 0 at ", out);
        write_point(out, self, result->other, NULL);
        break;
    case JLT_FAMILY_OUTSIDE: fputs("no point of the box is shown to be in the table's domain", out); break;
    case JLT_FAMILY_LEFT:
        fprintf(out, "after %u boxes the trace has no sign that is shown in ", result->boxes);
        write_point(out, self, result->point, result->other);
        break;
    }
    fclose(out);
}
