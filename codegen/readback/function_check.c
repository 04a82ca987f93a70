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
                               const uint32_t *parameters, size_t parameter_count, bool lifted_free)
{
    ttc_function_reading r = { .model = model, .valuation = ttc_valuation_create(model, 0) };
    *out = r;
    if (r.valuation == NULL) return false;
    r.ring = ttc_valuation_ring(r.valuation);
    for (size_t i = model->state_count; lifted_free && i < input_count; i++) ttc_valuation_free_root(r.valuation, inputs[i]);
    r.inputs = make_ratios(r.ring, r.input_count = input_count);
    r.parameters = make_ratios(r.ring, r.parameter_count = parameter_count);
    r.is_given = calloc(parameter_count + 1, 1);
    *out = r;
    if (r.inputs == NULL || r.parameters == NULL || r.is_given == NULL) return false;
    for (size_t i = 0; i < input_count; i++) ttc_evaluate(r.valuation, &r.inputs[i], model->symbols[inputs[i]].node);
    for (size_t i = 0; i < parameter_count; i++) {
        r.is_given[i] = parameters[i] != UINT32_MAX;
        if (r.is_given[i]) ttc_evaluate(r.valuation, &r.parameters[i], model->symbols[parameters[i]].node);
    }
    return true;
}

void ttc_function_reading_close(ttc_function_reading *r)
{
    if (r->valuation == NULL) return;
    free_ratios(r->ring, r->inputs, r->input_count);
    free_ratios(r->ring, r->parameters, r->parameter_count);
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

/* The rate of each variable where the symbol's grows by 1. All functions count, whether their values were asked for before or not. False:
 * the symbol is no variable. */
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

/* False: memory, or what it is differentiated by is no variable. */
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
        if (at->op == TTC_OP_PARAMETER && at->index < r->parameter_count && !r->is_given[at->index]) return true;
    }
    return false;
}

static bool compare(ttc_proof *proof, ttc_function_reading *r, const ttc_program *program, const ttc_function_output *expected, size_t count)
{
    ttc_ratio *found = make_ratios(r->ring, count), table;
    bool ok = found != NULL && ttc_program_read(program, r->valuation, r->inputs, r->input_count, r->parameters, r->parameter_count, found);
    ttc_ratio_init(r->ring, &table);
    for (size_t i = 0; ok && i < count && proof->status == TTC_PROVED && r->ring->status == TTC_RING_OK; i++) {
        ok = find_expected(r, &table, &expected[i]);
        ttc_ratio_subtract(r->ring, &table, &found[i], &table);
        if (!ok || r->ring->status != TTC_RING_OK || ttc_ratio_is_zero(r->ring, &table)) continue;
        char *value = ttc_ratio_text(r->ring, &table);
        settle_as(proof, TTC_REFUTED, "output %zu, function - record = %.4000s", i, value == NULL ? "" : value);
        free(value);
    }
    ttc_ratio_clear(r->ring, &table);
    free_ratios(r->ring, found, count);
    if (r->ring->status != TTC_RING_OK) settle_as(proof, TTC_UNSETTLED, "%s", ttc_ring_status_text(r->ring->status));
    else if (r->ring->choice_count > 0) settle_as(proof, TTC_UNSETTLED, "a root becomes rational with either sign");
    return ok;
}

bool ttc_function_check(ttc_proof *proof, const char *text, const char *name, ttc_function_reading *reading,
                        const ttc_function_output *expected, size_t count)
{
    ttc_program *program;
    const ttc_function_status status = ttc_function_read(&program, text, name, count);
    bool ok = status != TTC_FUNCTION_NO_MEMORY;
    proof->status = TTC_PROVED;
    if (status == TTC_FUNCTION_ABSENT) settle_as(proof, TTC_REFUTED, "there is no function %s of the form that is read", name);
    else if (status == TTC_FUNCTION_ROUNDED) settle_as(proof, TTC_UNSETTLED, "a constant of %s is written as a rounded number", name);
    else if (ok && reads_what_is_not_given(program, reading)) settle_as(proof, TTC_REFUTED, "%s reads a parameter that has no meaning", name);
    else if (ok) ok = compare(proof, reading, program, expected, count);
    ttc_program_destroy(program);
    return ok;
}
