/* Reads tables of reference numbers. */
#ifndef JLT_TESTS_CSV_H
#define JLT_TESTS_CSV_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Read rows of at least `columns` numbers after one header line, from tests/reference/data/NAME. Out: rows, shape (most, columns).
 * Returns the number of rows read, at most `most`; stops at a row with fewer numbers. */
static inline size_t csv_read(double *rows, size_t most, size_t columns, const char *name)
{
    char path[1024], line[2048];
    size_t count = 0;
    snprintf(path, sizeof path, "%s/tests/reference/data/%s", JLT_SOURCE_DIR, name);
    FILE *file = fopen(path, "r");
    if (file == NULL) return 0;
    if (fgets(line, sizeof line, file) != NULL) {
        while (count < most && fgets(line, sizeof line, file) != NULL) {
            char *at = line;
            size_t i = 0;
            for (; i < columns; i++) {
                char *end;
                rows[count * columns + i] = strtod(at, &end);
                if (end == at) break;
                at = *end == ',' ? end + 1 : end;
            }
            if (i < columns) break;
            count++;
        }
    }
    fclose(file);
    return count;
}

#endif
