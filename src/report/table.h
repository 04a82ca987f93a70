/** Rows of text as one table: their fields, and what kind of column each is in. */
#ifndef JLT_REPORT_TABLE_H
#define JLT_REPORT_TABLE_H

#include <stdbool.h>
#include <stddef.h>

#include "core/status.h"

typedef struct {
    char *name;
    bool is_text; /* it has a field that is neither empty nor a number */
    size_t width; /* bytes of its texts in an array */
} jlt_table_column;

typedef struct {
    jlt_table_column *columns; /* shape (count,) */
    size_t count, rows;
} jlt_table_form;

/** Cut a line at its commas, which become NULs. fields, shape (room,). Returns how many there are, also beyond `room`. */
size_t jlt_table_cut(char **fields, size_t room, char *line);

/** Take these names for the columns; one that is there already, as `compare` has it (strcmp, strcasecmp), becomes NAME_2, or with
 *  the next number that is free. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_table_form_open(jlt_table_form *self, char *const *names, size_t count,
                                           int (*compare)(const char *, const char *));
void jlt_table_form_close(jlt_table_form *self); /* legal when zeroed */

/** Look at the fields of a row, shape (count,), and learn the kinds and widths of the columns from them. */
void jlt_table_form_see(jlt_table_form *self, char *const *fields);

/** Where a field ends: at a comma, or with the text. */
const char *jlt_table_field_end(const char *field);

/** A field as a number; NaN for an empty one. False: it is none. In: end, where it ends. */
bool jlt_table_number(double *value, const char *field, const char *end);

#endif
