/** JSON for programs: numbers that read back bit for bit, keys in the order in which they are set. */
#ifndef JLT_REPORT_JSON_H
#define JLT_REPORT_JSON_H

#include "core/status.h"
#include "kernel_abi.h"

#include <jansson.h>
#include <stdio.h>

/* A new reference to a real, or to null for NaN and infinities. NULL, here and below: memory is out. */
json_t *jlt_json_number(double value);

/* New references to an array of numbers, values (count,); to an array of rows, values (rows, columns); to an object with the names
 * of `quantities` as keys. */
json_t *jlt_json_numbers(const double *values, size_t count);
json_t *jlt_json_matrix(const double *values, size_t rows, size_t columns);
json_t *jlt_json_named(const jlt_quantity *quantities, const double *values, size_t count);

/* A new reference to a string, or to null for NULL. */
json_t *jlt_json_string(const char *text);

/** The text of a value, in a form of jansson, such as JSON_COMPACT; reals have the fewest digits that read back. Takes over the
 *  reference; the caller frees the text. NULL: memory is out, or `value` is NULL. */
char *jlt_json_text(json_t *value, size_t form);

/** Write to a stream in memory, indented by two, with a newline at the end. Takes over the reference.
 *  Errors: NOMEM, also when `value` is NULL. */
JLT_CHECKED jlt_status jlt_json_write(FILE *stream, json_t *value);

#endif
