/* Evaluates the compiler's programs for small tables in rational numbers, and compares them with the terms as written. Include it
 * after cmocka.h. */
#ifndef TEST_EXACT_PROGRAM_H
#define TEST_EXACT_PROGRAM_H

#include "base/diagnostic.h"
#include "fields/prepared.h"
#include "fields/field.h"
#include "optimize/lower.h"
#include "optimize/workspace.h"
#include "optimize/workspace_lower.h"
#include "read/model.h"

#include <stdlib.h>
#include "unit/check.h"

enum { POINTS = 4, STATES_MAX = 8, PARAMS_MAX = 8, OUTPUTS_MAX = 80 };

typedef struct {
    ttc_model *model;
    ttc_field *field;
    ttc_id outputs[OUTPUTS_MAX]; /* (count,): the field, then its Jacobian */
    size_t count;
} subject;

static inline subject read_table(const char *table)
{
    subject s = { 0 };
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    s.model = ttc_model_parse(table, strlen(table), "test.tt", diagnostics);
    ttc_diagnostics_print(diagnostics, stderr);
    ttc_diagnostics_destroy(diagnostics);
    assert_non_null(s.model);
    assert_int_equal(ttc_field_create(&s.field, s.model, NULL, NULL, NULL), TTC_FIELD_OK);
    size_t n = s.field->state_count;
    for (size_t i = 0; i < n; i++) s.outputs[s.count++] = s.field->rhs[i];
    for (size_t i = 0; i < n * n; i++) s.outputs[s.count++] = ttc_field_partial(s.field, s.field->rhs[i / n], i % n);
    return s;
}

static inline void forget(subject *s)
{
    ttc_field_destroy(s->field);
    ttc_model_destroy(s->model);
}

static inline void apply(fmpq_t out, const ttc_instruction *i, fmpq *values)
{
    const fmpq *a = i->a == TTC_NO_VALUE ? NULL : values + i->a, *b = i->b == TTC_NO_VALUE ? NULL : values + i->b;
    const fmpq *c = i->c == TTC_NO_VALUE ? NULL : values + i->c;
    switch (i->op) {
    case TTC_OP_CONSTANT: fmpq_set(out, i->constant); break;
    case TTC_OP_NEGATE: fmpq_neg(out, a); break;
    case TTC_OP_ADD: fmpq_add(out, a, b); break;
    case TTC_OP_SUBTRACT: fmpq_sub(out, a, b); break;
    case TTC_OP_MULTIPLY: fmpq_mul(out, a, b); break;
    case TTC_OP_DIVIDE:
        assert_false(fmpq_is_zero(b));
        fmpq_div(out, a, b);
        break;
    case TTC_OP_FMA:
        fmpq_mul(out, a, b);
        fmpq_add(out, out, c);
        break;
    case TTC_OP_FMS:
        fmpq_mul(out, a, b);
        fmpq_sub(out, out, c);
        break;
    case TTC_OP_FNMA:
        fmpq_mul(out, a, b);
        fmpq_sub(out, c, out);
        break;
    case TTC_OP_ROOT:
        assert_true(fmpz_is_square(fmpq_numref(a)) && fmpz_is_square(fmpq_denref(a)));
        fmpz_sqrt(fmpq_numref(out), fmpq_numref(a));
        fmpz_sqrt(fmpq_denref(out), fmpq_denref(a));
        break;
    default: fail_msg("no such operation in these tables");
    }
}

/* Compute the outputs, shape (output count,), of a program at a point. */
static inline void evaluate(fmpq *outputs, const ttc_program *program, const fmpq *states, const fmpq *params)
{
    size_t n = ttc_program_size(program);
    fmpq *values = calloc(n + 1, sizeof *values);
    assert_non_null(values);
    for (size_t k = 0; k < n; k++) {
        const ttc_instruction *i = ttc_program_at(program, (ttc_value)k);
        fmpq_init(values + k);
        if (i->op == TTC_OP_INPUT) fmpq_set(values + k, states + i->index);
        else if (i->op == TTC_OP_PARAMETER) fmpq_set(values + k, params + i->index);
        else apply(values + k, i, values);
    }
    for (size_t k = 0; k < ttc_program_output_count(program); k++)
        fmpq_set(outputs + k, values + ttc_program_output_at(program, k));
    for (size_t k = 0; k < n; k++) fmpq_clear(values + k);
    free(values);
}

static inline fmpq *numbers(size_t count)
{
    fmpq *list = calloc(count + 1, sizeof *list);
    assert_non_null(list);
    for (size_t i = 0; i < count; i++) fmpq_init(list + i);
    return list;
}

static inline void release(fmpq *list, size_t count)
{
    for (size_t i = 0; i < count; i++) fmpq_clear(list + i);
    free(list);
}

/* Choose a point whose first two states are legs of a right triangle, so that their distance from the origin is rational. */
static inline void choose_point(fmpq *states, fmpq *params, unsigned number)
{
    static const slong legs[POINTS][2] = { { 3, 4 }, { -5, 12 }, { 8, -15 }, { 20, 21 } };
    for (unsigned i = 0; i < STATES_MAX; i++)
        fmpq_set_si(states + i, i < 2 ? legs[number][i] : (slong)(i * i + 1 + number), i < 2 ? 7 : 2 * i + 1);
    for (unsigned i = 0; i < PARAMS_MAX; i++) fmpq_set_si(params + i, (slong)(3 * i + 2 + number), 5);
}

/* Check that a program on prepared values gives the same values as the terms as written. */
static inline void same_values(subject *s, const ttc_program *program, const ttc_prepared *prepared)
{
    ttc_program *naive = ttc_lower(s->field, s->outputs, s->count, (ttc_lowering){ 0 });
    ttc_program *prepare = ttc_lower(s->field, prepared->entries, prepared->count, (ttc_lowering){ .share = true });
    fmpq *states = numbers(STATES_MAX), *params = numbers(PARAMS_MAX + prepared->count);
    fmpq *expected = numbers(s->count), *found = numbers(s->count), *entries = numbers(prepared->count);
    assert_true(naive != NULL && prepare != NULL && s->field->param_count <= PARAMS_MAX);
    for (unsigned k = 0; k < POINTS; k++) {
        choose_point(states, params, k);
        evaluate(expected, naive, states, params);
        evaluate(entries, prepare, states, params);
        for (size_t i = 0; i < prepared->count; i++) fmpq_set(params + s->field->param_count + i, entries + i);
        evaluate(found, program, states, params);
        for (size_t i = 0; i < s->count; i++) assert_true(fmpq_equal(expected + i, found + i));
    }
    release(states, STATES_MAX);
    release(params, PARAMS_MAX + prepared->count);
    release(expected, s->count);
    release(found, s->count);
    release(entries, prepared->count);
    ttc_program_destroy(naive);
    ttc_program_destroy(prepare);
}

/* Check that a workspace computes the values of the terms. Returns its operation count. */
static inline ttc_count check(subject *s, const ttc_workspace *workspace)
{
    ttc_prepared prepared = { .field = s->field };
    assert_false(workspace->failed);
    ttc_program *program = ttc_workspace_lower(workspace, &prepared);
    assert_non_null(program);
    same_values(s, program, &prepared);
    ttc_count count = ttc_program_count(program);
    ttc_program_destroy(program);
    ttc_prepared_clear(&prepared);
    return count;
}

static inline unsigned operations(ttc_count c) { return c.add + c.multiply + c.divide + c.root; }

#endif
