#include "shards/table.h"

#include <math.h>
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

jlt_status jlt_table_form_open(jlt_table_form *self, char *const *names, size_t count)
{
    *self = (jlt_table_form){ .columns = calloc(count + 1, sizeof *self->columns) };
    if (self->columns == NULL) return JLT_ERR_NOMEM;
    for (; self->count < count; self->count++) {
        jlt_table_column *column = &self->columns[self->count];
        for (size_t i = 0; i < self->count; i++)
            if (strcmp(self->columns[i].name, names[self->count]) == 0) return JLT_ERR_ARG;
        *column = (jlt_table_column){ .name = strdup(names[self->count]), .width = 1 };
        if (column->name == NULL) return JLT_ERR_NOMEM;
    }
    return JLT_OK;
}

void jlt_table_form_close(jlt_table_form *self)
{
    for (size_t i = 0; i < self->count; i++) free(self->columns[i].name);
    free(self->columns);
    *self = (jlt_table_form){ .columns = NULL };
}

/* Numbers begin as decimals do: words that strtod knows, such as nan, name something here. */
bool jlt_table_number(double *value, const char *field)
{
    char *end;

    *value = NAN;
    if (*field == '\0') return true;
    if (strchr("-.0123456789", *field) == NULL) return false;
    if (field[0] == '-' && field[1] != '.' && (field[1] < '0' || field[1] > '9')) return false;
    *value = strtod(field, &end);
    return *end == '\0';
}

void jlt_table_form_see(jlt_table_form *self, char *const *fields)
{
    double value;

    self->rows++;
    for (size_t i = 0; i < self->count; i++) {
        jlt_table_column *column = &self->columns[i];
        const size_t width = strlen(fields[i]);
        if (width > column->width) column->width = width;
        if (!column->is_text && !jlt_table_number(&value, fields[i])) column->is_text = true;
    }
}
