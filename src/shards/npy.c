#include "shards/npy.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { ALIGNMENT = 64 };

/* As Python writes it. */
static jlt_status describe(char **text, size_t *size, const jlt_table_form *form)
{
    FILE *stream = open_memstream(text, size);

    if (stream == NULL) return JLT_ERR_NOMEM;
    fputs("{'descr': [", stream);
    for (size_t i = 0; i < form->count; i++) {
        const jlt_table_column *column = &form->columns[i];
        fprintf(stream, "%s('%s', '", i > 0 ? ", " : "", column->name);
        if (column->is_text) fprintf(stream, "|S%zu", column->width);
        else fputs("<f8", stream);
        fputs("')", stream);
    }
    fprintf(stream, "], 'fortran_order': False, 'shape': (%zu,), }", form->rows);
    return fclose(stream) == 0 ? JLT_OK : JLT_ERR_NOMEM;
}

static void put_number(FILE *stream, uint64_t value, unsigned bytes)
{
    for (unsigned i = 0; i < bytes; i++) fputc((int)(value >> (8 * i) & 0xff), stream);
}

jlt_status jlt_npy_begin(FILE *stream, const jlt_table_form *form)
{
    char *text = NULL;
    size_t size = 0;
    const jlt_status st = describe(&text, &size, form);

    if (st == JLT_OK) {
        const unsigned version = size + ALIGNMENT < UINT16_MAX ? 1 : 2, lead = version == 1 ? 10 : 12;
        const size_t whole = (lead + size + 1 + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
        fputs("\x93NUMPY", stream);
        put_number(stream, version, 2);
        put_number(stream, whole - lead, version == 1 ? 2 : 4);
        fputs(text, stream);
        for (size_t i = lead + size; i + 1 < whole; i++) fputc(' ', stream);
        fputc('\n', stream);
    }
    free(text);
    return st;
}

void jlt_npy_row(FILE *stream, const jlt_table_form *form, char *const *fields)
{
    for (size_t i = 0; i < form->count; i++) {
        const jlt_table_column *column = &form->columns[i];
        uint64_t bits;
        double value;
        if (column->is_text) {
            const size_t size = strlen(fields[i]);
            fwrite(fields[i], 1, size, stream);
            put_number(stream, 0, (unsigned)(column->width - size));
        } else {
            (void)jlt_table_number(&value, fields[i]);
            memcpy(&bits, &value, sizeof bits);
            put_number(stream, bits, sizeof bits);
        }
    }
}
