#include "report/json.h"

#include <math.h>
#include <stdbool.h>

json_t *jlt_json_number(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

json_t *jlt_json_numbers(const double *values, size_t count)
{
    json_t *array = json_array();

    for (size_t i = 0; array != NULL && i < count; i++)
        if (json_array_append_new(array, jlt_json_number(values[i])) != 0) {
            json_decref(array);
            array = NULL;
        }
    return array;
}

json_t *jlt_json_matrix(const double *values, size_t rows, size_t columns)
{
    json_t *array = json_array();

    for (size_t i = 0; array != NULL && i < rows; i++)
        if (json_array_append_new(array, jlt_json_numbers(values + i * columns, columns)) != 0) {
            json_decref(array);
            array = NULL;
        }
    return array;
}

json_t *jlt_json_named(const jlt_quantity *quantities, const double *values, size_t count)
{
    json_t *object = json_object();

    for (size_t i = 0; object != NULL && i < count; i++)
        if (json_object_set_new(object, quantities[i].name, jlt_json_number(values[i])) != 0) {
            json_decref(object);
            object = NULL;
        }
    return object;
}

json_t *jlt_json_string(const char *text)
{
    return text == NULL ? json_null() : json_string(text);
}

jlt_status jlt_json_write(FILE *stream, json_t *value)
{
    const bool written = value != NULL && json_dumpf(value, stream, JSON_INDENT(2) | JSON_REAL_PRECISION(17)) == 0;

    json_decref(value);
    return written && fputc('\n', stream) != EOF ? JLT_OK : JLT_ERR_NOMEM;
}
