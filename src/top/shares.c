#include "top/shares.h"

void jlt_shares_add(jlt_shares *sum, const jlt_system *system, const double *q, const jlt_fates_end *end)
{
    jlt_fates_add(&sum->all, end);
    if (system->known == NULL) return;
    sum->turned = system->known->turned_at(system);
    if (system->known->is_low(system, q)) jlt_fates_add(&sum->low, end);
}

size_t jlt_shares_failed(const jlt_shares *sum)
{
    size_t count = 0;

    for (int fate = 0; fate < (int)JLT_FATE_COUNT; fate++)
        if (jlt_section_failed((jlt_fate)fate)) count += sum->all.by_fate[fate];
    return count;
}

size_t jlt_shares_held(const jlt_shares *sum)
{
    size_t count = 0;

    for (int fate = 0; fate < (int)JLT_FATE_COUNT; fate++) count += sum->all.valid[fate];
    return count;
}
