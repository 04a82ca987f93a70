/** Compares one function of emitted C with expressions of a table. Used by prove_functions.c. */
#ifndef TTC_FUNCTION_CHECK_H
#define TTC_FUNCTION_CHECK_H

#include "algebra/valuation.h"
#include "prove/prove.h"

/* What x[i] and params[i] stand for, in one ring. */
typedef struct {
    const ttc_model *model;
    ttc_valuation *valuation;
    ttc_ring *ring;
    ttc_ratio *inputs, *parameters;
    size_t input_count, parameter_count;
    unsigned char *input_is_given, *is_given; /* by input and parameter: 0 if no symbol of the model has this place, or if that
                                                 symbol is bound */
} ttc_function_reading;

/* Expressions that replace symbols: lists used together. */
typedef struct {
    const ttc_bindings *lists[2];
    size_t count;
} ttc_function_bound;

/** inputs: symbols, shape (input_count,), of states, then of roots that a time lifts; with lifted_free these are coordinates of
 *  their own. parameters: symbols by place, shape (parameter_count,); UINT32_MAX: none. bound: NULL for none. Returns false when
 *  memory is out; close the reading in any case. */
bool ttc_function_reading_open(ttc_function_reading *out, const ttc_model *model, const uint32_t *inputs, size_t input_count,
                               const uint32_t *parameters, size_t parameter_count, bool lifted_free,
                               const ttc_function_bound *bound);
void ttc_function_reading_close(ttc_function_reading *reading); /* legal on a zeroed one */

/* An output: the value of an expression of the model, or its derivative by a symbol. */
typedef struct {
    ttc_id value;
    uint32_t by; /* UINT32_MAX: none */
} ttc_function_output;

/** Compare the function `name` of the text with `expected`, shape (count,); fill status and remainder of *proof. Returns false
 *  when memory is out. */
bool ttc_function_check(ttc_proof *proof, const char *text, const char *name, ttc_function_reading *reading,
                        const ttc_function_output *expected, size_t count);

/** The same for the coefficients of a polynomial in a symbol, the highest power first, shape (count,). */
bool ttc_function_check_polynomial(ttc_proof *proof, const char *text, const char *name, ttc_function_reading *reading,
                                   ttc_id polynomial, uint32_t symbol, size_t count);

#endif
