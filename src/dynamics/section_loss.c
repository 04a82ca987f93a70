#include "dynamics/section_loss.h"

#include <math.h>

jlt_status jlt_section_loss(jlt_return *at, const jlt_flow *flow, const double *points, size_t count, size_t returns)
{
    JLT_OWNED(jlt_section) *section = NULL;

    at->least = INFINITY;
    if (flow->observed == NULL || jlt_observed_conditions(flow->observed) == 0) return JLT_OK;
    JLT_PASS(jlt_section_create(&section, flow));
    for (size_t i = 0; i < count && !(at->least <= 0); i++) {
        JLT_PASS(jlt_section_start(section, at, points + i * flow->chart->dim, 1));
        while (at->number < returns && at->fate == JLT_FATE_ALIVE && !at->interrupted && !(at->least <= 0))
            JLT_PASS(jlt_section_next(section, at));
    }
    return JLT_OK;
}
