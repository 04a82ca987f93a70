#include "report/csv.h"

#include "core/digits.h"
#include "report/decimal.h"

#include <math.h>

void jlt_csv_header(FILE *stream, const char *command, const jlt_descriptor *descriptor, const double *params)
{
    if (command != NULL) fprintf(stream, "# command: %s\n", command);
    fprintf(stream, "# jellett %s, kernels of %s", JLT_VERSION, descriptor->model);
    if (descriptor->variant[0] != '\0') fprintf(stream, ", variant %s", descriptor->variant);
    if (descriptor->time[0] != '\0') fprintf(stream, ", time %s", descriptor->time);
    if (descriptor->elimination[0] != '\0') fprintf(stream, ", %s", descriptor->elimination);
    fprintf(stream, " (table %s, %s)\n#", descriptor->sha256, descriptor->generator);
    jlt_decimal_write_named(stream, descriptor->params, params, descriptor->param_count);
    fputc('\n', stream);
}

void jlt_csv_value(FILE *stream, double value)
{
    char text[JLT_DIGITS_SIZE];

    if (!isfinite(value)) return;
    jlt_digits_shortest(text, value);
    fputs(text, stream);
}

void jlt_csv_values(FILE *stream, const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (i > 0) fputc(',', stream);
        jlt_csv_value(stream, values[i]);
    }
}

void jlt_csv_more(FILE *stream, const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        fputc(',', stream);
        jlt_csv_value(stream, values[i]);
    }
}

void jlt_csv_row(FILE *stream, const double *values, size_t count)
{
    jlt_csv_values(stream, values, count);
    fputc('\n', stream);
}
