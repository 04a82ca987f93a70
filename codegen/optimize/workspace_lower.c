#include "optimize/workspace_lower.h"

#include <stdlib.h>

typedef struct {
    const ttc_workspace *workspace;
    ttc_prepared *prepared;
    ttc_program *program;
    ttc_value *values; /* by variable */
    unsigned *ready;   /* by value */
    size_t ready_capacity;
    bool failed;
} lowering;

static ttc_value lower_variable(lowering *l, uint32_t variable);

/* Record when a value is ready; its operands must be recorded first. */
static ttc_value note(lowering *l, ttc_value value)
{
    if (value == TTC_NO_VALUE) {
        l->failed = true;
        return value;
    }
    if (value >= l->ready_capacity) {
        size_t capacity = 2 * (size_t)value + 64;
        unsigned *ready = realloc(l->ready, capacity * sizeof *ready);
        if (ready == NULL) {
            l->failed = true;
            return TTC_NO_VALUE;
        }
        for (size_t i = l->ready_capacity; i < capacity; i++) ready[i] = 0;
        l->ready = ready;
        l->ready_capacity = capacity;
    }
    const ttc_instruction *i = ttc_program_at(l->program, value);
    unsigned arity = ttc_op_arity(i->op), start = 0;
    for (unsigned k = 0; k < arity; k++)
        if (i->operands[k] < l->ready_capacity && l->ready[i->operands[k]] > start) start = l->ready[i->operands[k]];
    if (arity > 0) l->ready[value] = start + ttc_op_latency(i->op);
    return value;
}

static ttc_value apply(lowering *l, ttc_op op, ttc_value a, ttc_value b)
{
    if (l->failed) return TTC_NO_VALUE;
    return note(l, ttc_program_apply(l->program, op, a, b, TTC_NO_VALUE));
}

static ttc_value lower_scale(lowering *l, ttc_id scale)
{
    const ttc_graph *graph = l->workspace->field->graph;
    if (ttc_kind_of(graph, scale) == TTC_NUMBER)
        return note(l, ttc_program_constant(l->program, ttc_coefficient(graph, scale)));
    return note(l, ttc_program_parameter(l->program, ttc_prepared_index(l->prepared, scale)));
}

/* Multiply always the two values that are ready first. */
static ttc_value lower_cube(lowering *l, const ttc_cube *cube, ttc_id scale)
{
    ttc_value values[TTC_CUBE_LIMIT + 1];
    unsigned count = 0;
    if (scale != l->workspace->one || cube->count == 0) values[count++] = lower_scale(l, scale);
    for (unsigned i = 0; i < cube->count; i++) values[count++] = lower_variable(l, cube->factors[i]);
    while (count > 1 && !l->failed) {
        unsigned first = 0, second = 1;
        for (unsigned i = 1; i < count; i++)
            if (l->ready[values[i]] < l->ready[values[first]]) first = i;
        second = first == 0 ? 1 : 0;
        for (unsigned i = 0; i < count; i++)
            if (i != first && l->ready[values[i]] < l->ready[values[second]]) second = i;
        values[first] = apply(l, TTC_OP_MULTIPLY, values[first], values[second]);
        values[second] = values[--count];
    }
    return l->failed ? TTC_NO_VALUE : values[0];
}

typedef struct {
    ttc_value value;
    int sign;
    bool is_product; /* can be fused with an addition, unless the sum starts with it */
} term;

/* Sort terms by when they are ready, but start, if possible, with a positive one that is no product. */
static void order_terms(const lowering *l, term *terms, size_t count)
{
    for (size_t i = 1; i < count; i++)
        for (size_t j = i; j > 0 && l->ready[terms[j].value] < l->ready[terms[j - 1].value]; j--) {
            term swap = terms[j];
            terms[j] = terms[j - 1];
            terms[j - 1] = swap;
        }
    size_t first = count;
    for (size_t i = 0; i < count && first == count; i++)
        if (terms[i].sign > 0 && !terms[i].is_product) first = i;
    for (size_t i = 0; i < count && first == count; i++)
        if (!terms[i].is_product) first = i;
    for (size_t i = 0; i < count && first == count; i++)
        if (terms[i].sign > 0) first = i;
    if (first == count) return;
    term chosen = terms[first];
    for (size_t i = first; i > 0; i--) terms[i] = terms[i - 1];
    terms[0] = chosen;
}

static ttc_value add_terms(lowering *l, const term *terms, size_t count)
{
    ttc_value sum = terms[0].value;
    int sign = terms[0].sign;
    for (size_t i = 1; i < count; i++) {
        if (terms[i].sign == sign) {
            sum = apply(l, TTC_OP_ADD, sum, terms[i].value);
        } else if (sign > 0) {
            sum = apply(l, TTC_OP_SUBTRACT, sum, terms[i].value);
        } else {
            sum = apply(l, TTC_OP_SUBTRACT, terms[i].value, sum);
            sign = 1;
        }
    }
    return sign > 0 ? sum : apply(l, TTC_OP_NEGATE, sum, TTC_NO_VALUE);
}

