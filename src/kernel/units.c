#include "kernel/units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int exponent_of(const jlt_units *units, const char *name, size_t length)
{
    if (length == 2 && strncmp(name, "kg", 2) == 0) return units->mass;
    if (length != 1) return 0;
    return *name == 'm' ? units->length : *name == 's' ? units->time : 0;
}

int jlt_units_exponent(const jlt_units *units, const char *unit)
{
    static const char separators[] = "*/ ";
    int sum = 0;

    for (const char *at = unit; *at != '\0';) {
        const int sign = at > unit && at[-1] == '/' ? -1 : 1;
        const size_t length = strcspn(at, "*/ ^");
        char *end = NULL;
        const long power = at[length] == '^' ? strtol(at + length + 1, &end, 10) : 1;
        sum += sign * (int)power * exponent_of(units, at, length);
        at = end != NULL ? end : at + length;
        if (*at != '\0' && strchr(separators, *at) != NULL) at++;
    }
    return sum;
}

void jlt_units_count(double *out, const double *in, const jlt_quantity *of, unsigned count, const jlt_units *units)
{
    for (unsigned i = 0; i < count; i++) out[i] = ldexp(in[i], -jlt_units_exponent(units, of[i].unit));
}

void jlt_units_restore(double *out, const double *in, const jlt_quantity *of, unsigned count, const jlt_units *units)
{
    for (unsigned i = 0; i < count; i++) out[i] = ldexp(in[i], jlt_units_exponent(units, of[i].unit));
}
