#include "report/json.h"

#include "core/digits.h"
#include "core/memory.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

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

/* Copy a JSON text, each real with the fewest digits that read back. */
static void shorten(FILE *stream, const char *text)
{
    for (bool quoted = false; *text != '\0';) {
        char digits[JLT_DIGITS_SIZE];
        double value;
        const size_t span = quoted ? 0 : strspn(text, "0123456789.eE+-");
        if (span > 0 && memchr(text, '.', span) != NULL && jlt_digits_read(&value, text, text + span)) {
            jlt_digits_shortest(digits, value);
            fprintf(stream, "%s%s", digits, strpbrk(digits, ".e") != NULL ? "" : ".0"); /* a real to who reads it */
            text += span;
            continue;
        }
        if (*text == '"') quoted = !quoted;
        if (*text == '\\') fputc(*text++, stream);
        fputc(*text++, stream);
    }
}

char *jlt_json_text(json_t *value, size_t form)
{
    JLT_FREED char *long_text = value != NULL ? json_dumps(value, form | JSON_REAL_PRECISION(17)) : NULL;
    char *text = NULL;
    size_t size;
    FILE *stream = long_text != NULL ? open_memstream(&text, &size) : NULL;

    json_decref(value);
    if (stream == NULL) return NULL;
    shorten(stream, long_text);
    if (fclose(stream) == 0) return text;
    free(text);
    return NULL;
}

jlt_status jlt_json_write(FILE *stream, json_t *value)
{
    JLT_FREED char *text = jlt_json_text(value, JSON_INDENT(2));

    return text != NULL && fprintf(stream, "%s\n", text) >= 0 ? JLT_OK : JLT_ERR_NOMEM;
}
