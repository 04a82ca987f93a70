#include "report/decimal.h"

#include "core/digits.h"

#include <float.h>
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

void jlt_decimal_write_error(FILE *stream, double error)
{
    const double least = fmax(error, DBL_MIN);
    char text[JLT_DIGITS_SIZE];

    if (!(error > 0)) {
        fputs(isnan(error) ? "or near it" : "exactly", stream);
        return;
    }
    if (isfinite(error)) {
        const int exponent = (int)floor(log10(least)) - 1;
        const double digits = floor(least / pow(10, exponent) * (1 + 4 * DBL_EPSILON)) + 1;
        const int count = snprintf(text, sizeof text, "%.0fe%d", digits, exponent);
        (void)jlt_digits_read(&error, text, text + count);
    }
    jlt_digits_shortest(text, error);
    fprintf(stream, "error < %s", text);
}
