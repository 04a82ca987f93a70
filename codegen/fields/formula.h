/** Numbers and expressions as C, and as formulas for readers. */
#ifndef TTC_FORMULA_H
#define TTC_FORMULA_H

#include "base/text.h"
#include "fields/field.h"

/* True when a rational, rounded, is a normal double or zero. */
bool ttc_constant_fits(const fmpq_t value);

/** An exact rational as a C expression of type double that rounds correctly: an integer below 2^53 as it is, a quotient
 *  of two such as a division, which compilers fold with one rounding, everything else as a hexadecimal constant.
 *  Marks the text failed when the value overflows, or vanishes, in double precision. */
void ttc_emit_constant(ttc_text *text, const fmpq_t value);

/* How a symbol is written. */
typedef void (*ttc_symbol_writer)(void *context, ttc_text *text, uint32_t symbol);

/** An expression in C syntax, powers as repeated products, numbers as doubles. */
void ttc_emit_expression(ttc_text *text, const ttc_graph *graph, ttc_id id, ttc_symbol_writer symbol, void *context);

/** The same for readers: integers as integers, powers with ^. */
void ttc_emit_formula(ttc_text *text, const ttc_graph *graph, ttc_id id, ttc_symbol_writer symbol, void *context);

/* Writes the name of a field's symbol; context: the field. */
void ttc_emit_symbol_name(void *context, ttc_text *text, uint32_t symbol);

/* `NAME = expression, ...` as the table has it. */
void ttc_emit_condition(ttc_text *text, ttc_field *field, const ttc_bindings *bindings);

#endif
