/** A table as a structured array of NumPy, format 1.0 or 2.0 of NEP 1: numbers are '<f8', NaN where a field is empty, texts 'S' of
 *  the column's width. numpy.load reads it, and numpy.load(FILE, mmap_mode='r') without taking it into memory. */
#ifndef JLT_SHARDS_NPY_H
#define JLT_SHARDS_NPY_H

#include <stdio.h>

#include "shards/table.h"

/** What stands before the rows. Failures show in ferror(stream). Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_npy_begin(FILE *stream, const jlt_table_form *form);

/** A row, shape (form->count,). Failures show in ferror(stream). */
void jlt_npy_row(FILE *stream, const jlt_table_form *form, char *const *fields);

#endif
