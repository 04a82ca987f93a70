/** Writing numbers and expressions, as C or as formulas for readers. */
#ifndef TTC_FORMULA_H
#define TTC_FORMULA_H

#include "base/text.h"
#include "fields/field.h"

/* Returns true if the rational rounds to a normal double, or is zero. */
bool ttc_constant_fits(const fmpq_t value);

/** Write a rational as a C expression whose value is the nearest double: an integer of up to 53 bits as it is, a quotient of
 *  two such integers as a division, which compilers fold with one rounding, other numbers as hexadecimal constants.
 *  Marks the text as failed if such a constant is not a normal double. */
void ttc_emit_constant(ttc_text *text, const fmpq_t value);

/* Writes a symbol. */
typedef void (*ttc_symbol_writer)(void *context, ttc_text *text, uint32_t symbol);

/** Write an expression in C syntax, with powers as repeated products and numbers as doubles. */
void ttc_emit_expression(ttc_text *text, const ttc_graph *graph, ttc_id id, ttc_symbol_writer symbol, void *context);

/** Write an expression for readers: numbers as exact integers and quotients, powers with ^. */
void ttc_emit_formula(ttc_text *text, const ttc_graph *graph, ttc_id id, ttc_symbol_writer symbol, void *context);

/* A ttc_symbol_writer that writes the name of a field's symbol; context: the field. */
void ttc_emit_symbol_name(void *context, ttc_text *text, uint32_t symbol);

/* Write bindings as `NAME = expression, ...`. */
void ttc_emit_condition(ttc_text *text, ttc_field *field, const ttc_bindings *bindings);

#endif
