#include "report/table.h"

#include "core/digits.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

size_t jlt_table_cut(char **fields, size_t room, char *line)
{
    size_t count = 0;

    for (;;) {
        if (count++ < room) fields[count - 1] = line;
        line = strchr(line, ',');
        if (line == NULL) return count;
        *line++ = '\0';
    }
}

const char *jlt_table_field_end(const char *field)
{
    return field + strcspn(field, ",");
}

static bool has_name(const jlt_table_form *self, const char *name, int (*compare)(const char *, const char *))
{
    size_t i = 0;

    while (i < self->count && compare(self->columns[i].name, name) != 0) i++;
    return i < self->count;
}

jlt_status jlt_table_form_open(jlt_table_form *self, char *const *names, size_t count,
                               int (*compare)(const char *, const char *))
{
    *self = (jlt_table_form){ .columns = calloc(count + 1, sizeof *self->columns) };
    if (self->columns == NULL) return JLT_ERR_NOMEM;
    for (; self->count < count; self->count++) {
        const size_t length = strlen(names[self->count]), room = length + 24;
        char *name = malloc(room);
        if (name == NULL) return JLT_ERR_NOMEM;
        memcpy(name, names[self->count], length + 1);
        for (size_t i = 2; has_name(self, name, compare); i++) snprintf(name + length, room - length, "_%zu", i);
        self->columns[self->count] = (jlt_table_column){ .name = name };
    }
    return JLT_OK;
}

void jlt_table_form_close(jlt_table_form *self)
{
    for (size_t i = 0; i < self->count; i++) free(self->columns[i].name);
    free(self->columns);
    *self = (jlt_table_form){ .columns = NULL };
}

/* A number begins with a digit, a point or a minus: words that strtod would accept, such as nan, are texts. */
bool jlt_table_number(double *value, const char *field, const char *end)
{
    const char *first = *field == '-' ? field + 1 : field;

    *value = NAN;
    if (field == end) return true;
    return (*first == '.' || (*first >= '0' && *first <= '9')) && jlt_digits_read(value, field, end);
}

void jlt_table_form_see(jlt_table_form *self, char *const *fields)
{
    double value;

    self->rows++;
    for (size_t i = 0; i < self->count; i++) {
        jlt_table_column *column = &self->columns[i];
        if (!column->is_text && !jlt_table_number(&value, fields[i], jlt_table_field_end(fields[i]))) column->is_text = true;
    }
}
