/* Saves the numbers that a test measures: with JLT_TABLES=DIR in the environment it writes DIR/NAME.csv. Otherwise these functions
 * do nothing. */
#ifndef JLT_TESTS_TABLE_H
#define JLT_TESTS_TABLE_H

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

static inline FILE *table_open(const char *name, const char *header)
{
    const char *directory = getenv("JLT_TABLES");
    char path[1024];

    if (directory == NULL) return NULL;
    snprintf(path, sizeof path, "%s/%s.csv", directory, name);
    FILE *file = fopen(path, "w");
    if (file == NULL) return NULL;
    setvbuf(file, NULL, _IOLBF, BUFSIZ); /* rows of a long run can be read while it lasts */
    fprintf(file, "%s\n", header);
    return file;
}

__attribute__((format(printf, 2, 3))) static inline void table_row(FILE *table, const char *format, ...)
{
    va_list arguments;

    if (table == NULL) return;
    va_start(arguments, format);
    vfprintf(table, format, arguments);
    va_end(arguments);
    fputc('\n', table);
}

/* Closes the table that is a group's state: cmocka's teardown of the group. */
static inline int table_close(void **state)
{
    if (*state != NULL) fclose(*state);
    return 0;
}

#endif
