#include "dynamics/shares.h"

bool jlt_shares_turn(const jlt_system *system)
{
    return system->surface != NULL && jlt_surface_turned_at(system) != JLT_FATE_ALIVE;
}

void jlt_shares_add(jlt_shares *sum, const jlt_system *system, const double *q, const jlt_fates_end *end)
{
    jlt_fates_add(&sum->all, end);
    if (!jlt_shares_turn(system)) return;
    sum->turned = jlt_surface_turned_at(system);
    if (jlt_surface_is_low(system, q)) jlt_fates_add(&sum->low, end);
}

size_t jlt_shares_held(const jlt_shares *sum)
{
    size_t count = 0;

    for (int fate = 0; fate < (int)JLT_FATE_COUNT; fate++) count += sum->all.valid[fate];
    return count;
}
