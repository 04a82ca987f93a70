/* Reads reference files, row by row. */
#include "bench.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void jlt_bench_clear(jlt_bench_table *table)
{
    free(table->values);
    *table = (jlt_bench_table){ 0 };
}

/* Read the first `columns` numbers of a line. Returns false if there are fewer. */
static bool read_row(double *row, const char *line, size_t columns)
{
    for (size_t i = 0; i < columns; i++) {
        char *end;
        row[i] = strtod(line, &end);
        if (end == line || (i + 1 < columns && *end != ',')) return false;
        line = end + 1;
    }
    return true;
}

jlt_status jlt_bench_read(jlt_bench_table *table, const char *path, size_t columns)
{
    jlt_status st = JLT_OK;
    char line[1024];
    size_t room = 0;
    FILE *file = fopen(path, "r");

    *table = (jlt_bench_table){ .columns = columns };
    if (file == NULL) return JLT_ERR_IO;
    errno = 0;
    while (fgets(line, sizeof line, file) != NULL) {
        if (strchr("+-0123456789", line[0]) == NULL) continue;
        if (table->rows == room) {
            double *larger = realloc(table->values, (room = 2 * room + 64) * columns * sizeof *larger);
            if (larger == NULL) {
                st = JLT_ERR_NOMEM;
                goto done;
            }
            table->values = larger;
        }
        if (!read_row(table->values + table->rows++ * columns, line, columns)) {
            st = JLT_ERR_ARG;
            goto done;
        }
    }
    st = ferror(file) ? JLT_ERR_IO : table->rows == 0 ? JLT_ERR_ARG : JLT_OK;
done:
    {
        const int reason = errno;
        fclose(file);
        errno = reason;
    }
    if (st != JLT_OK) jlt_bench_clear(table);
    return st;
}

jlt_exit jlt_bench_unread(const char *path, jlt_status status)
{
    if (status == JLT_ERR_IO) return jlt_command_fail(JLT_EXIT_IO, "--reference: cannot read '%s': %s", path, strerror(errno));
    if (status == JLT_ERR_NOMEM) return jlt_command_no_memory();
    return jlt_command_fail(JLT_EXIT_INPUT, "--reference: '%s' is no such table (tests/reference/data has those that are wanted)",
                            path);
}
