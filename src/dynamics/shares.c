#include "dynamics/shares.h"

bool jlt_shares_turn(const jlt_system *system) { return system->surface != NULL && jlt_surface_turns(system); }

void jlt_shares_add(jlt_shares *sum, const jlt_system *system, const double *q, const jlt_fates_end *end)
{
    const bool at_pole = end->fate == JLT_FATE_POLE_PLUS || end->fate == JLT_FATE_POLE_MINUS;

    jlt_fates_add(&sum->all, end);
    if (!jlt_shares_turn(system) || !jlt_surface_is_low(system, q)) return;
    jlt_fates_add(&sum->low, end);
    if (at_pole && jlt_surface_is_turned(system, end->x)) jlt_fates_add(&sum->turned, end);
}
