#include "report/decimal.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

void jlt_decimal_text(char *text, double value)
{
    for (int digits = DBL_DIG; digits <= DBL_DECIMAL_DIG; digits++) {
        snprintf(text, JLT_DECIMAL_SIZE, "%.*g", digits, value);
        if (!(strtod(text, NULL) < value) && !(strtod(text, NULL) > value)) return;
    }
}

void jlt_decimal_write_named(FILE *stream, const jlt_quantity *quantities, const double *values, size_t count)
{
    char text[JLT_DECIMAL_SIZE];

    for (size_t i = 0; i < count; i++) {
        if (isnan(values[i])) continue;
        jlt_decimal_text(text, values[i]);
        fprintf(stream, " %s=%s", quantities[i].name, text);
    }
}
