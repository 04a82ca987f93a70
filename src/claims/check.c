#include "claims/check.h"

#include <math.h>
#include <string.h>

/* The factor of rounding errors where products, or cosines of sums of up to eight angles, are multiplied out. */
static const double expanded = 16.0;

jlt_verify_check *jlt_check_named(jlt_verify_family *f, const char *name, const char *bound)
{
    for (size_t i = 0; i < f->check_count; i++)
        if (strcmp(f->checks[i].name, name) == 0) return &f->checks[i];
    if (f->check_count == JLT_VERIFY_CHECKS_MAX) return &f->checks[JLT_VERIFY_CHECKS_MAX - 1];
    f->checks[f->check_count] = (jlt_verify_check){ .name = name, .bound = bound };
    return &f->checks[f->check_count++];
}

void jlt_check_add(jlt_verify_check *check, double error, double value, double size, double bound)
{
    /* Kernels refuse results below the normal range, so rounding there is at most one subnormal, 2^-1074. */
    const double ratio = error == 0.0 ? 0.0 : error / (bound + 0x1p-1074), part = isnan(ratio) ? INFINITY : ratio;
    const double ulp = size * jlt_roundoff + 0x1p-1074;

    check->compared++;
    if (value != 0.0 && size > fabs(value)) check->lost = fmax(check->lost, log10(size / fabs(value)));
    if (part <= check->worst_part && check->bound_ulp > 0.0) return;
    check->worst_part = part;
    check->error_ulp = error / ulp;
    check->bound_ulp = bound / ulp;
}

double jlt_check_running(double rounding, const ttc_enclosure *exact)
{
    return rounding + jlt_roundoff * fabs(exact->value);
}

void jlt_check_enclosures(jlt_verify_family *f, const char *name, const double *computed, const ttc_enclosure *exact,
                               size_t count)
{
    jlt_verify_check *check = jlt_check_named(
        f, name,
        f->expands
            ? "16 times the running error of the expression as written (53-bit balls), values rounded once, and a rounding"
            : "4 times the running error of the expression as written (53-bit balls), and a rounding");

    for (size_t i = 0; i < count; i++) {
        const double size = jlt_check_running(f->expands ? exact[i].plain_rounding : exact[i].rounding, &exact[i]);
        jlt_check_add(check, jlt_oracle_error(computed[i], &exact[i]), exact[i].value, size / jlt_roundoff,
                              (f->expands ? expanded : jlt_rearranged) * size + exact[i].radius);
    }
}
