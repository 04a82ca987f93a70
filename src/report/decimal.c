#include "report/decimal.h"

#include "core/digits.h"

#include <math.h>

void jlt_decimal_write_named(FILE *stream, const jlt_quantity *quantities, const double *values, size_t count)
{
    char text[JLT_DIGITS_SIZE];

    for (size_t i = 0; i < count; i++) {
        if (isnan(values[i])) continue;
        jlt_digits_shortest(text, values[i]);
        fprintf(stream, " %s=%s", quantities[i].name, text);
    }
}

void jlt_decimal_write_rounded(FILE *stream, const jlt_quantity *quantities, const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        fprintf(stream, "%s%s ", i == 0 ? "" : ", ", quantities[i].name);
        if (isnan(values[i])) fputs("unknown", stream);
        else fprintf(stream, "%.3g", values[i]);
    }
}
