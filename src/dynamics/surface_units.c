#include "dynamics/surface_units.h"

#include <math.h>
#include <string.h>

enum { SOME = 256 };

jlt_units jlt_surface_units_of(const jlt_chart_section *chart)
{
    const jlt_descriptor *table = chart->table;
    const size_t all = jlt_chart_section_points(chart, 8), probes = jlt_chart_section_probes(chart, 8);
    double largest[JLT_CHART_STATES_MAX] = { 0 };
    jlt_units units = { 0 };
    bool seen = false;

    for (size_t i = 0; i < probes && !(seen && i >= (all < SOME ? all : SOME)); i++) {
        double q[JLT_CHART_COORDINATES_MAX], x[JLT_CHART_STATES_MAX];
        jlt_chart_section_probe(chart, q, i, 8);
        if (!jlt_chart_section_holds(chart, q)) continue;
        chart->section->lift(q, chart->values, x);
        x[chart->base.column] = chart->base.level;
        seen = true;
        for (unsigned k = 0; k < chart->base.states; k++)
            if (isfinite(x[k])) largest[k] = fmax(largest[k], fabs(x[k]));
    }
    jlt_units_of_sizes(&units, chart->values, table->params, table->param_count, largest, table->states, chart->base.states);
    jlt_units_of_rate(&units, jlt_units_rate(&units, largest, table->states, chart->base.states, 0));
    return units;
}

bool jlt_surface_units_named(const jlt_section_chart *section)
{
    for (unsigned k = 0; k < section->coordinate_count; k++)
        if (jlt_units_exponent(&(jlt_units){ 1, 1 << 8, 1 << 16 }, section->coordinates[k].unit) != 0) return true;
    return false;
}

bool jlt_surface_units_at(jlt_units *out, const jlt_chart_section *chart, const double *points, size_t count)
{
    double x[JLT_CHART_STATES_MAX], largest[JLT_CHART_STATES_MAX] = { 0 };
    bool found = false;
    const size_t all = count > 0 ? count : jlt_chart_section_points(chart, 8);

    if (!chart->table->scales || !jlt_surface_units_named(chart->section)) return false;
    for (size_t i = 0; i < all; i++) {
        double q[JLT_CHART_COORDINATES_MAX];
        if (count > 0) memcpy(q, points + i * chart->base.dim, chart->base.dim * sizeof *q);
        else jlt_chart_section_point(chart, q, i, 8);
        if (chart->base.lift(&chart->base, x, NULL, q) != JLT_OK) continue;
        for (unsigned k = 0; k < chart->plain; k++) largest[k] = fmax(largest[k], fabs(x[k]));
        found = true;
    }
    return found && jlt_instance_units(out, chart->table->family[0], chart->values, largest) == JLT_OK;
}
