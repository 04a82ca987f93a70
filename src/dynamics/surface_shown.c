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

bool jlt_surface_turns(const jlt_system *system)
{
    const jlt_chart_section *chart = jlt_surface_chart(system);

    return chart->section->turn != NULL && chart->base.side != NULL && system->surface->asked->family[0]->pole_count > 0;
}

/* The value of the expression of `turns`. */
static double turn_at(const jlt_system *system, const double *q)
{
    const jlt_chart_section *chart = jlt_surface_chart(system);
    double turn;

    chart->section->turn(q, chart->values, &turn);
    return turn;
}

bool jlt_surface_is_low(const jlt_system *system, const double *q) { return turn_at(system, q) < 0; }

bool jlt_surface_is_turned(const jlt_system *system, const double *x)
{
    double q[JLT_CHART_COORDINATES_MAX];

    jlt_surface_off_section(q, system, x);
    return turn_at(system, q) > 0;
}
