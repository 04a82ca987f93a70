#include "dynamics/shares.h"

bool jlt_shares_turn(const jlt_system *system)
{
    const jlt_surface *surface = system->surface;

    return surface != NULL && surface->section->turn != NULL && system->flow.chart->side != NULL
           && surface->asked->family[0]->pole_count > 0;
}

/* The value of the expression of `turns` at q, shape (dim,). */
static double turn_at(const jlt_system *system, const double *q)
{
    double turn;

    system->surface->section->turn(q, jlt_surface_chart(system)->values, &turn);
    return turn;
}

/* Whether an orbit ends at a pole where the expression is positive. Angles, and expressions in them, have no value there. */
static bool has_turned(const jlt_system *system, const jlt_fates_end *end)
{
    double q[JLT_CHART_COORDINATES_MAX];

    if (end->fate != JLT_FATE_POLE_PLUS && end->fate != JLT_FATE_POLE_MINUS) return false;
    jlt_surface_off_section(q, system, end->x);
    return turn_at(system, q) > 0;
}

void jlt_shares_add(jlt_shares *sum, const jlt_system *system, const double *q, const jlt_fates_end *end)
{
    jlt_fates_add(&sum->all, end);
    if (!jlt_shares_turn(system) || !(turn_at(system, q) < 0)) return;
    jlt_fates_add(&sum->low, end);
    if (has_turned(system, end)) jlt_fates_add(&sum->turned, end);
}
