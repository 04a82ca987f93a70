/** Tables as text: cutting rows into fields, and finding which columns are texts and which numbers. */
#ifndef JLT_REPORT_TABLE_H
#define JLT_REPORT_TABLE_H

#include <stdbool.h>
#include <stddef.h>

#include "core/status.h"

typedef struct {
    char *name;
    bool is_text; /* it has a field that is neither empty nor a number */
    size_t width; /* bytes of a text column's fields in a NumPy array; set by report/npy.c */
} jlt_table_column;

typedef struct {
    jlt_table_column *columns; /* shape (count,) */
    size_t count, rows;
} jlt_table_form;

/** Cut a line at its commas, which become NULs. Out: fields, shape (room,). Returns the number of fields, which may exceed
 *  `room`. */
size_t jlt_table_cut(char **fields, size_t room, char *line);

/** Name the columns. A name that `compare` (strcmp, strcasecmp) finds equal to an earlier one becomes NAME_2, or NAME_K with the
 *  least free K. Errors: NOMEM; close the form also then. */
JLT_CHECKED jlt_status jlt_table_form_open(jlt_table_form *self, char *const *names, size_t count,
                                           int (*compare)(const char *, const char *));
void jlt_table_form_close(jlt_table_form *self); /* legal when zeroed */

/** Count a row, and mark as text each column whose field in it, of fields (count,), is neither empty nor a number. */
void jlt_table_form_see(jlt_table_form *self, char *const *fields);

/** The end of a field: its comma, or the end of the text. */
const char *jlt_table_field_end(const char *field);

/** Read the field that extends to `end` as a number; an empty one is NaN. Returns false if it is not a number. */
bool jlt_table_number(double *value, const char *field, const char *end);

#endif
