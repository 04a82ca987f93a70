/** A table as a structured array of NumPy, format 1.0 or 2.0 of NEP 1: numbers are '<f8', NaN where a field is empty, texts 'S' of
 *  a width that is a multiple of eight. numpy.load reads it, also with mmap_mode='r'; comments follow the array, as text. */
#ifndef JLT_REPORT_NPY_H
#define JLT_REPORT_NPY_H

#include "report/file.h"

typedef struct jlt_npy jlt_npy;

/** Begin an array in `place`, a file that is moved into place at its end; the structure must not move. Whenever a call returns, the
 *  file could be committed with the rows so far. Which kind a column has shows in its fields: where a text comes after rows that
 *  had none, or a longer one than before, these rows are written again. Errors: NOMEM; UNSUPPORTED, a device. */
JLT_CHECKED jlt_status jlt_npy_create(jlt_npy **out, jlt_file *place);
void jlt_npy_destroy(jlt_npy *self); /* NULL is legal; the file is not committed after that */

/** Take the next bytes of the table in CSV, cut anywhere: comments, names of columns, rows, more comments. Errors: NOMEM; IO
 *  (errno says why); ARG, a row has not as many fields as there are columns: then nothing is committed. */
JLT_CHECKED jlt_status jlt_npy_take(jlt_npy *self, const char *text, size_t size);

/** Take one row by its fields, as many as there are columns. It is in the file after jlt_npy_flush at the latest. Errors: NOMEM,
 *  IO. */
JLT_CHECKED jlt_status jlt_npy_row(jlt_npy *self, char *const *fields);
JLT_CHECKED jlt_status jlt_npy_flush(jlt_npy *self);

#endif
