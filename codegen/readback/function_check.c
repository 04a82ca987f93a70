#include "readback/function_check.h"

#include "prove/prove_task.h"
#include "readback/function_read.h"
#include "readback/program_read.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

static ttc_ratio *make_ratios(ttc_ring *ring, size_t count)
{
    ttc_ratio *out = malloc((count + 1) * sizeof *out);
    for (size_t i = 0; out != NULL && i < count; i++) ttc_ratio_init(ring, &out[i]);
    return out;
}

static void free_ratios(ttc_ring *ring, ttc_ratio *ratios, size_t count)
{
    for (size_t i = 0; ratios != NULL && i < count; i++) ttc_ratio_clear(ring, &ratios[i]);
    free(ratios);
}

bool ttc_function_reading_open(ttc_function_reading *out, const ttc_model *model, const uint32_t *inputs, size_t input_count,
                               const uint32_t *parameters, size_t parameter_count, bool lifted_free,
                               const ttc_function_bound *bound)
{
    ttc_function_reading r = { .model = model, .valuation = ttc_valuation_create(model, 0) };
    *out = r;
    if (r.valuation == NULL) return false;
    r.ring = ttc_valuation_ring(r.valuation);
    for (size_t k = 0; bound != NULL && k < bound->count; k++)
        for (size_t i = 0; i < bound->lists[k]->count; i++)
            ttc_valuation_bind(r.valuation, bound->lists[k]->items[i].symbol, bound->lists[k]->items[i].expression);
    for (size_t i = model->state_count; lifted_free && i < input_count; i++) ttc_valuation_free(r.valuation, inputs[i]);
    r.inputs = make_ratios(r.ring, r.input_count = input_count);
    r.parameters = make_ratios(r.ring, r.parameter_count = parameter_count);
    r.input_is_given = calloc(input_count + 1, 1);
    r.is_given = calloc(parameter_count + 1, 1);
    *out = r;
    if (r.inputs == NULL || r.parameters == NULL || r.is_given == NULL || r.input_is_given == NULL) return false;
    for (size_t i = 0; i < input_count; i++) r.input_is_given[i] = !ttc_valuation_is_bound(r.valuation, inputs[i]);
    for (size_t i = 0; i < input_count; i++) ttc_evaluate(r.valuation, &r.inputs[i], model->symbols[inputs[i]].node);
    for (size_t i = 0; i < parameter_count; i++) {
        r.is_given[i] = parameters[i] != UINT32_MAX && !ttc_valuation_is_bound(r.valuation, parameters[i]);
        if (r.is_given[i]) ttc_evaluate(r.valuation, &r.parameters[i], model->symbols[parameters[i]].node);
    }
    return true;
}

void ttc_function_reading_close(ttc_function_reading *r)
{
    if (r->valuation == NULL) return;
    free_ratios(r->ring, r->inputs, r->input_count);
    free_ratios(r->ring, r->parameters, r->parameter_count);
    free(r->input_is_given);
    free(r->is_given);
    ttc_valuation_destroy(r->valuation);
    *r = (ttc_function_reading){ 0 };
}

TTC_PRINTF(3, 4) static void settle_as(ttc_proof *proof, ttc_proof_status status, const char *format, ...)
{
    enum { REMAINDER_LIMIT = 4400 };
    va_list arguments;
    if (proof->status != TTC_PROVED) return;
    proof->status = status;
    proof->remainder = malloc(REMAINDER_LIMIT);
    if (proof->remainder == NULL) return;
    va_start(arguments, format);
    vsnprintf(proof->remainder, REMAINDER_LIMIT, format, arguments);
    va_end(arguments);
}

/* Set slopes to the derivatives of the ring's variables by the symbol. All functions of the model are evaluated first, so that each
 * has its variable. Returns false if the symbol has no variable. */
static bool find_slopes(ttc_function_reading *r, ttc_ratio *slopes, uint32_t symbol)
{
    const slong variable = ttc_valuation_variable(r->valuation, symbol);
    ttc_ratio met;
    ttc_ratio_init(r->ring, &met);
    for (size_t i = 0; i < r->model->symbol_count; i++) {
        const ttc_symbol_kind kind = r->model->symbols[i].kind;
        if (kind == TTC_COSINE || kind == TTC_EXP || kind == TTC_LOG) ttc_evaluate(r->valuation, &met, r->model->symbols[i].node);
    }
    ttc_ratio_clear(r->ring, &met);
    for (size_t v = 0; v < r->ring->variable_count; v++) ttc_ratio_set_integer(r->ring, &slopes[v], 0);
    if (variable < 0) return false;
    ttc_ratio_set_integer(r->ring, &slopes[variable], 1);
    ttc_valuation_add_function_rates(r->valuation, slopes);
    return true;
}

/* The expected output as a ratio. Returns false when memory is out, or if the symbol to differentiate by has no variable. */
static bool find_expected(ttc_function_reading *r, ttc_ratio *out, const ttc_function_output *expected)
{
    ttc_evaluate(r->valuation, out, expected->value);
    if (expected->by == UINT32_MAX) return true;
    ttc_ratio *slopes = make_ratios(r->ring, r->ring->variable_count), value;
    const size_t count = r->ring->variable_count;
    bool ok = slopes != NULL && find_slopes(r, slopes, expected->by);
    ttc_ratio_init(r->ring, &value);
    ttc_ratio_set(r->ring, &value, out);
    if (ok) ttc_ratio_derive(r->ring, out, &value, slopes);
    ttc_ratio_clear(r->ring, &value);
    free_ratios(r->ring, slopes, count);
    return ok;
}

