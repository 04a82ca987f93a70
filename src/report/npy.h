/** Writes a table as a structured NumPy array, format 1.0 or 2.0 of NEP 1: numbers are '<f8', NaN for an empty field; texts are 'S'
 *  with a width that is a multiple of eight. numpy.load reads it, also with mmap_mode='r'; comments follow the array, as text. */
#ifndef JLT_REPORT_NPY_H
#define JLT_REPORT_NPY_H

#include "report/file.h"

typedef struct jlt_npy jlt_npy;

/** Begin an array in `place`, a file from jlt_file_begin, which must not move in memory and which the caller commits. After each
 *  call the file could be committed with the rows so far. A column holds numbers until a field is a text; then, and when a text is
 *  longer than those before, all rows so far are rewritten. Errors: NOMEM; UNSUPPORTED, the file is a device. */
JLT_CHECKED jlt_status jlt_npy_create(jlt_npy **out, jlt_file *place);
void jlt_npy_destroy(jlt_npy *self); /* NULL is legal; the file is not committed after that */

/** Take the next bytes of the table in CSV: comments, names of columns, rows, more comments. The bytes may end within a line.
 *  Numbers may be bits (jlt_csv_bits), also beside others.
 *  Errors: NOMEM; IO (errno says why); ARG, a row does not have one field for each column, or rows are too long: then
 *  jlt_file_commit fails. */
JLT_CHECKED jlt_status jlt_npy_take(jlt_npy *self, const char *text, size_t size);

#endif
