#include "dynamics/fates.h"

#include <math.h>
#include <string.h>

jlt_status jlt_fates_follow(jlt_section *section, jlt_fates_end *end, const double *q, size_t returns)
{
    jlt_return row;

    JLT_PASS(jlt_section_start(section, &row, q, 1));
    while (row.fate == JLT_FATE_ALIVE && !row.interrupted && row.number < returns) JLT_PASS(jlt_section_next(section, &row));
    *end = jlt_fates_of(&row);
    return JLT_OK;
}

jlt_fates_end jlt_fates_of(const jlt_return *last)
{
    const bool is_return = last->fate == JLT_FATE_ALIVE && !last->interrupted; /* the row of an end has a number of its own */
    jlt_fates_end end = { .fate = last->fate,
                          .unbounded = last->unbounded,
                          .lost = last->lost,
                          .t = last->t,
                          .returns = last->number - (!is_return && last->number > 0),
                          .least = last->least,
                          .interrupted = last->interrupted };

    memcpy(end.x, last->x, sizeof end.x);
    return end;
}

void jlt_fates_add(jlt_fates_count *count, const jlt_fates_end *end)
{
    count->starts++;
    count->by_fate[end->fate]++;
    jlt_failures_add(&count->failures, end->fate, end->unbounded, end->t);
    if (end->least > 0 && end->fate != JLT_FATE_INVALID) count->valid[end->fate]++;
    if (isnan(end->least)) count->unknown++;
}

size_t jlt_fates_held(const jlt_fates_count *count)
{
    size_t held = 0;

    for (int fate = 0; fate < (int)JLT_FATE_COUNT; fate++) held += count->valid[fate];
    return held;
}

void jlt_fates_share(double *share, double *error, size_t number, size_t starts)
{
    const double n = (double)starts, k = (double)number;

    *share = n > 0 ? k / n : NAN;
    *error = n > 0 ? (fabs(n / 2 - k) / n + sqrt(k * (1 - *share) + 1. / 4)) / (n + 1) : NAN;
}