static bool reads_what_is_not_given(const ttc_program *program, const ttc_function_reading *r)
{
    for (size_t i = 0; i < ttc_program_size(program); i++) {
        const ttc_instruction *at = ttc_program_at(program, (ttc_value)i);
        if (at->op == TTC_OP_INPUT && at->index < r->input_count && !r->input_is_given[at->index]) return true;
        if (at->op == TTC_OP_PARAMETER && at->index < r->parameter_count && !r->is_given[at->index]) return true;
    }
    return false;
}

/* What the function must compute: outputs one by one, or the coefficients of a polynomial in a symbol. */
typedef struct {
    const ttc_function_output *outputs;
    size_t count;
    bool is_polynomial;
    ttc_id polynomial;
    uint32_t symbol;
} expectation;

static void refute(ttc_proof *proof, ttc_ring *ring, const ttc_ratio *difference, size_t output)
{
    char *value = ttc_ratio_text(ring, difference);
    settle_as(proof, TTC_REFUTED, "output %zu, function - record = %.4000s", output, value == NULL ? "" : value);
    free(value);
}

static bool compare_outputs(ttc_proof *proof, ttc_function_reading *r, const ttc_ratio *found, const expectation *e)
{
    ttc_ratio table;
    bool ok = true;
    ttc_ratio_init(r->ring, &table);
    for (size_t i = 0; ok && i < e->count && proof->status == TTC_PROVED && r->ring->status == TTC_RING_OK; i++) {
        ok = find_expected(r, &table, &e->outputs[i]);
        ttc_ratio_subtract(r->ring, &table, &found[i], &table);
        if (ok && r->ring->status == TTC_RING_OK && !ttc_ratio_is_zero(r->ring, &table)) refute(proof, r->ring, &table, i);
    }
    ttc_ratio_clear(r->ring, &table);
    return ok;
}

static void compare_polynomial(ttc_proof *proof, ttc_function_reading *r, const ttc_ratio *found, const expectation *e)
{
    ttc_ratio sum, variable;
    ttc_ratio_init(r->ring, &sum);
    ttc_ratio_init(r->ring, &variable);
    ttc_evaluate(r->valuation, &variable, r->model->symbols[e->symbol].node);
    ttc_ratio_set_integer(r->ring, &sum, 0);
    for (size_t i = 0; i < e->count; i++) {
        ttc_ratio_multiply(r->ring, &sum, &sum, &variable);
        ttc_ratio_add(r->ring, &sum, &sum, &found[i]);
    }
    ttc_evaluate(r->valuation, &variable, e->polynomial);
    ttc_ratio_subtract(r->ring, &sum, &sum, &variable);
    if (r->ring->status == TTC_RING_OK && !ttc_ratio_is_zero(r->ring, &sum)) refute(proof, r->ring, &sum, 0);
    ttc_ratio_clear(r->ring, &variable);
    ttc_ratio_clear(r->ring, &sum);
}

static bool compare(ttc_proof *proof, ttc_function_reading *r, const ttc_program *program, const expectation *e)
{
    ttc_ratio *found = make_ratios(r->ring, e->count);
    bool ok = found != NULL
              && ttc_program_read(program, r->valuation, r->inputs, r->input_count, r->parameters, r->parameter_count, found);
    if (ok && !e->is_polynomial) ok = compare_outputs(proof, r, found, e);
    else if (ok) compare_polynomial(proof, r, found, e);
    free_ratios(r->ring, found, e->count);
    if (r->ring->status != TTC_RING_OK) settle_as(proof, TTC_UNSETTLED, "%s", ttc_ring_status_text(r->ring->status));
    else if (r->ring->choice_count > 0) settle_as(proof, TTC_UNSETTLED, "a root becomes rational with either sign");
    return ok;
}

static bool check(ttc_proof *proof, const char *text, const char *name, ttc_function_reading *reading, const expectation *e)
{
    ttc_program *program;
    const ttc_function_status status = ttc_function_read(&program, text, name, e->count);
    bool ok = status != TTC_FUNCTION_NO_MEMORY;
    proof->status = TTC_PROVED;
    if (status == TTC_FUNCTION_ABSENT) settle_as(proof, TTC_REFUTED, "there is no function %s of the form that is read", name);
    else if (status == TTC_FUNCTION_ROUNDED)
        settle_as(proof, TTC_UNSETTLED, "a constant of %s is written as a rounded number", name);
    else if (ok && reads_what_is_not_given(program, reading))
        settle_as(proof, TTC_REFUTED, "%s reads an entry that has no meaning", name);
    else if (ok) ok = compare(proof, reading, program, e);
    ttc_program_destroy(program);
    return ok;
}

bool ttc_function_check(ttc_proof *proof, const char *text, const char *name, ttc_function_reading *reading,
                        const ttc_function_output *expected, size_t count)
{
    return check(proof, text, name, reading, &(expectation){ .outputs = expected, .count = count });
}

bool ttc_function_check_polynomial(ttc_proof *proof, const char *text, const char *name, ttc_function_reading *reading,
                                   ttc_id polynomial, uint32_t symbol, size_t count)
{
    return check(proof, text, name, reading,
                 &(expectation){ .count = count, .is_polynomial = true, .polynomial = polynomial, .symbol = symbol });
}
