#include "dynamics/failures.h"

void jlt_failures_add(jlt_failures *sum, jlt_fate fate, unsigned unbounded, double t)
{
    sum->spent += fate == JLT_FATE_BUDGET;
    if (!jlt_section_failed(fate)) return;
    const bool is_known = unbounded < JLT_CHART_STATES_MAX;
    jlt_failures_join(sum, &(jlt_failures){ .count = 1, .unbounded = is_known, .state = unbounded, .t = t });
}

void jlt_failures_join(jlt_failures *sum, const jlt_failures *more)
{
    if (sum->unbounded == 0) {
        sum->state = more->state;
        sum->t = more->t;
    }
    sum->count += more->count;
    sum->spent += more->spent;
    sum->unbounded += more->unbounded;
}