/* Whether all terms are negative and have scales, which can take the sign. */
static bool scales_take_sign(const lowering *l, const ttc_polynomial *p)
{
    for (uint32_t i = 0; i < p->count; i++)
        if (p->cubes[i].sign > 0 || p->cubes[i].scale == l->workspace->one) return false;
    return true;
}

static ttc_value lower_polynomial(lowering *l, const ttc_polynomial *p)
{
    ttc_graph *graph = l->workspace->field->graph;
    if (p->count == 0) return note(l, ttc_program_integer(l->program, 0));
    term *terms = calloc(p->count, sizeof *terms);
    l->failed |= terms == NULL;
    bool negate_scales = scales_take_sign(l, p);
    for (uint32_t i = 0; i < p->count && !l->failed; i++) {
        const ttc_cube *cube = p->cubes + i;
        ttc_id scale = negate_scales ? ttc_multiply(graph, cube->scale, ttc_integer(graph, -1)) : cube->scale;
        l->failed |= scale == TTC_NONE;
        if (l->failed) break;
        terms[i].sign = negate_scales ? 1 : cube->sign;
        terms[i].is_product = ttc_cube_cost(l->workspace, cube) > 0;
        terms[i].value = lower_cube(l, cube, scale);
    }
    ttc_value value = TTC_NO_VALUE;
    if (!l->failed) {
        order_terms(l, terms, p->count);
        value = add_terms(l, terms, p->count);
    }
    free(terms);
    return value;
}

static void label(lowering *l, uint32_t variable, ttc_value value)
{
    ttc_text text = { 0 };
    ttc_workspace_write_name(l->workspace, &text, variable);
    l->failed |= text.failed;
    if (!l->failed && text.length > 0) ttc_program_label(l->program, value, ttc_text_string(&text));
    ttc_text_clear(&text);
}

static ttc_value lower_variable(lowering *l, uint32_t variable)
{
    const ttc_variable *v = l->workspace->variables + variable;
    if (l->failed) return TTC_NO_VALUE;
    if (l->values[variable] != TTC_NO_VALUE) return l->values[variable];
    ttc_value value = TTC_NO_VALUE, operand = TTC_NO_VALUE;
    if (v->kind > TTC_VARIABLE_UNIT) {
        operand = lower_variable(l, v->operand);
        if (l->failed) return TTC_NO_VALUE;
    }
    switch (v->kind) {
    case TTC_VARIABLE_INPUT: value = note(l, ttc_program_input(l->program, v->operand)); break;
    case TTC_VARIABLE_UNIT: value = lower_polynomial(l, &v->definition); break;
    case TTC_VARIABLE_RECIPROCAL: value = apply(l, TTC_OP_DIVIDE, note(l, ttc_program_integer(l->program, 1)), operand); break;
    case TTC_VARIABLE_ROOT: value = apply(l, TTC_OP_ROOT, operand, TTC_NO_VALUE); break;
    case TTC_VARIABLE_COSINE: value = apply(l, TTC_OP_COSINE, operand, TTC_NO_VALUE); break;
    case TTC_VARIABLE_SINE: value = apply(l, TTC_OP_SINE, operand, TTC_NO_VALUE); break;
    case TTC_VARIABLE_EXP: value = apply(l, TTC_OP_EXP, operand, TTC_NO_VALUE); break;
    case TTC_VARIABLE_LOG: value = apply(l, TTC_OP_LOG, operand, TTC_NO_VALUE); break;
    }
    if (!l->failed) label(l, variable, value);
    l->values[variable] = value;
    return value;
}

ttc_program *ttc_workspace_lower(const ttc_workspace *workspace, ttc_prepared *prepared)
{
    lowering l = { .workspace = workspace, .prepared = prepared, .program = ttc_program_create() };
    l.values = malloc((workspace->count + 1) * sizeof *l.values);
    l.failed = l.program == NULL || l.values == NULL;
    for (uint32_t i = 0; i < workspace->count && !l.failed; i++) l.values[i] = TTC_NO_VALUE;
    for (uint32_t i = 0; i < workspace->output_count && !l.failed; i++) {
        ttc_value value = lower_variable(&l, workspace->outputs[i]);
        if (!l.failed) ttc_program_output(l.program, value);
    }
    ttc_program *trimmed = l.failed || prepared->failed || ttc_program_failed(l.program) ? NULL : ttc_program_trim(l.program);
    ttc_program_destroy(l.program);
    free(l.values);
    free(l.ready);
    return trimmed;
}
