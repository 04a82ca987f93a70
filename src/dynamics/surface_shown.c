/* What is shown of states of a section that tables describe. */
#include "dynamics/surface.h"

#include <math.h>

#include "kernel/descriptor.h"

static void show(double *out, unsigned count, const jlt_system *system, jlt_kernel_function values, const double *x)
{
    if (count > 0) values(x, jlt_surface_chart(system)->values, out);
    for (unsigned i = 0; i < count; i++)
        if (!isfinite(out[i])) out[i] = NAN;
}

void jlt_surface_beside(double *out, const jlt_system *system, const double *x)
{
    show(out, system->surface->section->beside_count, system, system->surface->section->beside_values, x);
}

void jlt_surface_ending(double *out, const jlt_system *system, const double *x)
{
    show(out, system->surface->section->ending_count, system, system->surface->section->ending_values, x);
}

void jlt_surface_off_section(double *q, const jlt_system *system, const double *x)
{
    const jlt_chart_section *chart = jlt_surface_chart(system);

    chart->base.lower(&chart->base, q, NULL, x);
    for (unsigned k = 0; k < chart->base.dim; k++)
        if (chart->section->is_angle[k]) q[k] = NAN;
}

bool jlt_surface_is_low(const jlt_system *system, const double *q)
{
    const jlt_chart_section *chart = jlt_surface_chart(system);
    double turn = 0;

    if (chart->section->turn != NULL) chart->section->turn(q, chart->values, &turn);
    return turn < 0;
}

/* The pole at which the expression of `turns` is positive: the upper end of the table's first one, or the lower one. */
jlt_fate jlt_surface_turned_at(const jlt_system *system)
{
    const jlt_chart_section *chart = jlt_surface_chart(system);
    double q[JLT_CHART_COORDINATES_MAX], x[JLT_CHART_STATES_MAX] = { 0 };

    if (chart->section->turn == NULL || chart->base.side == NULL) return JLT_FATE_ALIVE;
    const unsigned state = chart->table->poles[0].state;
    for (unsigned k = 0; k < chart->plain; k++) x[k] = 1; /* any state will do, but for the pole's own */
    x[state] = chart->table->states[state].high;
    chart->base.lower(&chart->base, q, NULL, x);
    if (jlt_surface_is_low(system, q)) x[state] = chart->table->states[state].low;
    const int side = chart->base.side(&chart->base, x);
    return side != 0 ? jlt_section_fate_at_pole(side) : JLT_FATE_ALIVE;
}
