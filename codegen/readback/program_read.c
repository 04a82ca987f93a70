#include "readback/program_read.h"

#include <stdlib.h>

typedef struct {
    ttc_valuation *valuation;
    ttc_ring *ring;
    const ttc_ratio *inputs, *parameters;
    size_t input_count, parameter_count;
    ttc_ratio *values;
} reader;

static void read_instruction(reader *r, ttc_ratio *out, const ttc_instruction *instruction)
{
    ttc_ring *ring = r->ring;
    const ttc_ratio *a = ttc_op_arity(instruction->op) > 0 ? &r->values[instruction->a] : NULL;
    const ttc_ratio *b = ttc_op_arity(instruction->op) > 1 ? &r->values[instruction->b] : NULL;
    const ttc_ratio *c = ttc_op_arity(instruction->op) > 2 ? &r->values[instruction->c] : NULL;
    switch (instruction->op) {
    case TTC_OP_INPUT:
        if (instruction->index >= r->input_count) ttc_ring_fail(ring, TTC_RING_CIRCULAR);
        else ttc_ratio_set(ring, out, &r->inputs[instruction->index]);
        break;
    case TTC_OP_PARAMETER:
        if (instruction->index >= r->parameter_count) ttc_ring_fail(ring, TTC_RING_CIRCULAR);
        else ttc_ratio_set(ring, out, &r->parameters[instruction->index]);
        break;
    case TTC_OP_CONSTANT: ttc_ratio_set_rational(ring, out, instruction->constant); break;
    case TTC_OP_NEGATE: ttc_ratio_scale(ring, out, a, ring->minus_one); break;
    case TTC_OP_ADD: ttc_ratio_add(ring, out, a, b); break;
    case TTC_OP_SUBTRACT: ttc_ratio_subtract(ring, out, a, b); break;
    case TTC_OP_MULTIPLY: ttc_ratio_multiply(ring, out, a, b); break;
    case TTC_OP_DIVIDE: ttc_ratio_divide(ring, out, a, b); break;
    case TTC_OP_FMA:
        ttc_ratio_multiply(ring, out, a, b);
        ttc_ratio_add(ring, out, out, c);
        break;
    case TTC_OP_FMS:
        ttc_ratio_multiply(ring, out, a, b);
        ttc_ratio_subtract(ring, out, out, c);
        break;
    case TTC_OP_FNMA:
        ttc_ratio_multiply(ring, out, a, b);
        ttc_ratio_subtract(ring, out, c, out);
        break;
    case TTC_OP_ROOT: ttc_ring_root(ring, out, a, -1, true); break;
    case TTC_OP_COSINE: ttc_valuation_angle(r->valuation, out, a, false); break;
    case TTC_OP_SINE: ttc_valuation_angle(r->valuation, out, a, true); break;
    case TTC_OP_EXP: ttc_valuation_exp(r->valuation, out, a); break;
    case TTC_OP_LOG: ttc_valuation_log(r->valuation, out, a); break;
    case TTC_OP_PI: ttc_valuation_pi(r->valuation, out); break;
    }
}

bool ttc_program_read(const ttc_program *program, ttc_valuation *valuation, const ttc_ratio *inputs, size_t input_count,
                      const ttc_ratio *parameters, size_t parameter_count, ttc_ratio *outputs)
{
    size_t size = ttc_program_size(program);
    reader r = { valuation, ttc_valuation_ring(valuation), inputs, parameters, input_count, parameter_count,
                 malloc((size + 1) * sizeof(ttc_ratio)) };
    if (r.values == NULL) return false;
    for (size_t i = 0; i < size; i++) ttc_ratio_init(r.ring, &r.values[i]);
    for (size_t i = 0; i < size && r.ring->status == TTC_RING_OK; i++)
        read_instruction(&r, &r.values[i], ttc_program_at(program, (ttc_value)i));
    for (size_t i = 0; i < ttc_program_output_count(program); i++)
        ttc_ratio_set(r.ring, &outputs[i], &r.values[ttc_program_output_at(program, i)]);
    for (size_t i = 0; i < size; i++) ttc_ratio_clear(r.ring, &r.values[i]);
    free(r.values);
    return true;
}
